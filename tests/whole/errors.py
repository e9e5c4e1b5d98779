# SPDX-License-Identifier: MIT
"""Schemes with adaptive step size deliver the requested accuracy, to a factor of ten, where there is a reference."""

import re
from dataclasses import replace
from random import Random

from case import Case
from drawn_numbers import spread, typed
from drawn_scenes import Lists
from drawn_solves import accuracy, drawn_problem
from limits import crude_limit
from program import Fault, Outcome, Program
from properties import must_hold
from table import Table, check_finite

INITIAL = re.compile(r"d?[a-z]+0|q[0-9]|v[0-9]")
ORDERS = ("gamma", "gamma1", "gamma2", "alpha", "beta", "nu", "order")
NUMBER = re.compile(r"(?<![\w.])\d+\.?\d*(?:e[+-]?\d+)?(?![\w.])")
FACTOR = 10
MISSED = re.compile(r"(\S+) at t = (\S+) is off by about (\S+) times the accuracy")
ESTIMATED = 3  # a warning's estimate of the error may be too small by this factor


def end_of(case: Case, lists: Lists) -> float:
    if "until" in case.chosen:
        return float(case.chosen["until"])
    if case.scene:
        return float(lists.scenes[case.scene]["end"])
    return float(next((line for line in case.file if line.startswith("end")), "end = 0").split("=")[1])


def drawn_accuracy(random: Random, lists: Lists) -> Case:
    takers = lists.takers("takes_accuracy")
    scheme = random.choice([*takers, "spectral_collocation"])
    smallest = {"spectral_collocation": 1e-13, "adaptive_pc": 1e-9}.get(scheme, 1e-10)
    case = Case("accuracy_is_delivered", scheme=scheme, options={"--accuracy": accuracy(random, smallest), "--budget": "3"},
                **drawn_problem(random, lists, files=0.35, wild=0.2, events=False, having=random.choice(["", "exact", "linear", "linear", "linear"])))
    fractions = sorted({1.0, *(spread(random, 0.02, 1) for _ in range(random.randint(1, 5)))})
    times = ",".join(typed(end_of(case, lists) * f, 3) for f in fractions[:-1])
    return replace(case, options={**case.options, "--at": times + ("," if times else "") + repr(end_of(case, lists))})


def perturbed(case: Case, size: float) -> Case:
    """The case with initial values perturbed by `size` (1 + |value|)."""
    def moved(text: str) -> str:
        if '"' in text:
            return text
        value = float(text)
        return repr(value + size * (1 + abs(value)))

    def moved_line(line: str) -> str:
        name, _, value = line.partition(" = ")
        if name == "initial":
            return "initial = [" + ", ".join(map(moved, value[1:-1].split(", "))) + "]"
        return f"{name} = {moved(value)}" if INITIAL.fullmatch(name) else line

    if case.scene:
        return replace(case, chosen={k: moved(v) if INITIAL.fullmatch(k) else v for k, v in case.chosen.items()})
    return replace(case, file=tuple(map(moved_line, case.file)))


def solved(program: Program, case: Case, accuracy: float) -> Table | None:
    """The solution to a tenth of the accuracy, by the first of two schemes that finishes."""
    for scheme in ("radau_exponentials", "spectral_collocation"):
        ended = program.run("solve", *case.problem(), "--scheme", scheme, "--accuracy", f"{max(accuracy / 10, 1e-13):g}", *case.given("--at"), "--budget", "3")
        if ended.done:
            return Table.read(ended.out)
    return None


def conditioning(program: Program, case: Case, accuracy: float) -> dict[str, list[float]] | None:
    """The change of the solution at the output times when all initial values are perturbed by the accuracy; None if unknown."""
    size = max(accuracy, 1e-9)
    here, there = solved(program, case, min(accuracy, size / 10)), None
    moved = perturbed(case, size)
    if here is not None and moved != case:
        moved.write(program.folder)
        there = solved(program, moved, min(accuracy, size / 10))
        case.write(program.folder)
    if here is None or there is None or here.times != there.times:
        return None
    return {name: [abs(a - b) * (accuracy / size) ** 0.5 for a, b in zip(here.column(name), there.column(name))] for name in here.unknowns}


def worst(case: Case, table: Table, exact: Table, accuracy: float, moved: dict[str, list[float]] | None) -> tuple[float, str]:
    """The largest error divided by its tolerance: accuracy (1 + |y|) plus the effect `moved` of perturbed initial values."""
    found, jumps = (0.0, ""), decimals(case)
    for name in [name for name in table.unknowns if name in exact.names]:
        for k, (value, known, bound, t) in enumerate(zip(table.column(name), exact.column(name), exact.column("bound"), table.times)):
            allowed = accuracy * (1 + abs(known)) + bound + 4e-16 * abs(known) + (moved[name][k] if moved and name in moved else 0)
            if t not in jumps or case.scene:
                found = max(found, (abs(value - known) / allowed, f"{name} at t = {t:g} is {value!r}, known {known!r}, bound {bound:g}"))
    return found


def asked(program: Program, case: Case) -> Outcome:
    return program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given())


def decimals(case: Case) -> set[float]:
    """All numbers of a file: a time among them may be a jump, where the value is one of two limits."""
    return {float(number) for line in case.file for number in NUMBER.findall(line)}


