#!/usr/bin/env python3
"""Checks that every path and link in README.md and docs/ exists, and that the programs they show are the tested ones. One line for
each fault."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATH = re.compile(r"`((?:schemes|reference|benchmarks|reports|tests|docs|cmake)/[^`\s*]*)`")
CODE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((?!https?:)([^)#]+)(?:#[^)]*)?\)")


def exists(name):
    """Whether the name is a file, a folder, or a file name without its extension."""
    path = ROOT / name
    return path.exists() or any(path.parent.glob(path.name + ".*"))


def programs():
    """Pairs of a page and a program that it contains in full."""
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
