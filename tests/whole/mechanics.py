# SPDX-License-Identifier: MIT
"""Mechanics in files: formulations, drift and energy; and scenes that are printed as files."""

import re
from dataclasses import replace
from random import Random

from case import Case
from drawn_mechanics import drawn_mechanics
from drawn_scenes import Lists, drawn_scene
from drawn_solves import steps
from errors import end_of
from limits import PAIR, limit
from program import Fault, Program
from properties import must_hold
from table import Table

FORMULATIONS = ("integrated", "acceleration", "stabilised", "multiplier")
SWITCHES = ("step(", "sign(", "abs(", "min(", "max(", "floor(", "ceil(", "mod(")


def has_switches(case: Case) -> bool:
    return any(word in line for word in SWITCHES for line in case.file)


def drawn_formulations(random: Random, lists: Lists) -> Case:
    return Case("formulations_agree", file=drawn_mechanics(random, constrained=True))


@must_hold(drawn_formulations, 2)
def formulations_agree(program: Program, case: Case, lists: Lists) -> None:
    """The formulations that exist have one limit, within their uncertainties, unless a motion magnifies errors."""
    if has_switches(case):
        return
    until, first = repr(end_of(case, lists)), None
    for form in FORMULATIONS:
        found = limit(program, replace(case, chosen={"formulation": form}), PAIR[0], until)
        if found is None:
            continue
        for name in set(found) & set(first or ()):
            (a, off_a), (b, off_b) = first[name], found[name]
            if abs(a - b) > 4 * (off_a + off_b) + 1e-7 * (1 + abs(a)) and max(abs(a), abs(b)) < 1e3:
                raise Fault("apart", f"{name} at the end is {b!r} in the formulation {form}, {a!r} in another, these within {off_a + off_b:.1g}")
        first = first or found


def drawn_drift(random: Random, lists: Lists) -> Case:
    scheme = random.choice([name for name, one in lists.schemes.items() if one["takes_grid"]])
    return Case("integrated_has_no_drift", scheme=scheme, file=drawn_mechanics(random, constrained=True), chosen={"formulation": "integrated"},
                options={"--steps": str(random.randint(1, 3000)), "--budget": "2"})


@must_hold(drawn_drift, 1)
def integrated_has_no_drift(program: Program, case: Case, lists: Lists) -> None:
    """The constraints hold to rounding, except those of order above 1, whose integral is a row."""
    ended = program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given())
    if not ended.done or any(re.search(r"D\(\w+, 1\.", line) for line in case.file if line.startswith("constraints")):
        return
    table = Table.read(ended.out)
    size = max(abs(value) for name in table.unknowns for value in table.column(name))
    for name in (name for name in table.names if name.startswith("constraint")):
        drift = max(map(abs, table.column(name)))
        if drift > 1e-12 * (1 + size) ** 2:
            raise Fault("drift", f"{name} is {drift:.3g}, where columns are up to {size:.3g}")


def drawn_energy(random: Random, lists: Lists) -> Case:
    return Case("energy_is_the_work_of_reactions", file=drawn_mechanics(random, constrained=random.random() < 0.6, forced=False),
                options={"--scheme": PAIR[0], "--budget": "3"})


@must_hold(drawn_energy, 1)
def energy_is_the_work_of_reactions(program: Program, case: Case, lists: Lists) -> None:
    """Without forces the energy changes by the integral of the power column, or not at all: the difference vanishes with the step."""
    left = []
    for number in (500, 4000):
        ended = program.run("solve", *case.problem(), *case.given(), "--steps", str(number))
        if not ended.done or "energy" not in (table := Table.read(ended.out)).names:
            return
        energy = table.column("energy")
        work = 0.0
        if "power" in table.names:
            power, times = table.column("power"), table.times
            if power[0] != power[0] or max(map(abs, power[:5])) > 10 * max(map(abs, power[5:])):
                return  # unbounded at the start
            work = sum((a + b) / 2 * (t - s) for a, b, s, t in zip(power, power[1:], times, times[1:]))
        left.append(abs(energy[-1] - energy[0] - work) / (1 + max(map(abs, energy))))
    if left[1] > 1e-3 and left[1] > 0.5 * left[0]:
        raise Fault("energy", f"the change of the energy without the work is {left[1]:.3g} of it with 4000 steps, {left[0]:.3g} with 500")


def drawn_printed(random: Random, lists: Lists) -> Case:
    scene, chosen = drawn_scene(random, lists, 0.1)
    scheme = random.choice([name for name, one in lists.schemes.items() if one["takes_grid"]])
    return Case("a_printed_scene_is_the_scene", scene=scene, chosen=chosen, scheme=scheme, options={"--steps": steps(random), "--budget": "2", "--points": "7"})


@must_hold(drawn_printed, 1.5)
def a_printed_scene_is_the_scene(program: Program, case: Case, lists: Lists) -> None:
    """What `scenes ID --toml` prints has the same values as a file, and by its name in $FDEBENCH_SCENES."""
    printed = program.run("scenes", case.scene, "--toml")
    scene = program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given())
    if not printed.done:
        return
    file = replace(case, scene="", file=tuple(printed.out.splitlines()))
    file.write(program.folder)
    folder = program.folder / "scenes"
    folder.mkdir()
    (folder / "mine.toml").write_text(printed.out)
    program.environment["FDEBENCH_SCENES"] = str(folder)
    try:
        others = [program.run("solve", *one.problem(), "--scheme", case.scheme, *case.given()) for one in (file, replace(case, scene="mine"))]
    finally:
        del program.environment["FDEBENCH_SCENES"]
    for other in others:
        if any("budget" in one.err for one in (scene, other)) or "no such parameter" in other.err:
            continue  # a scene may have more parameters than its file, as that of the surface which chooses the file
        if other.code != scene.code:
            raise Fault("code", f"the scene: {scene.code} {scene.err.strip()}; as a file: {other.code} {other.err.strip()}", other.arguments)
        if not scene.done:
            continue
        ours, theirs = Table.read(scene.out), Table.read(other.out)
        for name in ["t", *ours.unknowns]:
            if name not in theirs.names:
                raise Fault("column", f"the file has no column {name}", other.arguments)
            if ours.column(name) != theirs.column(name):
                raise Fault("differs", f"{name} is {ours.column(name)[-1]!r} at the end, as a file {theirs.column(name)[-1]!r}", other.arguments)