def admitted(ended: Outcome) -> float:
    """The allowed error of a run as a multiple of its tolerance: FACTOR, or the estimate in its warning."""
    said = MISSED.search(ended.err)
    return max(FACTOR, ESTIMATED * float(said[3]) if said else 0)


def check_the_warning(ended: Outcome, table: Table, exact: Table, accuracy: float) -> None:
    """Checks a warning: the error is at least a tenth of its estimate."""
    said = MISSED.search(ended.err)
    if not said or said[1] not in exact.names:
        return
    row = min(range(len(table.times)), key=lambda k: abs(table.times[k] - float(said[2])))
    value, known = table.column(said[1])[row], exact.column(said[1])[row]
    times = (abs(value - known) + exact.column("bound")[row]) / (accuracy * (1 + abs(value)))
    if times < float(said[3]) / 10:
        raise Fault("warning", f"says {said[0]}, but {value!r} is off by {times:.3g} times, known {known!r}", ended.arguments)


def least_gap(case: Case) -> float:
    """The smallest order of a row of a multi-term chain: the least difference between orders and the integers 0, 1, 2."""
    if case.scene:
        orders = [float(v) for k, v in case.chosen.items() if k in ORDERS and "," not in v]
    else:
        orders = [float(q) for line in case.file if line.startswith(("order", "terms")) for q in re.findall(r"(?:, |= )([\d.e-]+)\]?", line)]
        orders += [float(q) for line in case.file for q in re.findall(r"D\(\w+, ([\d.e-]+)\)", line)]
    known = {0.0, 1.0, 2.0, *orders}
    return min(abs(a - b) for a in known for b in known if a != b)


def ends_there(case: Case) -> bool:
    """Cases in which these schemes fail according to docs/adaptive.md and docs/spectral.md: very small orders, small orders
    with jumps, and sliding along a discontinuity in an unknown."""
    text = " ".join(case.file)
    jumps = case.scene == "bagley_torvik" or "[[jump]]" in text or re.search(r"(step|sign|floor|ceil|mod)\(", text) is not None
    slides = re.search(r"(step|sign|floor|ceil|mod)\([^()]*(x|y|z|w|D\()", text) is not None
    gap = least_gap(case)
    least = {"radau_exponentials": 0.03, "adaptive_pc": 0.17}.get(case.scheme, 0.006)
    return gap < least or slides or (case.scheme != "spectral_collocation" and jumps and gap < 0.17)


def gives_up(program: Program, case: Case, lists: Lists, exact: Table, ended: Outcome) -> bool:
    """Whether the run did not converge although another scheme delivers the accuracy; documented failures are left out."""
    if "converge" not in ended.err or ends_there(case):
        return False
    for scheme in lists.takers("takes_accuracy"):
        if scheme != case.scheme:
            other = asked(program, replace(case, scheme=scheme))
            if other.done and worst(case, Table.read(other.out), exact, float(case.options["--accuracy"]), None)[0] <= FACTOR:
                return True
    return False


def check_the_end(program: Program, case: Case, lists: Lists, ended: Outcome, accuracy: float) -> None:
    """Without a reference: compares the end with the limit of schemes on grids."""
    until = case.options["--at"].split(",")[-1]
    if float(until) != end_of(case, lists) or float(until) in decimals(case) and f"end = {until}" not in case.file:
        return
    table, moved = Table.read(ended.out), None
    for name, (value, off) in crude_limit(program, case, until).items():
        ours = table.column(name)[-1]
        allowed = admitted(ended) * (accuracy * (1 + abs(value)) + off)
        if abs(ours - value) > allowed:
            moved = moved or conditioning(program, case, accuracy) or {}
            if abs(ours - value) > allowed + admitted(ended) * moved.get(name, [0.0])[-1]:
                raise Fault("end", f"{case.scheme} says {name} = {ours!r} at the end, {value!r} to {off:.2g} is what schemes over grids tend to", ended.arguments)


@must_hold(drawn_accuracy, 6)
def accuracy_is_delivered(program: Program, case: Case, lists: Lists) -> None:
    """The error is within ten times the accuracy, relative to 1 + |y|, unless a warning says more or the problem magnifies
    perturbations."""
    ended = asked(program, case)
    if ended.code == 2:
        return
    known = program.run("exact", *case.problem(), *case.given("--at"), "--budget", "4")
    wanted = float(case.options["--accuracy"])
    if not known.done:
        if ended.done:
            check_the_end(program, case, lists, ended, wanted)
        return
    exact = Table.read(known.out)
    if not ended.done:
        if gives_up(program, case, lists, exact, ended):
            raise Fault("gives up", f"ends where others deliver: {ended.err.strip()}", ended.arguments)
        return
    table = Table.read(ended.out)
    check_finite(table)
    if table.times != exact.times:
        raise Fault("times", f"solve has the times {table.times}, exact {exact.times}")
    check_the_warning(ended, table, exact, wanted)
    times, where = worst(case, table, exact, wanted, None)
    if times > admitted(ended):
        times, where = worst(case, table, exact, wanted, conditioning(program, case, wanted))
    if times > admitted(ended):
        raise Fault("error", f"{case.scheme} is off by {times:.3g} times what is asked: {where}", ended.arguments)
