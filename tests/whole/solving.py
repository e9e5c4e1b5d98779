# SPDX-License-Identifier: MIT
"""The output of solve: complete, finite, and bitwise independent of output options."""

import json
import re
from dataclasses import replace
from random import Random

from case import Case
from drawn_files import drawn_file
from drawn_scenes import Lists
from drawn_solves import drawn_problem, drawn_solve, resolution
from program import Fault, Outcome, Program
from properties import must_hold
from table import Table, check_finite, check_times


def solve(program: Program, case: Case, *more: str) -> Outcome:
    return program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given(), *more)


def check_rows(case: Case, ended: Outcome) -> Table:
    """Checks that the rows are the requested ones, finite and in order."""
    table = Table.read(ended.out)
    check_finite(table)
    if "--all" in case.options:
        for number in dict.fromkeys(table.column("solution")):
            check_table(case, Table(table.names, [row for row, of in zip(table.rows, table.column("solution")) if of == number]))
        return table
    check_table(case, table)
    return table


def check_table(case: Case, table: Table) -> None:
    if "--events" in case.options or ("ends = true" in case.file and "--accuracy" in case.options):
        return
    check_times(table)
    full = int(case.options.get("--steps", "0"))
    if full and not {"--every", "--points", "--at"} & case.options.keys() and len(table.rows) != full + 1:
        raise Fault("rows", f"{len(table.rows)} rows of {full} steps")
    if full and "--every" in case.options and len(table.rows) != -(-full // int(case.options["--every"])) + 1:
        raise Fault("rows", f"{len(table.rows)} rows of {full} steps, each {case.options['--every']}-th and the last")
    if table.times[0] != 0:
        raise Fault("times", f"the first row is of t = {table.times[0]}")


def blames_newton(case: Case, lists: Lists, line: str) -> bool:
    return "Newton" in line and not lists.schemes[case.scheme]["implicit"]


@must_hold(drawn_solve, 4)
def solve_ends_as_it_says(program: Program, case: Case, lists: Lists) -> None:
    """Exit code 0 with complete rows, or 2 or 3 with one line only, which blames Newton's method for implicit schemes only."""
    ended = solve(program, case)
    if ended.done:
        check_rows(case, ended)
        if "--cost" in case.options:
            json.loads(next(line for line in ended.err.splitlines() if line.startswith("{")))
    elif blames_newton(case, lists, ended.err):
        raise Fault("newton", f"an explicit scheme says: {ended.err.strip()}")


def drawn_variant(random: Random, lists: Lists) -> Case:
    scheme = random.choice(list(lists.schemes))
    options = resolution(random, lists, scheme) | {"--budget": "2"}
    if "--steps" in options:
        options["--steps"] = str(min(int(options["--steps"]), 20_000))
        options |= random.choice([{}, {}, {"--grid": "graded:2"}, {"--history": "exponentials"}, {"--history": "direct"}])
    variant = random.choice(["--every", "--points", "--at", "--threads", "--checkpoint", "--budget", "--cost", "--check", "--field"])
    return Case("another_output_has_the_same_bits", scheme=scheme, options=options, words=(variant, str(random.randint(1, 30))),
                **drawn_problem(random, lists, wild=0.1))


@must_hold(drawn_variant, 3)
def another_output_has_the_same_bits(program: Program, case: Case, lists: Lists) -> None:
    """--every, --points, --at, --threads, --checkpoint, --field and options for further output change no bit of a row."""
    variant, count = case.words[0], int(case.words[1])
    ended = solve(program, case)
    if not ended.done:
        return
    whole = check_rows(case, ended)
    rows = {row[0]: row for row in whole.rows}
    value = {"--every": str(count), "--points": str(count + 1), "--threads": "2", "--checkpoint": "state", "--budget": "60", "--field": "field.csv",
             "--at": ",".join(row[0] for row in whole.rows[:: max(1, len(whole.rows) // count)])}.get(variant, "")
    again = replace(case, options={**case.options, variant: value} | ({"--checkpoint-every": "0"} if variant == "--checkpoint" else {}))
    other = solve(program, again)
    if not other.done:
        if "budget" in other.err or other.code == 2 and variant in ("--every", "--checkpoint", "--threads", "--points", "--check"):
            return  # a combination that is refused
        raise Fault("fails", f"with {variant} it ends: {other.err.strip()}")
    table = Table.read(other.out)
    shared = [row for row in table.rows if row[0] in rows]
    if len(shared) != len(table.rows) and (variant != "--points" or "--steps" in case.options):
        raise Fault("times", f"with {variant} {value[:40]} there are times that are not there without it")
    if variant in ("--threads", "--checkpoint", "--budget", "--cost", "--check", "--field") and len(table.rows) != len(whole.rows):
        raise Fault("rows", f"with {variant} {len(table.rows)} rows, without it {len(whole.rows)}")
    if variant == "--field" and [row[0] for row in Table.read((program.folder / value).read_text()).rows] != [row[0] for row in table.rows]:
        raise Fault("field", "the field is not at the times that are printed")
    for row in shared:
        if row != rows[row[0]]:
            raise Fault("bits", f"with {variant} {value[:40]} {','.join(row)}, without it {','.join(rows[row[0]])}")


def drawn_history(random: Random, lists: Lists) -> Case:
    scheme = random.choice([name for name, one in lists.schemes.items() if one["takes_grid"]])
    options = {"--steps": str(random.randint(200, 6000)), "--budget": "2", "--tolerance": random.choice(["1e-4", "1e-6", "1e-9", "1e-12"])}
    if random.random() < 0.3:
        options["--grid"] = f"graded:{random.choice(['1.5', '2', '3'])}"
    return Case("histories_agree", scheme=scheme, options=options, **drawn_problem(random, lists, files=0.2, wild=0))


@must_hold(drawn_history, 1.5)
def histories_agree(program: Program, case: Case, lists: Lists) -> None:
    """The history by exponentials agrees with direct sums to a multiple of the tolerance. The change of the solution with
    another tolerance measures how much the problem magnifies such errors."""
    tolerance = float(case.options["--tolerance"])
    tighter = replace(case, options={**case.options, "--tolerance": "1e-14"})
    ends = [solve(program, one, "--history", history) for one, history in ((case, "exponentials"), (case, "direct"), (tighter, "direct"))]
    if not all(ended.done for ended in ends):
        return
    fast, direct, exact = (Table.read(ended.out) for ended in ends)
    for name in fast.unknowns:
        columns = [table.column(name) for table in (fast, direct, exact)]
        size = max(map(abs, columns[1])) + 1e-300
        moved = max(abs(a - b) for a, b in zip(columns[1], columns[2]))
        apart = max(abs(a - b) for a, b in zip(columns[0], columns[1]))
        if apart > 1e4 * tolerance * size + 100 * moved + 1e-9 * size and growth(columns[1]) < 1e3:
            raise Fault("apart", f"{name} differs by {apart:.2g} of {size:.2g} with a tolerance of {tolerance:g}")


def growth(column: list[float]) -> float:
    """The growth factor of a column from its first twentieth on: a growing mode magnifies errors by it."""
    first = max(map(abs, column[: max(2, len(column) // 20)])) + 1e-300
    return max(map(abs, column)) / first if first > 1e-3 else max(map(abs, column)) / 1e-3


def drawn_start(random: Random, lists: Lists) -> Case:
    scheme = random.choice(list(lists.schemes))
    return Case("a_start_moves_the_solution", file=drawn_file(random, events=False), scheme=scheme, words=(random.choice(["1", "0.1", "2.5", "100"]),),
                options=resolution(random, lists, scheme) | {"--budget": "2", "--points": "5"})


def moved(lines: tuple[str, ...], start: str) -> tuple[str, ...] | None:
    """The file whose time begins at `start`, with t - start for t in its formulas; nothing where that is no formula of the same kind."""
    text = "\n".join(lines)
    if re.search(r"\(t - |\[\[jump|\[table|\(t, ", text) or "start" in text:
        return None
    later = re.sub(r'"[^"\n]*"', lambda found: re.sub(r"\bt\b", f"(t - {start})", found[0]), text)
    return (f"start = {start}", *re.sub(r"^end = (\S+)", f'end = "\\1 + {start}"', later, flags=re.MULTILINE).split("\n"))


@must_hold(drawn_start, 1)
def a_start_moves_the_solution(program: Program, case: Case, lists: Lists) -> None:
    """With another start, and t - start for t, the times are later and the values the same, up to rounding; or both files are refused."""
    later = moved(case.file, case.words[0])
    ended = solve(program, case)
    if later is None or not ended.done:
        return
    replace(case, file=later).write(program.folder)
    of_later = solve(program, case)
    case.write(program.folder)
    if not of_later.done:
        raise Fault("start", f"refused: {of_later.err.strip()}")
    first, second = Table.read(ended.out), Table.read(of_later.out)
    size = max(1.0, *(abs(value) for row in first.rows for value in map(float, row[1:])))
    for a, b in zip(first.rows, second.rows, strict=True):
        if abs(float(a[0]) + float(case.words[0]) - float(b[0])) > 1e-12 * float(b[0]):
            raise Fault("times", f"{a[0]} is {b[0]} later")
        if max(abs(float(x) - float(y)) for x, y in zip(a[1:], b[1:], strict=True)) > 1e-4 * size and "warning" not in ended.err:
            raise Fault("values", f"at t = {a[0]}: {a[1:]} and {b[1:]}")
