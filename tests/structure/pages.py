#!/usr/bin/env python3
"""Every path that README.md and docs/ name, and every link, leads to something; the README's program is the one that is
tested. One line for each fault."""

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


def faults():
    for page in [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]:
        text = CODE.sub("", page.read_text())
        named = [name for name in PATH.findall(text) if not exists(name)]
        linked = [name for name in LINK.findall(text) if not (page.parent / name).exists()]
        yield from (f"{page.relative_to(ROOT)}: there is no {name}" for name in named + linked)
    program = "tests/embedding/relaxes.cpp"
    if (ROOT / program).read_text() not in (ROOT / "README.md").read_text():
        yield f"README.md: its program is not that of {program}"


found = list(faults())
print(*(found or ["every path and link leads somewhere, and the README's program is tested"]), sep="\n")
sys.exit(bool(found))
