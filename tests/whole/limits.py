# SPDX-License-Identifier: MIT
"""The limit of schemes on grids at the end time, with an uncertainty from their last differences."""

from collections.abc import Sequence

from case import Case
from program import Program
from table import Table

PAIR = ("product_trapezoidal", "l1")
FEW, MANY = (256, 512, 1024, 2048), (2048, 4096, 8192, 16384)
Limit = dict[str, tuple[float, float]]


def ends(program: Program, case: Case, scheme: str, until: str, steps: Sequence[int]) -> list[Table] | None:
    tables = []
    for number in steps:
        ended = program.run("solve", *case.problem(), "--scheme", scheme, "--steps", str(number), "--at", until, "--budget", "2")
        if not ended.done:
            return None
        tables.append(Table.read(ended.out))
    return tables


def limit(program: Program, case: Case, scheme: str, until: str, steps: Sequence[int] = FEW) -> Limit | None:
    """The end value of each column and its uncertainty, five times the last difference; only columns whose differences decrease."""
    tables, found = ends(program, case, scheme, until, steps), {}
    for name in tables[-1].unknowns if tables else []:
        a, b, c, d = (table.column(name)[-1] for table in tables)
        if abs(d - c) <= 0.8 * abs(c - b) + 1e-12 * abs(d) and abs(c - b) <= 0.9 * abs(b - a) + 1e-12 * abs(d):
            found[name] = (d, 5 * abs(d - c) + 1e-11 * abs(d))
    return found if tables else None


def crude_limit(program: Program, case: Case, until: str) -> Limit:
    """The limit from an implicit and an explicit scheme that agree. If only one of them finishes (Newton's method may fail where
    the solution slides along a discontinuity), the uncertainty is twenty times its largest difference."""
    explicit = ends(program, case, "adams_pc", until, MANY)
    implicit = ends(program, case, PAIR[0], until, MANY)
    found = {}
    for name in (explicit or implicit or [Table([], [])])[-1].unknowns:
        known = []
        for tables in (explicit, implicit):
            if tables:
                column = [table.column(name)[-1] for table in tables]
                known.append((column[-1], max(abs(x - y) for x, y in zip(column, column[1:])) + 1e-11 * abs(column[-1])))
        value, off = min(known, key=lambda one: one[1])
        if len(known) == 1:
            found[name] = (value, 20 * off)
        elif abs(known[0][0] - known[1][0]) <= 3 * (known[0][1] + known[1][1]):
            found[name] = (value, 5 * off + abs(known[0][0] - known[1][0]))
    return found
