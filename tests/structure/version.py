#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The version is written once, in project(... VERSION ...) of CMakeLists.txt; everything else that names it agrees.

    version.py             CITATION.cff, CHANGELOG.md, the packages of docs/install.md and every find_package(fdebench ...); one line for each fault
    version.py FDEBENCH    what `FDEBENCH --version` prints, too
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def first(pattern, name):
    """The groups of the first match of a pattern in a file of the repository."""
    found = re.search(pattern, (ROOT / name).read_text(), re.MULTILINE)
    return found.groups() if found else (None,) * re.compile(pattern).groups


def faults(program=None):
    (version,) = first(r"^project\(fdebench VERSION ([\d.]+)", "CMakeLists.txt")
    released, date = first(r"^## (\d+\.\d+\.\d+) - (\d{4}-\d{2}-\d{2})$", "CHANGELOG.md")
    named = [("CHANGELOG.md: its newest version", released, version),
             ("CITATION.cff: version", *first(r"^version: (.*)$", "CITATION.cff"), version),
             ("CITATION.cff: date-released", *first(r"^date-released: (.*)$", "CITATION.cff"), date)]
    minor = version.rpartition(".")[0]
    for file in ["docs/library.md", "docs/examples/outside/CMakeLists.txt"]:
        named.append((f"{file}: find_package", *first(r"find_package\(fdebench ([\d.]+)", file), minor))
    for found in set(re.findall(r"fdebench[-_](\d+\.\d+\.\d+)[-_]", (ROOT / "docs/install.md").read_text())):
        named.append(("docs/install.md: the version of its packages", found, version))
    if program:
        printed = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
        named.append((f"{program} --version", printed.split()[-1], version))
    return [f"{what} is {found}, where {wanted} is due" for what, found, wanted in named if found != wanted]


found = faults(*sys.argv[1:])
print(*(found or ["one version everywhere"]), sep="\n")
sys.exit(bool(found))
