#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables whose bytes change have another version, and the right number of it rises."""

import unittest

import package
import versions


class Repository(unittest.TestCase):
    def test_the_tables_are_those_of_their_version(self):
        version = package.descriptor(package.DATA)["version"]
        self.assertEqual(versions.versions()[-1], version, "tests/data_package/versions.py writes the list of a new version")
        listed, present = versions.read(version), versions.tables()
        changed = [path for path in listed | present if listed.get(path) != present.get(path)]
        self.assertEqual(changed, [], f"these are not the tables of version {version}: docs/reference_data.md says which number rises")

    def test_each_version_raises_the_number_that_is_due(self):
        known = versions.versions()
        for before, after in zip(known, known[1:]):
            place = versions.due(versions.read(before), versions.read(after))
            self.assertIsNotNone(place, f"{after} has the tables of {before}")
            self.assertLessEqual(versions.raised(before, after), place, f"{after} after {before}")


class Rule(unittest.TestCase):
    BEFORE = {"a.csv": ("t y", "27", "1f"), "b.csv": ("t x", "27", "2f")}

    def assert_due(self, place, **tables):
        self.assertEqual(versions.due(self.BEFORE, {f"{name}.csv": table for name, table in tables.items()}), place)

    def test_columns_or_a_removed_table(self):
        self.assert_due(0, a=("t y bound", "27", "3f"), b=("t x", "27", "2f"))
        self.assert_due(0, a=("t y", "27", "1f"))

    def test_rows_or_a_new_table(self):
        self.assert_due(1, a=("t y", "28", "3f"), b=("t x", "27", "2f"))
        self.assert_due(1, a=("t y", "27", "3f"), b=("t x", "27", "2f"), c=("t", "1", "4f"))

    def test_values(self):
        self.assert_due(2, a=("t y", "27", "3f"), b=("t x", "27", "2f"))
        self.assert_due(None, **{"a": self.BEFORE["a.csv"], "b": self.BEFORE["b.csv"]})

    def test_numbers(self):
        self.assertEqual([versions.raised("1.2.3", after) for after in ("2.0.0", "1.10.0", "1.2.4", "1.2.3", "1.1.9")],
                         [0, 1, 2, None, None])


if __name__ == "__main__":
    unittest.main()
