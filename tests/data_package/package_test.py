#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reference data are a Frictionless Data Package that can be cited, and the reader that says so finds faults."""

import hashlib
import json
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import package

TABLE = "trajectories/relaxation.csv"


class Repository(unittest.TestCase):
    def test_is_a_data_package(self):
        self.assertEqual(list(package.faults()), [])

    def test_has_a_resource_for_each_table_of_the_index(self):
        index = json.loads((package.DATA / "index.json").read_text())["tables"]
        resources = package.descriptor(package.DATA)["resources"]
        self.assertEqual([(table["file"], f"sha256:{table['sha256']}") for table in index],
                         [(resource["path"], resource["hash"]) for resource in resources])
        for table, resource in zip(index, resources):
            self.assertEqual(table["rows"], len(package.rows_of(package.DATA, resource)[1]))
            described = json.loads((package.DATA / table["description"]).read_text())["schema"]["columns"]
            fields = resource["schema"]["fields"]
            self.assertEqual([(column["name"], column["meaning"], column["unit"], column["type"]) for column in described],
                             [(field["name"], field["description"], field["unit"], field["type"]) for field in fields])

    def test_is_cited_by_its_own_version(self):
        citation, data = (package.DATA / "CITATION.cff").read_text(), package.descriptor(package.DATA)
        for key, value in [("title", data["title"]), ("version", data["version"]), ("abstract", data["description"])]:
            self.assertEqual(json.loads(re.search(rf"^{key}: (.*)$", citation, re.MULTILINE)[1]), value)
        self.assertRegex(citation, r"(?m)^type: dataset$")

    def test_lists_the_checksums_of_all_files(self):
        sums = dict(reversed(line.split("  ")) for line in (package.DATA / "SHA256SUMS").read_text().splitlines())
        files = {path.relative_to(package.DATA).as_posix() for path in package.DATA.rglob("*") if path.is_file()}
        self.assertEqual(set(sums), files - {"SHA256SUMS"})
        for name, digest in sums.items():
            self.assertEqual(hashlib.sha256((package.DATA / name).read_bytes()).hexdigest(), digest, name)


class Damaged(unittest.TestCase):
    """Each change of a copy is found."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.data = Path(self.folder.name) / "data"
        shutil.copytree(package.DATA, self.data)

    def change(self, name, old, new):
        text = (self.data / name).read_text()
        self.assertIn(old, text)
        (self.data / name).write_text(text.replace(old, new, 1))

    def assert_found(self, *faults):
        found = list(package.faults(self.data))
        for fault in faults:
            self.assertTrue(any(fault in each for each in found), f"{fault}: {found}")

    def test_bytes(self):
        self.change(TABLE, "\n1,0.4", "\n1,0.5")
        self.assert_found("trajectories.relaxation: has other bytes")

    def test_cell(self):
        self.change(TABLE, "\n1,0.4", "\n1,about 0.4")
        self.assert_found("line 12: y: 'about 0.4", "is no number")

    def test_empty_cell(self):
        self.change("convergence/relaxation.csv", "adams_pc,64,0.015625", "adams_pc,64,")
        self.assert_found("convergence.relaxation: line 2: h: '' is no number")

    def test_bound(self):
        self.change(TABLE, "\n1,0.4", "\n-1,0.4")
        self.assert_found("line 12: t: -1 is out of bounds")

    def test_key(self):
        self.change(TABLE, "\n1,0.4", "\n1.50,0.4")
        self.assert_found("['t'] is no key")

    def test_header(self):
        self.change(TABLE, "t,y,bound", "t,x,bound")
        self.assert_found("has the header ['t', 'x', 'bound']")

    def test_missing_and_added_tables(self):
        (self.data / TABLE).rename(self.data / "mine.csv")
        self.assert_found(f"{TABLE} is no file", "mine.csv: is not in the package")

    def test_name(self):
        self.change("datapackage.json", '"trajectories.power"', '"trajectories/Power"')
        self.assert_found("trajectories/Power: is no name")


if __name__ == "__main__":
    unittest.main()
