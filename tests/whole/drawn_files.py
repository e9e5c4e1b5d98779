# SPDX-License-Identifier: MIT
"""Random equation files."""

import math
import re
from pathlib import Path
from random import Random

from drawn_formulas import drive, frequency, number, right_side, signed, switch
from drawn_mechanics import drawn_mechanics, free
from drawn_numbers import spread, typed

EXAMPLES = Path(__file__).parents[2] / "docs/examples"


def order(random: Random) -> float:
    """A random order in (0, 2], often close to 0, 1 or 2, or equal to 1 or 2; sometimes one up to 4."""
    if random.random() < 0.07:
        return random.choice([3, 4, round(random.uniform(2.05, 3.95), 2)])
    near = random.choice([0, 1, 1, 2]) + random.choice([-1, 1]) * random.choice([1e-3, 0.01, 0.05, 0.1])
    return random.choice([round(random.uniform(0.1, 2), 2), random.choice([0.5, 1, 1.5, 2, 0.8]), near if 0 < near <= 2 else 0.5])


def earlier(random: Random, names: list[str], parameters: list[str]) -> list[str]:
    """Earlier values of unknowns."""
    return [f"{random.choice(names)}(t - {random.choice([number(random), number(random), *parameters])})" for _ in range(random.randint(1, 2))]


def at_end(random: Random, name: str, initial: list[str]) -> str:
    """Values at the end in place of the last initial values, which are removed."""
    columns = [name, *(f"D({name}, {k})" for k in range(1, len(initial)))]
    given = random.sample(columns, random.randint(1, len(initial) - 1))
    values = [initial.pop() for _ in given]
    return f"final = [{values[0]}]" if given == [name] else f"final = {{ {', '.join(f'{chr(34)}{c}{chr(34)} = {v}' for c, v in zip(given, values))} }}"


def unknown(random: Random, name: str, names: list[str], parameters: list[str], several: bool, delays: bool) -> list[str]:
    leading, lines, nodes = order(random), [f"[unknown.{name}]"], []
    terms = [[number(random) if several else "1", typed(leading)]]
    if several:
        lower = {typed(random.uniform(0.05, leading * 0.95), 2) for _ in range(random.randint(1, 2))}
        terms += [[number(random), q] for q in sorted(lower, reverse=True)]
        nodes = [f"D({name}, {q})" for q in lower]
    lines.append(f"terms = [{', '.join(f'[{c}, {q}]' for c, q in terms)}]" if several or random.random() < 0.3 else f"order = {typed(leading)}")
    known = names + nodes + (earlier(random, names, parameters) if delays else [])
    if delays and leading > 1 and random.random() < 0.3:
        known.append(f"D({name}, {random.randint(1, math.ceil(leading) - 1)})(t - {number(random)})")
    lines.append(f'rhs = "{right_side(random, name, known, parameters)}"')
    initial = [random.choice(["0", "1", signed(random)]) for _ in range(max(1, math.ceil(leading)))]
    if len(initial) > 1 and random.random() < 0.12:
        lines.append(at_end(random, name, initial))
    lines.append(f"initial = [{', '.join(initial)}]")
    if delays:
        lines.append(f'before = "{random.choice([initial[0], initial[0], f"{initial[0]}*cos(t)", "0", f"{initial[0]} + t"])}"')
    return lines


def event(random: Random, name: str, resets: bool = False) -> list[str]:
    zero = random.choice([f"{name} - {number(random)}", f"sin({frequency(random)}*t)", f"{name}*cos({frequency(random)}*t)"])
    lines = [f"[event.{random.choice('abc')}]", f'zero = "{zero}"']
    if random.random() < 0.3:
        lines.append(f'crossing = "{random.choice(["rising", "falling"])}"')
    if (chance := random.random()) < 0.2:
        lines.append("ends = true")
    elif chance < 0.4 and resets:
        lines.append(f'set = {{ {name} = "{random.choice([number(random), f"{name}/2", f"{name} - 1", f"-0.8*{name}"])}" }}')
    return lines


