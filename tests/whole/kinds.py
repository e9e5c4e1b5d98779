# SPDX-License-Identifier: MIT
"""The kinds of drawn_kinds.py: `exact` is within its bound and adaptive runs are within ten times what was asked, by the oracle."""

import resource
import time
from collections.abc import Iterator
from math import inf

import oracle_problems
from case import Case
from drawn_kinds import drawn_algebraic, drawn_constrained, drawn_delays, drawn_equilibria, drawn_load_case
from drawn_scenes import Lists
from errors import ESTIMATED, FACTOR, MISSED
from oracle import solution
from oracle_panels import Uncertain
from program import Fault, Outcome, Program
from properties import must_hold
from table import DERIVED, Table

Known = list[dict[str, tuple[float, float]]]
USABLE = 1e-5  # error of the oracle, as a part of 1 + |y|
BUDGET, SLOW, STOP = "8", 5.0, 20.0  # seconds


def known(case: Case, times: list[float]) -> Known:
    equations, shape = oracle_problems.problem(case, times[-1])
    found = solution(equations, shape, times)
    for values in found:
        for name, (value, off) in values.items():
            if not off <= USABLE * (1 + abs(value)) or abs(value) > 1e8:
                raise Uncertain(f"{name} = {value:g} to {off:.1g}")
    return found


def ended(program: Program, *arguments: str) -> Outcome | None:
    """How a command ends; None if it takes too long."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    try:
        outcome = program.run(*arguments, seconds=STOP)
    except Fault as fault:
        if fault.kind != "time":
            raise
        return None
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if min(after.ru_utime - before.ru_utime, time.monotonic() - begin) > SLOW * program.slow:
        program.note(f"slow: {arguments[0]}{next((' ' + b for a, b in zip(arguments, arguments[1:]) if a == '--scheme'), '')}")
    return outcome


def excused(outcome: Outcome) -> float:
    """How many times the accuracy an error may be: a warning says it, unless it is about a multiplier or the like."""
    said = MISSED.search(outcome.err)
    if outcome.err and not said:
        return inf
    return FACTOR if not said or DERIVED.fullmatch(said[1]) else max(FACTOR, ESTIMATED * float(said[3]))


def ending(outcome: Outcome) -> str:
    if outcome.done:
        return "warning" if outcome.err else "done"
    return "over its budget" if "budget" in outcome.err else f"exit {outcome.code}"


def apart(table: Table, values: Known) -> Iterator[tuple[str, float, float, float, float, int]]:
    """Of each value that the oracle knows: name, time, value, known value, its error, row."""
    for name in [name for name in table.unknowns if name in values[0]]:
        for k, (t, value) in enumerate(zip(table.times, table.column(name))):
            yield (name, t, value, *values[k][name], k)


def false_bounds(program: Program, case: Case, values: Known) -> Iterator[Fault]:
    outcome = ended(program, "exact", *case.problem(), *case.given("--at"), "--bounds", "--budget", BUDGET)
    if outcome is None:
        yield Fault("exact takes long", f"exact takes over {STOP:g} s", program.last)
    elif not outcome.done:
        program.note(f"exact: {ending(outcome)}")
    else:
        program.note("exact: done")
        table = Table.read(outcome.out)
        for name, t, value, right, off, k in apart(table, values):
            bound = table.column(f"bound_{name}" if f"bound_{name}" in table.names else "bound")[k]
            if not abs(value - right) <= bound + 3 * off + 1e-12 * (1 + abs(right)):
                yield Fault("exact", f"exact says {name} = {value!r} at t = {t:g}, bound {bound:.2g}; right is {right!r} to {off:.1g}", outcome.arguments)
                return


def misses(program: Program, case: Case, values: Known, scheme: str, accuracy: str) -> Iterator[Fault]:
    outcome = ended(program, "solve", *case.problem(), "--scheme", scheme, "--accuracy", accuracy, *case.given("--at"), "--budget", BUDGET)
    if outcome is None:
        yield Fault(f"{scheme} takes long", f"{scheme} {accuracy} takes over {STOP:g} s", program.last)
    else:
        program.note(f"{scheme}: {ending(outcome)}")
    if outcome and outcome.done:
        worst, text = 0.0, ""
        for name, t, value, right, off, _ in apart(Table.read(outcome.out), values):
            times = max(0.0, abs(value - right) - 3 * off) / (float(accuracy) * (1 + abs(right)))
            if not times <= worst:
                worst, text = times, f"{name} = {value!r} at t = {t:g} is off by {times:.3g} times {accuracy}; right is {right!r} to {off:.1g}"
        if worst > excused(outcome):
            yield Fault(scheme, f"{scheme}: {text}", outcome.arguments)


def check(program: Program, case: Case, lists: Lists) -> None:
    times = [float(t) for t in case.options["--at"].split(",")]
    try:
        values = known(case, times)
    except Uncertain as reason:
        program.note("not compared: the oracle is uncertain")
        program.doubts.append(str(reason))
        return
    faults = list(false_bounds(program, case, values))
    for word in case.words:
        faults += misses(program, case, values, *word.split(":"))
    if faults:
        raise Fault(faults[0].kind, "; and ".join(map(str, faults)), faults[0].arguments)


@must_hold(drawn_load_case, 3, kind=True)
def narrow_loads_are_seen(program: Program, case: Case, lists: Lists) -> None:
    """Pulses, ramps, bursts, boxes and switches of any width, anywhere."""
    check(program, case, lists)


@must_hold(drawn_equilibria, 3, kind=True)
def equilibria_are_those_of_the_start(program: Program, case: Case, lists: Lists) -> None:
    """Small orders with several equilibria: the root is the one that continues y(0)."""
    check(program, case, lists)


@must_hold(drawn_algebraic, 1, kind=True)
def algebraic_unknowns_are_controlled(program: Program, case: Case, lists: Lists) -> None:
    """Algebraic unknowns are as accurate as the others."""
    check(program, case, lists)


@must_hold(drawn_delays, 1, kind=True)
def delays_are_looked_up(program: Program, case: Case, lists: Lists) -> None:
    """Earlier values are as accurate as the others, also within long steps and where y jumps at the start."""
    check(program, case, lists)


@must_hold(drawn_constrained, 2, kind=True)
def constraints_with_memory_hold(program: Program, case: Case, lists: Lists) -> None:
    """Constraints with derivatives of orders below and above 1, in every formulation."""
    check(program, case, lists)
