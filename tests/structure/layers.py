#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the includes of the sources against layers.txt, which lists for each folder the folders that it may include, the
namespace of each source, and that no two types and no two headers have the same name.

    layers.py            check; one line for each fault, exit code 1 if there is one
    layers.py --dot      the dependency graph of the folders, for Graphviz
    layers.py --sizes    the largest folders, the longest files and functions
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOP_FOLDERS = ["schemes", "reference", "benchmarks", "reports", "c", "python"]  # included as "fdebench/FOLDER/..."; tests from tests/
TABLE = Path(__file__).with_name("layers.txt")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def sources():
    """Paths of all C++ sources, relative to the repository."""
    for top in [*TOP_FOLDERS, "tests"]:
        for path in sorted((ROOT / top).rglob("*")):
            if path.suffix in {".cpp", ".hpp", ".def"} and "node_modules" not in path.parts:
                yield path.relative_to(ROOT)


def folder_of(path):
    return path.parent.as_posix()


def includes(path):
    """(name, file) of each quoted include; the file is None if it is not in this repository."""
    for name in INCLUDE.findall((ROOT / path).read_text()):
        file = Path(name.removeprefix("fdebench/")) if name.startswith("fdebench/") else Path("tests") / name
        yield name, file if (ROOT / file).is_file() else None


def arrows():
    """{(folder, included folder): a file with such an include}"""
    result = {}
    for path in sources():
        for _, target in includes(path):
            if target and folder_of(target) != folder_of(path):
                result.setdefault((folder_of(path), folder_of(target)), path.as_posix())
    return result


def allowed():
    """{folder: the folders that its line in layers.txt lists}, in the order of the table; and the folders with a line that lists
    all of them."""
    table, closed = {}, set()
    for line in TABLE.read_text().splitlines():
        if line and not line.startswith("#"):
            folder, mark, targets = re.fullmatch(r"([\w/]+) ?([:=])(.*)", line).groups()
            table[folder] = targets.split()
            closed |= {folder} if mark == "=" else set()
    return table, closed


def reach(table, closed):
    """{folder: the folders it may include}: those of its line, and unless it is closed those that these may include."""
    result = {}
    for folder, targets in table.items():
        result[folder] = set(targets).union(*(result.get(target, set()) for target in targets if folder not in closed))
    return result


def is_test_of(folder, target):
    """Tests may include every folder except those of other tests, which the table has to allow."""
    return folder.startswith("tests/") and not target.startswith("tests/")


def order_faults(table):
    """In the table each folder may include folders above it only, so that there is no cycle."""
    above = set()
    for folder, targets in table.items():
        for target in targets:
            if target not in above:
                yield f"layers.txt: {folder} may include {target}, which is not above it"
        above.add(folder)


def types_of(path):
    """Qualified names of the types that a file defines, except those in unnamed namespaces."""
    spaces = []
    for line in (ROOT / path).read_text().splitlines():
        if opened := re.match(r"namespace ?([\w:]*) \{", line):
            spaces.append(opened.group(1))
        elif line.startswith("}  // namespace"):
            spaces.pop()
        elif defined := re.match(r"(?:struct|class|enum class) (\w+)(?: final)?(?: :[^;{]*)? \{", line):
            if "" not in spaces:
                yield "::".join([*spaces, defined.group(1)])


def twins():
    """Types with the same qualified name: they violate the one-definition rule, and the linker keeps either's members."""
    known = {}
    for path in sources():
        for name in types_of(path):
            if known.setdefault(name, path) != path:
                yield f"{path}: {name} is defined in {known[name]} too"


def twin_headers():
    """Headers with the same file name: a reader cannot tell them apart."""
    known = {}
    for path in sources():
        if path.suffix == ".hpp" and known.setdefault(path.name, path) != path:
            yield f"{path}: {known[path.name]} has this name too"


