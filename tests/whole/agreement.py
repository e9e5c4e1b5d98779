# SPDX-License-Identifier: MIT
"""`exact`, two schemes of different families and the plain solver agree on files of every kind, with resets above all."""

from itertools import combinations
from random import Random

from case import Case
from drawn_files import drawn_file, with_resets
from drawn_numbers import spread, typed
from drawn_scenes import Lists
from errors import MISSED, admitted, conditioning, decimals, end_of
from plain_formulas import Uncertain
from plain_solver import solution
from program import Fault, Program
from properties import must_hold
from solving import moved
from table import Table, check_finite

FAMILIES = ("radau_exponentials", "spectral_collocation", ("adaptive_trapezoidal", "adaptive_pc"))
Values = list[dict[str, tuple[float, float]]]  # at each time the columns, with their errors


def drawn_agreement(random: Random, lists: Lists) -> Case:
    file = drawn_file(random, events=False, rare=2)
    if random.random() < 0.8:
        file = with_resets(random, file)
    end, begin = end_of(Case("", file=file), lists), random.choice(["1", "0.1", "2.5"])
    later = moved(file, begin) if random.random() < 0.15 else None
    times = [(float(begin) if later else 0.0) + end * part for part in (random.uniform(0.05, 1), random.uniform(0.3, 1), 1)]
    schemes = [one if isinstance(one, str) else random.choice(one) for one in random.sample(FAMILIES, 2)]
    words = tuple(f"{one}:{typed(spread(random, 1e-5 if one.startswith('adaptive') else 1e-8, 1e-4), 2)}" for one in schemes)
    return Case("exact_and_schemes_agree", file=later or file, words=words, options={"--at": ",".join(typed(t, 6) for t in sorted(times))})


def of_exact(program: Program, case: Case) -> Values | None:
    ended = program.run("exact", *case.problem(), *case.given("--at"), "--bounds", "--budget", "4")
    program.note(f"exact: {'done' if ended.done else f'exit {ended.code}'}")
    if not ended.done:
        return None
    table = Table.read(ended.out)
    check_finite(table)
    bounds = {name: table.column(f"bound_{name}" if f"bound_{name}" in table.names else "bound") for name in table.unknowns}
    return [{name: (table.column(name)[k], bounds[name][k]) for name in table.unknowns} for k in range(len(table.times))]


def of_scheme(program: Program, case: Case, scheme: str, accuracy: str) -> Values | None:
    """Nothing if a warning leaves it open how large the error is."""
    ended = program.run("solve", *case.problem(), "--scheme", scheme, "--accuracy", accuracy, *case.given("--at"), "--budget", "3")
    program.note(f"{scheme}: {'done' if ended.done else f'exit {ended.code}'}")
    if not ended.done or (ended.err and not MISSED.search(ended.err)):
        return None
    table = Table.read(ended.out)
    allowed = admitted(ended) * float(accuracy)
    return [{name: (value := table.column(name)[k], allowed * (1 + abs(value))) for name in table.unknowns} for k in range(len(table.times))]


def of_plain_solver(program: Program, case: Case, times: list[float]) -> Values | None:
    try:
        found = solution("\n".join(case.file), times)
    except Uncertain as reason:
        program.note(f"plain solver: {str(reason)[:30]}")
        return None
    program.note("plain solver: done")
    return found


@must_hold(drawn_agreement, 5)
def exact_and_schemes_agree(program: Program, case: Case, lists: Lists) -> None:
    """Values of `exact`, two schemes and the plain solver differ by no more than their bounds and errors, and what perturbed initial
    values do."""
    times = [float(t) for t in case.options["--at"].split(",")]
    known = {"exact": of_exact(program, case), "the plain solver": of_plain_solver(program, case, times)}
    known |= {word: of_scheme(program, case, *word.split(":")) for word in case.words}
    done = {name: values for name, values in known.items() if values}
    effects: dict[str, list[float]] | None = None
    for (one, ours), (other, theirs) in combinations(done.items(), 2):
        program.note(f"compared: {' and '.join(sorted(name.split(':')[0] for name in (one, other)))}")
        for k, t in enumerate(times):
            for name in ours[k].keys() & theirs[k].keys():
                (a, off_a), (b, off_b) = ours[k][name], theirs[k][name]
                if t in decimals(case) and t != times[-1] or abs(a - b) <= off_a + off_b + 1e-13 * abs(a):
                    continue
                effects = effects if effects is not None else conditioning(program, case, 1e-6) or {}
                if not abs(a - b) <= off_a + off_b + 10 * effects.get(name, [0.0] * len(times))[k]:
                    all_of_them = ", ".join(f"{of} {values[k][name][0]!r} to {values[k][name][1]:.2g}" for of, values in done.items() if name in values[k])
                    raise Fault("apart", f"{name} at t = {t:g}: {all_of_them}", program.last)
