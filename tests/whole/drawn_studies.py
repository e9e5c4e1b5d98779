# SPDX-License-Identifier: MIT
"""Random study files of few short runs, and wrong ones."""

import re
from random import Random

from drawn_numbers import typed
from drawn_scenes import Lists

RANGES = {"relaxation": {"gamma": (0.1, 1.9), "lambda": (-20, -0.1), "y0": (0.5, 2)}, "power": {"gamma": (0.1, 1), "p": (1, 3)},
          "fractional_oscillator": {}, "pendulum": {"alpha": (1.1, 1.9), "phi0": (0.1, 1)}}


def drawn_values(random: Random, low: float, high: float) -> tuple[str, bool]:
    """A value, a list, a range or a distribution of a number in [low, high]; and whether it is drawn."""
    one = typed(random.uniform(low, high), 3)
    ends = f"from = {low}, to = {high}"
    kind = random.choice(["value", "list", "step", "count", "log", "uniform", "log-uniform", "normal"])
    texts = {"value": one, "list": f"[{one}, {low}]", "step": f"{{{ends}, step = {typed((high - low) / 2, 3)}}}", "count": f"{{{ends}, count = 3}}",
             "log": f'{{{ends}, count = 2, spacing = "log"}}', "normal": f'{{distribution = "normal", mean = {one}, deviation = 0.2, {ends}}}'}
    return texts.get(kind, f'{{distribution = "{kind}", {ends}}}'), kind in ("uniform", "log-uniform", "normal")


def drawn_family(random: Random, lists: Lists) -> list[str]:
    scene = random.choice(list(RANGES))
    lines, parameters, any_drawn = ["[[family]]", f'scene = "{scene}"', "until = 1"], [], False
    for name in random.sample(list(RANGES[scene]), min(len(RANGES[scene]), random.randint(1, 2))):
        text, is_drawn = drawn_values(random, *RANGES[scene][name])
        parameters.append(f"{name} = {text}")
        any_drawn |= is_drawn
    if any_drawn:
        lines += [f"draws = {random.randint(1, 3)}", f"seed = {random.randint(0, 99)}"]
    if random.random() < 0.3:
        lines.append(f'schemes = "{random.choice(list(lists.schemes))}"')
    return lines + ["[family.parameters]", *parameters]


def drawn_study(random: Random, lists: Lists) -> tuple[str, ...]:
    lines = [f"schemes = [{', '.join(repr(one) for one in random.sample(list(lists.schemes), 2))}]", f"steps = [{random.randint(4, 20)}, {random.randint(21, 40)}]",
             "repeat = 1", "budget = 2"]
    if random.random() < 0.5:
        lines.append("accuracies = 1e-3")
    if random.random() < 0.3:
        lines.append(f'history = "{random.choice(["direct", "exponentials"])}"')
    return tuple(lines + [line for _ in range(random.randint(1, 2)) for line in drawn_family(random, lists)])


def damaged(random: Random, lines: tuple[str, ...]) -> tuple[str, ...]:
    """The study with a character, a word or a line that may make it invalid."""
    place = random.randrange(len(lines))
    line = lines[place]
    at = random.randrange(len(line) + 1)
    wrong = random.choice([line[:at] + random.choice('[]{}"=-,.#0e\x01') + line[at:], line[:at] + line[at + 1:], line + "\n" + line, "x = 1", line.replace("0", "1e999"),
                           line.replace("from", "form"), "", re.sub(r"\b\d+\b", "9223372036854775807", line), line.partition("=")[0] + "= " + random.choice(["0", "-1", "[]", '""', "true", "1979-05-27", "{}", "[[1]]"])])
    return lines[:place] + (wrong,) + lines[place + 1:]
