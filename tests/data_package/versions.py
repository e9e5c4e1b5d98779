#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables of each version of the reference data: columns, number of rows and SHA-256, in the folder of the same name.

    versions.py        writes the list of the version in metadata.json of benchmarks/reference_data/package
"""

import csv
import hashlib
import io
from pathlib import Path

import package

LISTS = Path(__file__).parent / "versions"
COLUMNS = ["path", "columns", "rows", "sha256"]


def tables(folder=package.DATA):
    """Columns, number of rows and SHA-256 by the path of a table."""
    listed = {}
    for resource in package.descriptor(folder)["resources"]:
        header, rows = package.rows_of(folder, resource)
        digest = hashlib.sha256((folder / resource["path"]).read_bytes()).hexdigest()
        listed[resource["path"]] = (" ".join(header), str(len(rows)), digest)
    return listed


def read(version):
    with open(LISTS / f"{version}.csv", newline="") as file:
        header, *rows = csv.reader(file)
    assert header == COLUMNS
    return {path: tuple(rest) for path, *rest in rows}


def text_of(listed):
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([COLUMNS, *([path, *rest] for path, rest in sorted(listed.items()))])
    return out.getvalue()


def numbers(version):
    return tuple(map(int, version.split(".")))


def versions():
    return sorted((path.stem for path in LISTS.glob("*.csv")), key=numbers)


def due(before, after):
    """Which number of the version rises: 0 where columns change or a table is removed, 1 where rows or tables are added, 2 where
    values are corrected; None where nothing changes."""
    if any(path not in after or after[path][0] != columns for path, (columns, _, _) in before.items()):
        return 0
    if before.keys() != after.keys() or any(after[path][1] != rows for path, (_, rows, _) in before.items()):
        return 1
    return 2 if before != after else None


def raised(before, after):
    """Which number differs first; None where the second version is not above the first."""
    if numbers(after) <= numbers(before):
        return None
    return next(place for place, (a, b) in enumerate(zip(numbers(before), numbers(after))) if a != b)


if __name__ == "__main__":
    version = package.descriptor(package.DATA)["version"]
    (LISTS / f"{version}.csv").write_text(text_of(tables()))