def space_of(path):
    """The namespace of a source: that of its layer; of tests, that of the layer that knows everything."""
    if path.parts[0] == "reference" or path.parts[:2] in {("tests", "reference"), ("tests", "certificate")}:
        return "fde::reference"
    return "fde" if path.parts[0] == "schemes" else "fde::bench"


def wrong_namespaces():
    for path in sources():
        for space in re.findall(r"^namespace (fde[\w:]*) \{", (ROOT / path).read_text(), re.MULTILINE):
            if not (space + "::").startswith(space_of(path) + "::"):
                yield f"{path}: namespace {space} is not that of its layer, {space_of(path)}"


def faults():
    yield from twins()
    yield from twin_headers()
    yield from wrong_namespaces()
    (table, closed), seen = allowed(), arrows()
    may_include = reach(table, closed)
    yield from order_faults(table)
    for (folder, target), file in seen.items():
        if target not in may_include.get(folder, ()) and not is_test_of(folder, target):
            yield f"{file}: {folder} may not include {target}"
    for folder, targets in table.items():
        for target in targets:
            if (folder, target) not in seen:
                yield f"layers.txt: no file of {folder} includes {target}"
            if folder not in closed and any(target in may_include[other] for other in targets):
                yield f"layers.txt: {folder} may include {target} already"
    for path in sources():
        for name, target in includes(path):
            if target is None and name not in {"build_facts.hpp", "package_texts.hpp"}:
                yield f'{path}: "{name}" is not named with its folder'


def print_dot():
    print('digraph layers {\n  rankdir=BT; nodesep=0.15; ranksep=0.35; node [shape=box, fontname="sans-serif", fontsize=11]; edge [color="#00000060"];')
    folders = [folder for folder in allowed()[0] if not folder.startswith("tests")]
    for top in TOP_FOLDERS:
        inside = " ".join(f'"{folder}"' for folder in folders if folder.split("/")[0] == top)
        print(f'  subgraph "cluster_{top}" {{ label="{top}"; style=filled; color="#f0f0f0"; {inside} }}')
    for folder in folders:
        label = folder.split("/", 1)[-1]
        print(f'  "{folder}" [label="{label}"];')
    for folder, target in sorted(arrows()):
        if folder in folders:
            print(f'  "{folder}" -> "{target}";')
    print("}")


def functions(path):
    """(number of lines, place) of each function in code formatted by clang-format: its last brace has the indentation of its
    first line."""
    lines = (ROOT / path).read_text().splitlines()
    opening = re.compile(r"^( *)(?!namespace|class|struct|enum|extern|union|//|\}|#)\S.*\)[^;]*\{$")
    for number, line in enumerate(lines):
        begin = opening.match(line)
        if not begin or len(begin.group(1)) > 2:
            continue
        end = next((k for k in range(number, len(lines)) if lines[k].startswith(begin.group(1) + "}")), number)
        yield end - number + 1, f"{path}:{number + 1}"


def print_sizes(most=5):
    files, folders, longest = [], defaultdict(int), []
    for path in sources():
        folders[folder_of(path)] += 1
        files.append((len((ROOT / path).read_text().splitlines()), path.as_posix()))
        longest += functions(path)
    for title, rows in [("folders", [(n, folder) for folder, n in folders.items()]), ("files", files), ("functions", longest)]:
        print(title)
        for size, name in sorted(rows, reverse=True)[:most]:
            print(f"  {size:4} {name}")


if __name__ == "__main__":
    arguments = sys.argv[1:]
    if arguments == ["--dot"]:
        print_dot()
    elif arguments == ["--sizes"]:
        print_sizes()
    elif arguments:
        sys.exit(f"layers.py: {' '.join(arguments)}: must be --dot, --sizes or nothing\n{__doc__}")
    else:
        found = list(faults())
        print(*(found or ["every include is allowed, and every name and namespace is as it should be"]), sep="\n")
        sys.exit(bool(found))