def with_resets(random: Random, file: tuple[str, ...]) -> tuple[str, ...]:
    """The file with one or two events that set unknowns or derivatives, where it may have them."""
    text = "\n".join(file)
    rows = re.findall(r"\[unknown\.([x-z])\]\n(?:order = ([\d.]+)|terms = \[\[\d\S*, ([\d.]+))", text)
    if not rows or any(word in text for word in ("final", "before", "[mechanics]", "[event", "[exact]")):
        return file
    lines = []
    for letter in random.sample("abc", random.choice([1, 1, 2])):
        (name, *orders), a = random.choice(rows), number(random)
        target = f"D({name},1)" if float(max(orders)) > 1 and random.random() < 0.6 else name
        zero = random.choice([f"t - {a}", f"sin({frequency(random)}*t)", f"(t - {a})*(t - {a} - {typed(spread(random, 1e-3, 1), 2)})", f"{target} - {signed(random)}",
                              f"{target} - {signed(random)}", f"{name}^2 - {a}", f"{name} - {a}*sin(t)", f"exp(-((t - {a})/{typed(spread(random, 1e-3, 0.3), 2)})^2) - 0.5"])
        value = random.choice([number(random), f"{target}/2", f"{target} + {a}", f"-0.8*{target}", f"{target} - t"])
        crossing = random.choice([[], [], ['crossing = "rising"'], ['crossing = "falling"']])
        lines += [f"[event.{letter}]", f'zero = "{zero}"', *crossing, f"set = {{ {chr(34) if '(' in target else ''}{target}{chr(34) if '(' in target else ''} = \"{value}\" }}"]
    return (*file, *lines)


def of_distributed_order(random: Random, name: str, names: list[str], parameters: list[str]) -> list[str]:
    """An unknown with a term of distributed order, sometimes beside another one."""
    to, weight = random.choice([0.5, 1, 1, 2]), random.choice(["1", "1 + q", "exp(-q)", f"{number(random)}^q", "2 + sin(3*q)"])
    terms = [f'{{ weight = "{weight}", from = {random.choice([0, 0, 0.2])}, to = {to} }}', *([f"[{number(random)}, {typed(random.uniform(0.1, to), 2)}]"] if random.random() < 0.3 else [])]
    initial = [random.choice(["0", "1", signed(random)]) for _ in range(max(1, to))]
    return [f"[unknown.{name}]", f"terms = [{', '.join(terms)}]", f'rhs = "{right_side(random, name, names, parameters)}"', f"initial = [{', '.join(initial)}]"]


def singular(random: Random) -> list[str]:
    """An unknown v with a Riemann-Liouville derivative."""
    q = typed(random.choice([0.5, random.uniform(0.1, 0.95), random.uniform(1.05, 1.95)]), 2)
    initial = [random.choice(["1", signed(random)]) for _ in range(math.ceil(float(q)))]
    return ["[unknown.v]", 'derivative = "riemann-liouville"', f"order = {q}", f'rhs = "{number(random)}*sin({frequency(random)}*t) - {number(random)}*v"', f"initial = [{', '.join(initial)}]"]


def with_singular(random: Random, lines: list[str]) -> list[str]:
    """The lines with an unknown that is infinite at 0, sometimes as the load of another one."""
    rows = [k + 1 for k, line in enumerate(lines) if line.startswith("order") and line != "order = 0" and lines[k + 2].startswith("initial")]
    row = random.choice(rows) if rows and random.random() < 0.5 else -1
    return [line[:-1] + f' + {number(random)}*v"' if k == row else line for k, line in enumerate(lines)] + singular(random)


def power_of_s(random: Random, q: float) -> str:
    return random.choice([f"s^{typed(q)}", f"({number(random)}*s)^{typed(q)}", f"{number(random)}*s^{typed(q)}"])


