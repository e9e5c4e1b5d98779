#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every path that a page or a comment names, and every link of a page, leads to something; the programs that pages show are
those that are tested. One line for each fault."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ["schemes", "reference", "benchmarks", "reports", "python", "tests", "docs", "cmake"]
SOURCES = {".cpp", ".hpp", ".def", ".js", ".mjs", ".py", ".cmake", ".sh", ""}

QUOTED = re.compile(r"`([^`\s]+)`")
CODE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
INLINE_CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
# A file of ours, with or without its folder; or something within one of our folders.
FILE = r"(?<![\w/.*-])(?:[\w.-]+/)*[\w.-]*[\w-]\.(?:cpp|hpp|def|py|js|mjs|md|toml|cmake|sh)(?![\w/*])"
WITHIN = rf"(?<![\w/.*-])(?:{'|'.join(FOLDERS)})/[\w./*-]*[\w*/]"
NAMED = re.compile(f"{FILE}|{WITHIN}")
METAVARIABLE = re.compile(r"(?:^|/)[A-Z]+[./]")  # as in FILE.toml or BUILD/CPackConfig.cmake

C_COMMENT = re.compile(r'^(?:[^"\n]|"(?:[^"\\\n]|\\.)*")*?//(.*)$', re.MULTILINE)
HASH_COMMENT = re.compile(r"(?:^|\s)#(.*)$", re.MULTILINE)
DOCSTRING = re.compile(r'"""(.*?)"""', re.DOTALL)


def tracked():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=True)
    return [Path(name) for name in listed.stdout.splitlines() if (ROOT / name).is_file()]


FILES = tracked()
NAMES = {path.name for path in FILES}


def exists(name, folder):
    """A file, a folder or a pattern of them, from the root, one of our folders or that of the text; extensions may be left out, and
    a header may be named as it is included."""
    name = name.removeprefix("fdebench/")
    if "/" not in name and name in NAMES or METAVARIABLE.search(name):
        return True
    for base in [ROOT, *(ROOT / each for each in FOLDERS), ROOT / folder]:
        parent, last = (base / name).parent, (base / name).name
        if (base / name).exists() or parent.is_dir() and (any(parent.glob(last)) or any(parent.glob(last + ".*"))):
            return True
    return False


def comments(path):
    """The comments of a source, each with its first line."""
    text = (ROOT / path).read_text()
    patterns = [C_COMMENT] if path.suffix in {".cpp", ".hpp", ".def", ".js", ".mjs"} else [HASH_COMMENT]
    patterns += [DOCSTRING] if path.suffix == ".py" or text.startswith("#!/usr/bin/env python3") else []
    for pattern in patterns:
        for found in pattern.finditer(text):
            yield text.count("\n", 0, found.start(1)) + 1, found.group(1)


def is_source(path):
    if path.parts[0] == "reference" and path.parts[1] == "data" or "corpus" in path.parts:
        return False
    return path.suffix in SOURCES and (path.suffix or path.parts[0] == ".ci" or path.name == "run") or path.name == "CMakeLists.txt"


def anchors(page):
    """The names that GitHub gives to the headings of a page."""
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in HEADING.findall(page.read_text())}


def faults_of_page(path):
    page = ROOT / path
    text = CODE.sub("", page.read_text())
    for quoted in QUOTED.findall(text):
        if NAMED.fullmatch(quoted) and not exists(quoted, path.parent):
            yield f"{path}: there is no {quoted}"
    for target, anchor in LINK.findall(INLINE_CODE.sub("", text)):
        linked = page.parent / target if target else page
        if not linked.exists():
            yield f"{path}: there is no {target}"
        elif anchor and linked.suffix == ".md" and anchor not in anchors(linked):
            yield f"{path}: {target or path} has no heading #{anchor}"


def faults_of_source(path):
    for line, comment in comments(path):
        for name in NAMED.findall(comment):
            if not exists(name, path.parent):
                yield f"{path}:{line}: there is no {name}"


def programs():
    """Pages, and the programs that they show whole."""
    yield "docs/library.md", ROOT / "tests/embedding/relaxes.cpp"
    for program in (ROOT / "docs/examples/outside").glob("*.cpp"):
        yield "docs/special_functions.md" if program.stem == "functions" else "docs/library.md", program
    for equation in (ROOT / "docs/examples").glob("*.toml"):
        yield "docs/gallery.md", equation
    yield "docs/c.md", ROOT / "docs/examples/c/riccati.c"
    yield "docs/c.md", ROOT / "docs/examples/fortran/relaxation.f90"


def faults():
    for path in FILES:
        if path.suffix == ".md":
            yield from faults_of_page(path)
        elif is_source(path):
            yield from faults_of_source(path)
    for page, program in programs():
        if program.read_text().removeprefix("// SPDX-License-Identifier: MIT\n") not in (ROOT / page).read_text():
            yield f"{page}: its program is not that of {program.relative_to(ROOT)}"
    index = (ROOT / "docs/README.md").read_text()
    for page in (ROOT / "docs").glob("*.md"):
        if page.name != "README.md" and f"({page.name})" not in index:
            yield f"docs/README.md: does not link {page.name}"


found = list(faults())
print(*(found or ["every path and link leads somewhere, and the programs that are shown are tested"]), sep="\n")
sys.exit(bool(found))
