# SPDX-License-Identifier: MIT
"""Random mechanics in equation files: a Lagrangian, forces, constraints. Starts are parameters x0 and dx0, in which constraints are
shifted to 0, so that other starts meet them too."""

import re
from random import Random

from drawn_formulas import drive, number, signed, smooth, switch
from drawn_numbers import spread, typed

MEMORY = re.compile(r"D\((\w+), ([^)]*)\)")


def small(random: Random) -> str:
    return typed(random.uniform(-0.6, 0.6), 2)


def memory_order(random: Random, most: float = 0.98) -> str:
    return typed(random.choice([random.uniform(0.05, most), 0.5, 0.3, random.choice([0.02, 0.97])]), 2)


def kinetic(random: Random, names: list[str]) -> list[str]:
    """Half of a positive definite form in the velocities: constant, diagonal or coupled."""
    kind, terms = random.choice(["constant", "diagonal", "coupled"]), []
    for name in names:
        other = random.choice(names)
        mass = {"diagonal": f"({number(random)} + sin({other})^2)", "coupled": f"(2 + {other}^2)"}.get(kind, number(random))
        terms.append(f"{mass}*D({name}, 1)^2/2")
    if kind == "coupled":
        terms += [f"{small(random)}*cos({a} - {b})*D({a}, 1)*D({b}, 1)" for a, b in zip(names, names[1:])]
    return terms


def potential(random: Random, names: list[str]) -> list[str]:
    terms = []
    for _ in range(random.randint(0, 3)):
        x, y, k = random.choice(names), random.choice(names), number(random)
        terms.append(random.choice([f"-{k}*{x}^2/2", f"-{x}^4/4", f"{k}*cos({x})", f"-{k}*({x} - {y})^2/2", f"{small(random)}*{x}", f"-{k}*{x}", f"{small(random)}*{x}*sin(t)"]))
    return terms


def force(random: Random, name: str, names: list[str]) -> str:
    x = random.choice(names)
    chances = [f"-{number(random)}*D({name}, {memory_order(random)})", f"-{number(random)}*D({name}, {memory_order(random)})", f"-{number(random)}*D({name}, 1)",
               f"-{number(random)}*D({name}, {typed(random.uniform(1.02, 1.95), 3)})", drive(random), smooth(random, x), f"-{small(random)}*{name}*D({x}, 1)"]
    if random.random() < 0.2:
        chances = [switch(random, x), switch(random, f"D({name}, 1)")]
    return " + ".join(random.choice(chances) for _ in range(random.randint(1, 2)))


def at_start(formula: str) -> str:
    """A formula with its values at the start in place of its variables."""
    formula = MEMORY.sub(lambda found: f"d{found[1]}0" if found[2] == "1" else "0", formula)
    return re.sub(r"\bt\b", "0", re.sub(r"\b[xyz]\b", lambda found: found[0] + "0", formula))


def constraint(random: Random, names: list[str]) -> str:
    """The last name is the one whose velocity is constrained, with a coefficient that is not 0 near the start."""
    first, last = names[0], names[-1]
    terms = [f"D({last}, 1)", random.choice([f"{small(random)}*D({first}, 1)", f"{first}*D({first}, 1)", f"sin({last})*D({first}, 1)", f"{small(random)}*t*D({first}, 1)"])]
    for _ in range(random.choice([0, 1, 1, 2])):
        x = random.choice(names)
        factor = random.choice([small(random), small(random), f"{small(random)}*cos({first})"])
        terms.append(f"{factor}*D({x}, {memory_order(random)})")
    terms += random.choice([[], [], [f"{small(random)}*sin(t)"], [f"{small(random)}*{first}"], [f"0.1*D({first}, 1)^2"], [f"0.3*D({first}, {typed(random.uniform(1.05, 1.9), 3)})"]])
    return " + ".join(terms)


def constraints(random: Random, names: list[str], meets: bool) -> list[str]:
    found = []
    for k in range(random.randint(1, min(2, len(names) - 1))):
        formula = constraint(random, names[: len(names) - k])
        found.append(f"{formula} - ({at_start(formula)})" if meets else formula)
    return found


