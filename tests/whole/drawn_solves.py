# SPDX-License-Identifier: MIT
"""Random calls of solve: a problem, a scheme, and any combination of options."""

from random import Random

from case import Case
from drawn_files import drawn_file
from drawn_numbers import spread, typed
from drawn_scenes import Lists, drawn_scene

BUDGET = "2"


def drawn_problem(random: Random, lists: Lists, files: float = 0.4, wild: float = 0.3, events: bool = True, having: str = "") -> dict:
    if random.random() < files:
        return {"file": drawn_file(random, events=events)}
    scene, chosen = drawn_scene(random, lists, wild, having)
    return {"scene": scene, "chosen": chosen}


def steps(random: Random) -> str:
    """1 to 100,000 steps, mostly few."""
    return str(random.choice([random.randint(1, 12), int(spread(random, 10, 1000)), int(spread(random, 1000, 100_000)), random.randint(1000, 100_000)]))


def accuracy(random: Random, smallest: float) -> str:
    return typed(spread(random, smallest, 1e-2), 3)


def resolution(random: Random, lists: Lists, scheme: str) -> dict[str, str]:
    if lists.schemes[scheme]["takes_accuracy"]:
        return {"--accuracy": accuracy(random, 1e-7 if scheme in ("adaptive_trapezoidal", "adaptive_pc") else 1e-12)}
    return {"--steps": steps(random)}


def drawn_options(random: Random, lists: Lists, scheme: str) -> dict[str, str]:
    """Options that the scheme takes; in one of ten cases also options that it does not take."""
    over_grid = not lists.schemes[scheme]["takes_accuracy"] or random.random() < 0.1
    chosen = resolution(random, lists, scheme) | {"--budget": BUDGET}

    def maybe(name: str, chance: float, value: str = "") -> None:
        if random.random() < chance:
            chosen[name] = value

    if over_grid:
        maybe("--grid", 0.3, random.choice(["uniform", "graded:auto", f"graded:{typed(random.uniform(1, 4), 2)}"]))
        maybe("--history", 0.3, random.choice(["auto", "direct", "exponentials"]))
        maybe("--tolerance", 0.2, accuracy(random, 1e-14))
    output = random.choice(["", "", "--every", "--points", "--at"])
    if output:
        chosen[output] = {"--every": str(random.randint(1, 50)), "--points": str(random.randint(2, 40)), "--at": "0"}[output]
    maybe("--threads", 0.15, str(random.randint(1, 4)))
    maybe("--checkpoint", 0.15, "state")
    if "--checkpoint" in chosen:
        maybe("--checkpoint-every", 0.5, random.choice(["0", "1", "300"]))
    for flag in ("--check", "--strict", "--cost"):
        maybe(flag, 0.1)
    maybe("--all", 0.05)
    maybe("--events", 0.1 if not over_grid else 0.02)
    return chosen


def drawn_solve(random: Random, lists: Lists) -> Case:
    scheme = random.choice(list(lists.schemes))
    return Case("solve_ends_as_it_says", scheme=scheme, options=drawn_options(random, lists, scheme), **drawn_problem(random, lists))