def plant(random: Random, name: str, names: list[str], parameters: list[str]) -> list[str]:
    """An unknown with a transfer function, most often with feedback."""
    top = order(random)
    below = [power_of_s(random, q) for q in (top, *sorted(random.uniform(0.02, 0.98) * top for _ in range(random.randint(0, 2))))]
    over = [power_of_s(random, random.uniform(0.02, 0.95) * top) for _ in range(random.randint(0, 1))]
    transfer = f"({' + '.join([number(random), *over])})/({' + '.join([*below, number(random)])})"
    if random.random() < 0.3:
        transfer = random.choice([f"s^-0.3*{transfer}*s^0.3", f"{transfer} + 1/(s^0.4 + {number(random)})", f"({transfer})^2", f"sqrt(s)*{transfer}"])
    source = random.choice(["1", "t", f"sin({frequency(random)}*t)", right_side(random, names[0], names, parameters)])
    feedback = random.choice(["", f" - {name}", f" - {number(random)}*{name}", f" - {name}(t - {number(random)})", f" - D({name}, 0.2)"])
    return [f"[unknown.{name}]", f'transfer = "{transfer}"', f'input = "{source}{feedback}"']


def made(random: Random) -> tuple[str, ...]:
    """A file with the manufactured solution c + b t^p, whose derivative of order q is known."""
    q, p = round(random.uniform(0.2, 0.98), 2), number(random)
    p = typed(float(p) + q, 3)
    b, c, rate = number(random), signed(random), number(random)
    exact = f"{c} + {b}*t^{p}"
    return (f"end = {typed(spread(random, 0.3, 3), 3)}", "[unknown.x]", f"order = {q}",
            f'rhs = "{b}*gamma(1 + {p})/gamma(1 + {p} - {q})*t^({p} - {q}) - {rate}*(x - ({exact}))"', f"initial = [{c}]",
            "[exact]", f'x = "{exact}"')


def example(random: Random, events: bool) -> tuple[str, ...]:
    """One of docs/examples that needs no other file, with random parameters and a random end, without comments; without events unless
    `events`."""
    texts = [path.read_text() for path in sorted(EXAMPLES.glob("*.toml"))]
    lines = random.choice([text for text in texts if "[table." not in text]).splitlines()
    if not events and (first := [k for k, line in enumerate(lines) if line.startswith("[event")]):
        lines = lines[: first[0]]
    lines = [line.split("   #")[0].rstrip() for line in lines if line and not line.startswith("#")]
    scaled = re.compile(r"(\w+) = (\d+\.?\d*)$")
    return tuple(f"{m[1]} = {typed(float(m[2]) * spread(random, 0.3, 6 if m[1] == 'end' else 2), 3)}"
                 if (m := scaled.match(line)) and random.random() < 0.6 and m[1] != "order" else line for line in lines)


def with_table(random: Random, lines: list[str], names: list[str]) -> list[str]:
    """The lines with a table u, of samples far beyond the end, and a term with it in a right-hand side."""
    times = [-4.0]
    for _ in range(random.choice([3, 5, 30])):
        times.append(times[-1] + spread(random, 0.05, 2))
    samples = ", ".join(f"[{typed(t, 5)}, {typed(random.uniform(-2, 2), 3)}]" for t in [*times, 1e4])
    argument = random.choice(["t", f"{number(random)}*t", f"t + {number(random)}", "3*sin(t)", f"3*tanh({random.choice(names)})"])
    value = random.choice([f"u({argument})", f"u({argument})", f"J(u({argument}), {typed(random.uniform(0.1, 1.5), 2)})"])
    row = random.choice([k for k, line in enumerate(lines) if line.startswith("rhs")])
    changed = [line[:-1] + f' + {typed(random.uniform(-1, 1), 2)}*{value}"' if k == row else line for k, line in enumerate(lines)]
    return [*changed, "[table.u]", f'between = "{random.choice(["constant", "linear", "cubic"])}"', f"samples = [{samples}]"]