def additions(random: Random, names: list[str]) -> list[str]:
    x, lines = random.choice(names), []
    if random.random() < 0.2:
        lines += ["[columns]", f'place = "{x}"', f'rate = "D({x}, 1)"']
    if random.random() < 0.15:
        lines += ["[domain]", f'positive = "{x} + {number(random)}"', 'edge = "the wall"']
    if random.random() < 0.15:
        lines += ["[path]", f'x = "{names[0]}"', f'y = "sin({names[-1]})"']
    return lines


def starts(random: Random, names: list[str]) -> tuple[list[str], list[str]]:
    parameters, coordinates = [], []
    for name in names:
        parameters += [f"{name}0 = {random.choice(['0', '1', signed(random)])}", f"d{name}0 = {random.choice(['0', '1', signed(random)])}"]
        coordinates += [f"[coordinate.{name}]", f'initial = ["{name}0", "d{name}0"]']
    return parameters, coordinates


def extremum(random: Random, names: list[str]) -> tuple[str, ...]:
    """Values at both ends, and derivatives of fractional order in the Lagrangian."""
    memory, lines = random.random() < 0.7, [f"end = {typed(spread(random, 0.3, 2), 3)}"]
    for name in names:
        lines += [f"[coordinate.{name}]", f"initial = [{signed(random)}]"] + ([f"final = [{signed(random)}]"] if random.random() < 0.8 else [])
    order = memory_order(random)
    terms = [f"D({name}, 1)^2/2" for name in names] if random.random() < 0.8 else [f"D({name}, {order})^2/2" for name in names]
    if memory:
        terms.append(f"{number(random)}*D({random.choice(names)}, {order})^2/2")
    terms += random.choice([[], [f"-{number(random)}*{names[0]}^2/2"], [f"{number(random)}*cos({names[0]})"], [f"{small(random)}*{names[-1]}*t"]])
    lines += ["[mechanics]", f'lagrangian = "{" + ".join(terms)}"']
    if len(names) > 1 and random.random() < 0.5:
        lines += ['principle = "vakonomic"', f'constraints = ["D({names[-1]}, 1) + {small(random)}*D({names[0]}, {random.choice([order, "1"])}) + {small(random)}*{names[0]}"]']
    return tuple(lines)


def drawn_mechanics(random: Random, rows: int = 0, constrained: bool | None = None, forced: bool | None = None) -> tuple[str, ...]:
    """Lines of a file; with constraints and forces, or without, where asked to be."""
    names = ["x", "y", "z"][: rows or random.choice([2, 2, 3] if constrained else [1, 2, 2, 3])]
    if constrained is None and random.random() < 0.15:
        return extremum(random, names)
    parameters, coordinates = starts(random, names)
    with_constraints = len(names) > 1 and (random.random() < 0.6 if constrained is None else constrained)
    lagrangian = " + ".join(kinetic(random, names) + potential(random, names))
    lines = [f"end = {typed(spread(random, 0.3, 5), 3)}", "[parameters]", *parameters, *coordinates, "[mechanics]", f'lagrangian = "{lagrangian}"']
    if with_constraints:
        met = ", ".join(f'"{one}"' for one in constraints(random, names, random.random() < 0.95))
        lines.append(f"constraints = [{met}]")
        if constrained is None and random.random() < 0.1:
            lines.append('principle = "vakonomic"')
        elif constrained is None and random.random() < 0.4:
            lines.append(f'formulation = "{random.choice(["integrated", "acceleration", "stabilised", "multiplier"])}"')
    if forced is None and random.random() < 0.6 or forced:
        lines += ["[mechanics.forces]", *(f'{name} = "{force(random, name, names)}"' for name in names if random.random() < 0.7)]
    return (*lines, *additions(random, names))


def free() -> tuple[str, ...]:
    """A motion that is known."""
    return ("end = 2", "[parameters]", "x0 = 0.5", "dx0 = -1", "[coordinate.x]", 'initial = ["x0", "dx0"]', "[mechanics]", 'lagrangian = "D(x, 1)^2/2"',
            "[exact]", 'x = "x0 + dx0*t"')
