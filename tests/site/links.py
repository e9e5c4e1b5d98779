#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""links.py SITE: every link of every page of a site leads to a file of the site, and to an anchor where it names one; no page takes
anything from elsewhere. One line for each fault."""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag

ELSEWHERE = re.compile(r"(?:[a-z]+:)?//|mailto:|data:|javascript:")
LOADED = {"link": "href", "script": "src", "img": "src", "iframe": "src", "source": "src", "object": "data"}
LOADED_BY_STYLE = re.compile(r"(?:@import\s+[\"']?|url\([\"']?)(?:https?:)?//")
MADE_BY_SCRIPT = "?"  # the sections of the map


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loaded = set(), [], []
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given.get("id"), given.get("name")}
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if given.get(LOADED.get(tag)) and given.get("rel") != "canonical":
            self.loaded.append(given[LOADED[tag]])


def faults(site):
    pages = {path: Page(path) for path in site.rglob("*.html")}
    for path, page in pages.items():
        name = path.relative_to(site)
        base = site if name.name == "404.html" else path.parent
        for link in page.loaded:
            if ELSEWHERE.match(link) and not link.startswith("data:"):
                yield f"{name}: loads {link} from elsewhere"
        for link in page.links + page.loaded:
            if ELSEWHERE.match(link):
                continue
            target, anchor = map(unquote, urldefrag(link))
            linked = (base / target.removeprefix("/")).resolve() if target else path
            linked = linked / "index.html" if linked.is_dir() else linked
            if not linked.is_file():
                yield f"{name}: {link} leads nowhere"
            elif linked in pages and anchor and not anchor.startswith(MADE_BY_SCRIPT) and anchor not in pages[linked].anchors:
                yield f"{name}: {link}: there is no such anchor"
    for style in site.rglob("*.css"):
        if LOADED_BY_STYLE.search(style.read_text()):
            yield f"{style.relative_to(site)}: loads from elsewhere"


if __name__ == "__main__":
    found = list(faults(Path(sys.argv[1]).resolve()))
    print(*(found or ["every link leads somewhere, and nothing is loaded from elsewhere"]), sep="\n")
    sys.exit(bool(found))