def field(random: Random) -> tuple[str, ...]:
    """A vector of a few unknowns that are coupled to their neighbours, or to all; sometimes with a number beside it."""
    leading = order(random)
    rhs = random.choice(["u[i-1] - 2*u[i] + u[i+1]", "sum(j, 1, size, u[j])/size - u[i]", "u[size + 1 - i]/i - u[i]", "sin(u[i-1]) - i*u[i]",
                         "k*(u[max(i - 1, 1)] - u[i])"])
    rhs += random.choice(["", "", f" + {drive(random)}", " - u[i]^3", f" + 0.1*J(u[i], {typed(random.uniform(0.1, 1.5), 2)})",
                          f" - {switch(random, 'u[i]')}", f" + {typed(leading / 2, 2)}*D(u[i], {typed(leading / 2, 3)})"])
    initial = [f'"{random.choice(["i/size", "sin(pi*i/(size + 1))", signed(random)])}"' for _ in range(max(1, math.ceil(leading)))]
    lines = [f"end = {typed(spread(random, 0.3, 8), 3)}", "[parameters]", f"k = {number(random)}", "[unknown.u]", f"size = {random.randint(1, 4)}",
             f"order = {typed(leading)}", f'rhs = "{rhs}"', f"initial = [{', '.join(initial)}]", f'outside = "{random.choice(["0", "k", "sin(t)", "i"])}"']
    if random.random() < 0.2:
        lines += ["[unknown.x]", "order = 0.7", 'rhs = "u[1] - x"', "initial = [1]"]
    return tuple(lines)


def drawn_file(random: Random, rows: int = 0, events: bool = True, rare: float = 1.0) -> tuple[str, ...]:
    """Lines of a file: mechanics, or one to three unknowns and sometimes parameters, an algebraic row or a jump; sometimes an event. With
    `rare` above 1 mechanics are rarer, and what is rare among equations is more frequent, by this factor."""
    if random.random() < 0.35 / rare**2:
        lines = free() if random.random() < 0.03 else drawn_mechanics(random, rows)
        return (*lines, *event(random, "x")) if events and random.random() < 0.15 else lines
    if (chance := random.random()) < 0.2 and not rows:
        return made(random) if chance < 0.1 else example(random, events)
    if not rows and random.random() < 0.08 * rare:
        return field(random)
    names = ["x", "y", "z"][:rows or random.choice([1, 1, 1, 2, 2, 3])]
    parameters = ["a", "rate"][:random.choice([0, 0, 1, 2])]
    lines = [f"end = {typed(spread(random, 0.3, 12), 3)}"]
    if parameters:
        lines += ["[parameters]", *(f"{name} = {number(random)}" for name in parameters)]
    several, delays = random.random() < 0.25, random.random() < 0.2
    for name in names:
        if not delays and random.random() < 0.05 * rare:
            lines += of_distributed_order(random, name, names, parameters)
        else:
            lines += unknown(random, name, names, parameters, several, delays)
    if not rows and random.random() < 0.08 * rare:
        lines = with_singular(random, lines)
    if random.random() < 0.15:
        lines = with_table(random, lines, names)
    if len(names) > 1 and random.random() < 0.2:
        lines += ["[unknown.w]", "order = 0", f'rhs = "{typed(random.uniform(0.5, 2), 2)}*w - {random.choice(names)} - {random.choice(["0", "t", "sin(t)"])}"', "initial = [0]"]
    if not rows and random.random() < 0.12:
        lines += plant(random, "p", names, parameters)
    if random.random() < 0.15:
        lines += ["[[jump]]", f"at = {number(random)}"]
    if events and random.random() < 0.15:
        lines += event(random, names[0], resets=not rows and not delays)
    return tuple(lines)
