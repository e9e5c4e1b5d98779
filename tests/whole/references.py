# SPDX-License-Identifier: MIT
"""`exact` is compared with two schemes that share no code with it, and with its own values to many digits."""

from dataclasses import replace
from decimal import Decimal
from random import Random

from case import Case
from drawn_numbers import spread, typed
from drawn_scenes import Lists
from drawn_solves import drawn_problem
from errors import decimals, end_of, perturbed
from limits import PAIR, limit
from program import Fault, Program
from properties import must_hold
from table import Table, check_finite, check_times


def drawn_reference(random: Random, lists: Lists) -> Case:
    case = Case("exact_is_what_schemes_tend_to", **drawn_problem(random, lists, files=0.75, wild=0, events=False))
    return replace(case, chosen={**case.chosen, "until": typed(end_of(case, lists) * spread(random, 0.05, 1), 3)})


@must_hold(drawn_reference, 5)
def exact_is_what_schemes_tend_to(program: Program, case: Case, lists: Lists) -> None:
    """Where two schemes agree within their uncertainties, `exact` agrees with them."""
    known = program.run("exact", *case.problem(), "--at", case.chosen["until"], "--bounds", "--budget", "4")
    if not known.done:
        return
    exact = Table.read(known.out)
    check_finite(exact)
    first = limit(program, case, PAIR[0], case.chosen["until"])
    second = limit(program, case, PAIR[1], case.chosen["until"]) if first else None
    for name in set(first or ()) & set(second or ()) & set(exact.names):
        (a, off_a), (b, off_b) = first[name], second[name]
        value, bound = exact.column(name)[-1], exact.column("bound")[-1]
        apart = 4 * (off_a + off_b) + bound + 1e-7 * (1 + abs(a))
        if float(case.chosen["until"]) in decimals(case) and case.file:
            continue  # possibly the time of a jump
        if abs(a - b) <= off_a + off_b and abs(value - a) > apart and abs(value - b) > apart and settled(program, case, name, a, abs(value - a)):
            raise Fault("false", f"exact says {name} = {value!r}, bound {bound:g}; {PAIR[0]} {a!r}, {PAIR[1]} {b!r}, these within {off_a + off_b:.1g}", known.arguments)


def settled(program: Program, case: Case, name: str, value: float, apart: float) -> bool:
    """Slightly perturbed initial values give nearly the same end: the solution is not one of several (non-uniqueness)."""
    for size in (1e-6, -1e-6):
        moved = perturbed(case, size)
        moved.write(program.folder)
        ended = limit(program, moved, PAIR[0], case.chosen["until"])
        case.write(program.folder)
        if ended is None or name not in ended or abs(ended[name][0] - value) > 0.1 * apart:
            return False
    return True


def drawn_digits(random: Random, lists: Lists) -> Case:
    case = Case("digits_are_within_the_bound", **drawn_problem(random, lists, files=0.2, wild=0.4))
    times = [typed(end_of(case, lists) * spread(random, 1e-3, 1), 3) for _ in range(random.randint(1, 4))]
    return replace(case, options={"--at": ",".join(times), "--budget": "10"})


@must_hold(drawn_digits, 2.5)
def digits_are_within_the_bound(program: Program, case: Case, lists: Lists) -> None:
    """The doubles of `exact` are within their bounds of its values with 40 digits; rows are sorted by time without repetitions."""
    short = program.run("exact", *case.problem(), *case.given(), "--bounds")
    if not short.done:
        return
    doubles = Table.read(short.out)
    check_finite(doubles)
    check_times(doubles)
    if doubles.times != sorted({float(t) for t in case.options["--at"].split(",")}):
        raise Fault("times", f"rows are of {doubles.times}, asked {case.options['--at']}")
    long = program.run("exact", *case.problem(), *case.given(), "--digits", "40")
    if not long.done:
        return
    digits = Table.read(long.out)
    for name in digits.unknowns:
        bounds = doubles.column(f"bound_{name}") if f"bound_{name}" in doubles.names else doubles.column("bound")
        k, j = doubles.names.index(name), digits.names.index(name)
        for row, other, bound in zip(doubles.rows, digits.rows, bounds):
            if abs(Decimal(row[k]) - Decimal(other[j])) > Decimal(bound) + Decimal(other[digits.names.index("bound")]):
                raise Fault("bound", f"{name} at t = {row[0]} is {row[k]}, bound {bound:g}, with digits {other[j]}")
