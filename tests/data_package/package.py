# SPDX-License-Identifier: MIT
"""A folder read through its datapackage.json alone, by the rules of Data Package, Tabular Data Resource and Table Schema, version 1."""

import csv
import hashlib
import json
import re
from decimal import Decimal
from pathlib import Path

DATA = Path(__file__).resolve().parents[2] / "reference" / "data"
NAME = re.compile(r"[a-z0-9._-]+")
CELL = {
    "number": (re.compile(r"[+-]?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?"), Decimal),
    "integer": (re.compile(r"[+-]?\d+"), int),
    "string": (re.compile(r".+"), str),
}
TABULAR = {"profile": "tabular-data-resource", "format": "csv", "mediatype": "text/csv", "encoding": "utf-8"}


def descriptor(folder):
    return json.loads((folder / "datapackage.json").read_text())


def rows_of(folder, resource):
    """The header and the rows of a table."""
    end = resource["dialect"]["lineTerminator"]
    with open(folder / resource["path"], encoding=resource["encoding"], newline="") as file:
        lines = file.read().split(end)
    assert lines.pop() == "", "the last line is open"
    header, *rows = csv.reader(lines)
    return header, rows


def faults_of_cells(fields, rows):
    for line, row in enumerate(rows, 2):
        if len(row) != len(fields):
            yield f"line {line}: {len(row)} cells"
        for field, cell in zip(fields, row):
            pattern, value = CELL[field["type"]]
            limits = field["constraints"]
            if not pattern.fullmatch(cell):
                yield f"line {line}: {field['name']}: {cell!r} is no {field['type']}"
            elif not limits.get("minimum", value(cell)) <= value(cell) <= limits.get("maximum", value(cell)):
                yield f"line {line}: {field['name']}: {cell} is out of bounds"


def faults_of_key(schema, header, rows):
    """The arguments of a row are compared as numbers: 1 and 1.0 are the same."""
    places = [header.index(name) for name in schema["primaryKey"]]
    values = [CELL[schema["fields"][place]["type"]][1] for place in places]
    keys = [tuple(value(row[place]) for value, place in zip(values, places)) for row in rows]
    if not places or len(set(keys)) != len(keys):
        yield f"{schema['primaryKey']} is no key"


def faults_of_resource(folder, resource):
    for name, value in TABULAR.items():
        if resource[name] != value:
            yield f"{name} is {resource[name]}"
    if not NAME.fullmatch(resource["name"]):
        yield "is no name"
    path = Path(resource["path"])
    if path.is_absolute() or ".." in path.parts or not (folder / path).is_file():
        yield f"{path} is no file of the folder"
        return
    text = (folder / path).read_bytes()
    if resource["bytes"] != len(text) or resource["hash"] != f"sha256:{hashlib.sha256(text).hexdigest()}":
        yield "has other bytes"
    schema = resource["schema"]
    if schema["missingValues"] != [""]:
        yield "an empty cell is no missing value"
    header, rows = rows_of(folder, resource)
    if header != [field["name"] for field in schema["fields"]]:
        yield f"has the header {header}"
    elif not rows:
        yield "has no rows"
    elif found := list(faults_of_cells(schema["fields"], rows)):
        yield from found
    else:
        yield from faults_of_key(schema, header, rows)
    for field in schema["fields"]:
        if not field["description"] or "unit" not in field or field["constraints"]["required"] is not True:
            yield f"{field['name']} is not described"


def faults(folder=DATA):
    """One line for each fault of a folder."""
    package = descriptor(folder)
    if package["profile"] != "tabular-data-package" or not NAME.fullmatch(package["name"]):
        yield "datapackage.json: is no tabular data package with a name"
    if not re.fullmatch(r"\d+\.\d+\.\d+", package["version"]):
        yield f"datapackage.json: version {package['version']}"
    for licence in package["licenses"]:
        if not (folder / licence["path"]).read_text().startswith(licence["title"]):
            yield f"datapackage.json: {licence['path']} is not the {licence['title']}"
    for field in ("id", "title", "description", "keywords", "contributors", "sources"):
        if not package[field]:
            yield f"datapackage.json: no {field}"
    names = [resource["name"] for resource in package["resources"]]
    if len(set(names)) != len(names):
        yield "datapackage.json: two resources of one name"
    paths = {resource["path"] for resource in package["resources"]}
    for table in folder.rglob("*.csv"):
        if table.relative_to(folder).as_posix() not in paths:
            yield f"{table.relative_to(folder)}: is not in the package"
    for resource in package["resources"]:
        yield from (f"{resource['name']}: {fault}" for fault in faults_of_resource(folder, resource))
