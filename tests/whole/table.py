# SPDX-License-Identifier: MIT
"""The CSV output of solve and exact."""

import csv
import io
import math
import re
from dataclasses import dataclass

from program import Fault

DERIVED = re.compile(r"t|event|solution|energy|constraint|lambda\d*|power|bound.*")


@dataclass(frozen=True)
class Table:
    names: list[str]
    rows: list[list[str]]

    @staticmethod
    def read(text: str) -> "Table":
        lines = list(csv.reader(io.StringIO(text)))
        if not lines or any(len(line) != len(lines[0]) for line in lines):
            raise Fault("rows", f"a row has not as many fields as the header: {text[-200:]!r}")
        return Table(lines[0], lines[1:])

    def column(self, name: str) -> list[float]:
        k = self.names.index(name)
        return [float(row[k]) for row in self.rows]

    @property
    def times(self) -> list[float]:
        return self.column("t")

    @property
    def unknowns(self) -> list[str]:
        """The columns of the problem, without derived columns."""
        return [name for name in self.names if not DERIVED.fullmatch(name)]


def check_finite(table: Table) -> None:
    """Every number is finite, except at t = 0 a reaction that is unbounded there, which may be nan, and a column beside its
    quotient by a power of t."""
    for row in table.rows:
        for name, text in zip(table.names, row):
            if name == "event":
                continue
            value, at_start = float(text), float(row[table.names.index("t")]) == 0
            is_reaction = re.fullmatch(r"lambda\d*|power", name) and math.isnan(value)
            is_singular = f"{name}_weighted" in table.names and math.isinf(value)
            if not math.isfinite(value) and not (at_start and (is_reaction or is_singular)):
                raise Fault("finite", f"{name} is {text} at t = {row[table.names.index('t')]}")


def check_times(table: Table) -> None:
    times = table.times
    if any(not a < b for a, b in zip(times, times[1:])):
        raise Fault("times", "times do not increase")
