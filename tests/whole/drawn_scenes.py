# SPDX-License-Identifier: MIT
"""Scenes with random parameters, from the list of `fdebench scenes --json`; and the list of schemes."""

import json
from dataclasses import dataclass
from random import Random

from drawn_numbers import drawn, spread, typed
from program import Program

LARGE = {"fractional_diffusion", "fractional_diffusion_2d", "fractional_allen_cahn"}


@dataclass(frozen=True)
class Lists:
    """The scenes and schemes that the program lists, by id."""

    scenes: dict[str, dict]
    schemes: dict[str, dict]

    @staticmethod
    def read(program: Program) -> "Lists":
        lists = [json.loads(program.run(name, "--json").out) for name in ("scenes", "schemes")]
        return Lists(*({one["id"]: one for one in each} for each in lists))

    def takers(self, key: str) -> list[str]:
        return [name for name, scheme in self.schemes.items() if scheme[key]]


def drawn_scene(random: Random, lists: Lists, wild: float = 0.3, having: str = "") -> tuple[str, dict[str, str]]:
    """A random scene with some random parameters and sometimes a random end."""
    names = [name for name, scene in lists.scenes.items() if having in scene["has"] or not having]
    name = random.choice(names)
    scene, chosen = lists.scenes[name], {}
    is_wild, some = random.random() < wild, random.choice([0.0, 0.4, 0.8, 1.0, 1.0])
    for parameter in scene["parameters"]:
        if random.random() < some:
            chosen[parameter["name"]] = drawn(random, parameter["name"], parameter["default"], parameter["allowed"], is_wild)
    if random.random() < 0.5:
        chosen["until"] = typed(scene["end"] * spread(random, 0.01, 8), 3)
    if name in LARGE:
        # The reference of a nonlinear problem eliminates a dense matrix of 20 rows an unknown: on a square, n^2 unknowns.
        most = 8 if name == "fractional_allen_cahn" else 12
        chosen["components" if name == "fractional_diffusion" else "n"] = str(random.randint(2, most))
    return name, chosen
