#!/usr/bin/env python3
"""Every path that README.md and docs/ name, and every link, leads to something; the programs that they show are those that
are tested. One line for each fault."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATH = re.compile(r"`((?:schemes|reference|benchmarks|reports|tests|docs|cmake)/[^`\s*]*)`")
CODE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((?!https?:)([^)#]+)(?:#[^)]*)?\)")


def exists(name):
    """A file, a folder, or files of that name with the extensions left out."""
    path = ROOT / name
    return path.exists() or any(path.parent.glob(path.name + ".*"))


def programs():
    """Pages, and the programs that they show whole."""
    yield "README.md", ROOT / "tests/embedding/relaxes.cpp"
    for program in (ROOT / "docs/examples/outside").glob("*.cpp"):
        yield "docs/library.md", program


def faults():
    for page in [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]:
        text = CODE.sub("", page.read_text())
        named = [name for name in PATH.findall(text) if not exists(name)]
        linked = [name for name in LINK.findall(text) if not (page.parent / name).exists()]
        yield from (f"{page.relative_to(ROOT)}: there is no {name}" for name in named + linked)
    for page, program in programs():
        if program.read_text() not in (ROOT / page).read_text():
            yield f"{page}: its program is not that of {program.relative_to(ROOT)}"


found = list(faults())
print(*(found or ["every path and link leads somewhere, and the programs that are shown are tested"]), sep="\n")
sys.exit(bool(found))
