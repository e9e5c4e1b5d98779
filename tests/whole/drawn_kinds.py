# SPDX-License-Identifier: MIT
"""Random problems of five kinds on which every method that samples can be wrong: narrow loads, small orders with several equilibria,
algebraic unknowns, delays, constraints with memory. Parameters place1, width1, omega1 say where a load is steep (oracle_problems.py)."""

from dataclasses import replace
from math import gamma, pi
from random import Random

from case import Case
from drawn_numbers import spread, typed
from drawn_scenes import Lists

ADAPTIVE = ("adaptive_pc", "adaptive_trapezoidal", "radau_exponentials", "spectral_collocation")  # the last two take algebraic rows
Load = tuple[str, dict[str, float], list[float]]  # formula, parameters, times of interest


def sampled(random: Random, end: float) -> Load:
    """Boxes side by side, as of measured data."""
    count, width = random.randint(3, 15), end * spread(random, 1e-3, 0.05)
    first = random.uniform(0, 0.9) * (end - count * width)
    edges = [float(typed(first + k * width, 6)) for k in range(count + 1)]
    boxes = [f"({typed(random.uniform(-2, 2), 3)})*(step(t - {typed(a, 6)}) - step(t - {typed(b, 6)}))" for a, b in zip(edges, edges[1:])]
    return " + ".join(boxes), {}, [(edges[1] + edges[2]) / 2, edges[-1] + width]


def drawn_load(random: Random, end: float, order: float, k: str = "1") -> Load:
    """A formula that is small outside of a short time, or begins there; its height makes up for its width, at least in part."""
    if random.random() < 0.1:
        return sampled(random, end)
    width = float(typed(end * spread(random, 1e-4, 1), 3))
    place = float(typed(random.uniform(0.03, 0.95) * end, 4))
    height = typed(spread(random, 0.5, 4) * min(width, 1) ** -(order * random.uniform(0.3, 1)), 3)
    s, p, w, o = f"(t - place{k})", f"place{k}", f"width{k}", f"omega{k}"
    inside = f"step(t - {p})*step({p} + {w} - t)"
    cycles = random.choice([1, 2, 3, 0.5, 5.5])
    kind = random.choice(["gaussian", "gaussian", "half sine", "half sine", "triangle", "ramp", "limited ramp", "burst", "packet", "switched", "parabola"])
    given = {p: place, w: width}
    if kind in ("burst", "packet"):
        given[o] = float(typed(2 * pi * cycles / width, 4))
    if kind == "switched":
        given = {p: place, o: float(typed(spread(random, 0.3, 10), 3))}
    formula = {"gaussian": f"{height}*exp(-({s}/{w})^2)", "half sine": f"{height}*sin(pi*{s}/{w})*{inside}", "triangle": f"{height}*max(0, 1 - abs(t - {p})/{w})",
               "ramp": f"{typed(spread(random, 0.5, 4), 2)}*{s}*step(t - {p})", "limited ramp": f"{typed(spread(random, 0.5, 4), 2)}*min(1, max(0, (t - {p})/{w}))",
               "burst": f"{height}*sin({o}*{s})*{inside}", "packet": f"{height}*cos({o}*{s})*exp(-({s}/{w})^2)",
               "switched": f"{typed(spread(random, 0.5, 4), 2)}*cos({o}*t)*step(t - {p})", "parabola": f"{height}*4*{s}*({w} - {s})/{w}^2*{inside}"}[kind]
    return formula, given, [place + width * random.choice([0.3, 0.7, 1.3, 2.5]), place + width + (end - place) * random.uniform(0.05, 0.5)]


def parameter_lines(given: dict[str, float]) -> list[str]:
    return ["[parameters]", *(f"{name} = {value!r}" for name, value in given.items())] if given else []


def row(name: str, order: str, right: str, initial: list[str]) -> list[str]:
    return [f"[unknown.{name}]", order if "=" in order else f"order = {order}", f'rhs = "{right}"', f"initial = [{', '.join(initial)}]"]


def commands(random: Random, schemes: tuple[str, ...]) -> tuple[str, ...]:
    """Two schemes with an accuracy each; `exact` is always checked."""
    return tuple(f"{one}:{typed(spread(random, 1e-8, 1e-4), 2)}" for one in random.sample(schemes, 2))


def made(random: Random, name: str, lines: list[str], end: float, times: list[float], schemes: tuple[str, ...] = ADAPTIVE) -> Case:
    at = sorted({typed(t, 7) for t in times if end * 1e-3 < t < 0.999 * end} | {typed(end, 7)}, key=float)
    return Case(name, file=(f"end = {typed(end, 7)}", *lines), options={"--at": ",".join(at)}, words=commands(random, schemes))


def start(random: Random, order: float, rest: bool) -> list[str]:
    return [random.choice(["0.0"] if rest else ["1.0", "-0.5", typed(random.uniform(-1, 1), 2)]), *([] if order <= 1 else ["0.0" if rest else typed(random.uniform(-1, 1), 2)])]


def drawn_load_case(random: Random, lists: Lists) -> Case:
    end, rest = float(typed(spread(random, 1, 20), 2)), random.random() < 0.6
    order = random.choice([0.5, 0.9, 1, 1.5, 2, *[round(random.uniform(0.15, 2), 2)] * 5])
    load, given, times = drawn_load(random, end, order)
    if random.random() < 0.15:
        second = drawn_load(random, end, order, "2")
        load, given, times = f"{load} + {second[0]}", {**given, **second[1]}, times + second[2]
    stiffness = typed(spread(random, 0.3, 6), 2)
    damped = random.choice([f"-{stiffness}*x"] * 3 + [f"-{stiffness}*x - 0.1*x^3", f"-{stiffness}*sin(x)", f"-{stiffness}*tanh(x)", "-x/(1 + x^2)", "-x - x^3"])
    leading = typed(order)
    if order > 1 and random.random() < 0.6:
        leading = f"terms = [[1, {typed(order)}], [{typed(random.uniform(0.1, 1), 2)}, {typed(random.uniform(0.1, min(1.0, order - 0.05)), 2)}]]"
    coupled = random.random() < 0.25
    lines = parameter_lines(given) + row("x", leading, f"{load} {damped.replace('-', '- ', 1)}" + (" + 0.3*y" if coupled else ""), start(random, order, rest))
    if coupled:
        other = round(random.uniform(0.2, 1.8), 2)
        lines += row("y", typed(other), "x - 2*y" + random.choice(["", " - y^3"]), start(random, other, rest))
    return made(random, "narrow_loads_are_seen", lines, end, times)


def drawn_equilibria(random: Random, lists: Lists) -> Case:
    order, k = typed(spread(random, 0.01, 0.3), 2), typed(spread(random, 1, 1e4), 2)
    end, a = float(typed(spread(random, 0.1, 20), 2)), typed(random.uniform(0.1, 0.8), 2)
    first = lambda low, high: [typed(random.uniform(low, high), 3)]  # noqa: E731
    right, initial = random.choice([
        (f"-{k}*x^2", first(0.1, 3)), (f"-{k}*x^2 + {a}", first(0.1, 3)), (f"{k}*(x - x^3)", random.choice([first(0.3, 2), first(-2, -0.3)])),
        (f"{k}*(1 - x)*(x - {a})", first(float(a) + 0.05, 2)), (f"-{k}*x*(x - {a})", first(float(a), 2)), (f"{k}*(1 - x^2)", first(-0.8, 2)),
        (f"-{k}*sinh(x)*(1 + x)", first(0.2, 2)), (f"-{k}*x^3 + x", first(-2, 2)), (f"{k}*(exp(-x) - x^2)", first(0.1, 2)), (f"-{k}*x^2 + sin(t)^2", first(0.1, 2)),
        (f"{k}*sin(x)", first(0.3, 2.8)), (f"-{k}*(x^2 - {a})*x", first(float(a), 2))])
    lines = row("x", order, right, initial)
    if random.random() < 0.25:
        lines = row("x", order, right + " + 0.2*y", initial) + row("y", typed(spread(random, 0.01, 0.9), 2), random.choice(["x - y", "-y^2 + x", f"-{k}*(y - x)"]), first(0.1, 1))
    return made(random, "equilibria_are_those_of_the_start", lines, end, [end * spread(random, 0.01, 0.9)], random.choice([ADAPTIVE, *[ADAPTIVE[1:]] * 4]))  # explicit steps take long


def drawn_algebraic(random: Random, lists: Lists) -> Case:
    end, order = float(typed(spread(random, 0.5, 10), 2)), round(random.uniform(0.15, 0.95), 2)
    kind = random.choice(["abel", "abel", "abel with load", "root", "linear", "exponential", "sum", "load"])
    c = typed(spread(random, 0.3, 3), 2)
    given: dict[str, float] = {}
    if kind in ("abel", "abel with load"):
        omega = typed(spread(random, 0.3, 4), 2)
        path = random.choice(["t", f"{c}*t^2", f"sin({omega}*t)", f"1 - exp(-{c}*t)", f"t + {c}*t^3", f"t*cos({omega}*t)"])
        lines = row("w", typed(order), "u" + (f" - {c}*w" if kind == "abel with load" else ""), ["0.0"]) + row("u", "0", f"w - ({path})", ["0.0"])
        # u starts at D^order of the path at 0, which is 0 for these paths and orders below 1.
    else:
        u0 = round(random.uniform(-1, 1.5), 2)
        relation, x0 = {"root": ("u + u^3 - x", u0 + u0 ** 3), "linear": (f"2*u - x + {c}*sin(t)", 2 * u0), "exponential": ("exp(u) - 1 - x", None),
                        "sum": (f"x + {c}*y + u", None), "load": ("u - x - LOAD", None)}[kind]
        if kind == "exponential":
            from math import exp
            x0 = exp(u0) - 1
        if kind == "load":
            load, given, _ = drawn_load(random, end, order)
            relation, x0 = f"u - x - {load}", 0.0
            u0 = 0.0
        right = random.choice([f"-{c}*u", f"-{c}*u + cos(t)", f"-x - {c}*u"])
        lines = parameter_lines(given) + row("x", typed(order), right, [repr(x0 if x0 is not None else 0.5)])
        if kind == "sum":
            lines += row("y", typed(round(random.uniform(0.2, 1), 2)), "x - y", ["0.25"])
            u0 = -(0.5 + float(c) * 0.25)
        lines += row("u", "0", relation, [repr(u0)])
    return made(random, "algebraic_unknowns_are_controlled", lines, end, [end * spread(random, 0.02, 0.9) for _ in range(2)], ADAPTIVE[2:])


def drawn_delays(random: Random, lists: Lists) -> Case:
    """One or two unknowns that look back, with values before that may end elsewhere than at the start."""
    end, order = float(typed(spread(random, 1, 10), 2)), random.choice([1.0, *[round(random.uniform(0.3, 1.95), 2)] * 3])
    tau, k = typed(end * random.uniform(0.2, 0.9), 3), typed(spread(random, 0.3, 2), 2)
    other = random.random() < 0.3
    past = "y(t - tau)" if other else "x(t - tau)"
    right = random.choice([f"-{k}*{past}", f"{k}*x*(1 - {past})", f"-x + {k}*tanh({past})", f"-x + 2*{past}/(1 + {past}^4)", f"-{k}*x + sin({past})",
                           f"-{k}*{past} + 0.3*x(t - {typed(float(tau) * random.uniform(0.6, 1.4), 3)})"])
    if random.random() < 0.3:
        right += f" + {typed(spread(random, 0.3, 2), 2)}*sin({typed(spread(random, 0.5, 4), 2)}*t)"

    def looking_back(name: str, order: float, right: str) -> list[str]:
        initial = start(random, order, False)
        before = random.choice([initial[0], initial[0], f"{initial[0]}*cos(t)", f"{initial[0]} + 0.5*t", "0"])
        return [*row(name, typed(order), right, initial), f'before = "{before}"']

    lines = ["[parameters]", f"tau = {tau}", *looking_back("x", order, right)]
    if other:
        lines += looking_back("y", round(random.uniform(0.3, 1.5), 2), "x - y")
    return made(random, "delays_are_looked_up", lines, end, [end * random.uniform(0.05, 0.95) for _ in range(2)])


def drawn_constrained(random: Random, lists: Lists) -> Case:
    """Coefficients that may be 0; where the free motion of the constraint itself grows, slowly enough."""
    def coefficient() -> float:
        return random.choice([0.0, 1.0, *[float(typed(random.uniform(-2, 2), 3))] * 4])

    above = random.random() < 0.5
    while True:
        alpha = round(random.uniform(1.05, 1.95) if above else random.uniform(0.05, 0.95), 3)
        a, b = [coefficient(), coefficient()], [coefficient(), coefficient()]
        if random.random() < 0.3:
            # Reactions along a hardly act through w: v follows from w with a large factor.
            turned, small = round(random.uniform(-2, 2), 3), round(random.uniform(0, 0.1), 3)
            b = [float(typed(small * a[0] - turned * a[1], 3)), float(typed(small * a[1] + turned * a[0], 3))]
        along, size = a[0] * b[0] + a[1] * b[1], a[0] ** 2 + a[1] ** 2
        end = float(typed(spread(random, 1, 12), 2))
        if size == 0 or (above and along == 0 and random.random() < 0.8):
            continue
        if not above or along >= 0 or (size / -along) ** (1 / (alpha - 1)) * end < 8:
            break
    given = {"alpha": alpha, **dict(zip(("a1", "a2", "b1", "b2"), [*a, *b])), "k1": round(spread(random, 0.2, 15), 3), "k2": round(spread(random, 0.2, 15), 3),
             "g": random.choice([0.0, round(random.uniform(-2, 2), 3)]), **{name: round(random.uniform(-2, 2), 3) for name in ("q1", "q2", "v1", "v2")}}
    if above and along and random.random() < 0.4:
        given["C0"] = round(a[0] * given["v1"] + a[1] * given["v2"] + random.uniform(-1, 1), 3)
    times = [end * spread(random, 0.02, 0.9) for _ in range(2)]
    name = "constraints_with_memory_hold"
    if random.random() < 0.5:
        chosen = {key: repr(value) for key, value in given.items()} | {"until": typed(end, 7)}
        one = replace(made(random, name, [], end, times), scene="fractional_constraint_2d", file=(), chosen=chosen)
        form = random.choice(["", "integrated", "multiplier", *(["acceleration", "stabilised"] if alpha < 0.5 else [])])
        return replace(one, chosen={**chosen, **({"formulation": form} if form else {})}, words=commands(random, ADAPTIVE[2:] if form == "multiplier" else ADAPTIVE))
    given |= {"q": round(random.uniform(0.05, 0.95), 2), "c1": random.choice([0.0, round(random.uniform(0.1, 1), 2)]), "k3": random.choice([0.0, round(random.uniform(0.1, 1), 2)])}
    given.setdefault("C0", a[0] * given["v1"] + a[1] * given["v2"])
    lines = parameter_lines(given) + ["[coordinate.x]", 'initial = ["q1", "v1"]', "[coordinate.y]", 'initial = ["q2", "v2"]', "[mechanics]",
                                      'lagrangian = "(D(x,1)^2 + D(y,1)^2)/2 - (k1*x^2 + k2*y^2 + k3*x^2*y^2)/2 - g*y"',
                                      'forces = { x = "-c1*D(x,q)" }', 'constraints = ["a1*D(x,1) + a2*D(y,1) + b1*D(x,alpha) + b2*D(y,alpha) - C0"]',
                                      "[columns]", 'w1 = "D(x,alpha)"', 'w2 = "D(y,alpha)"']
    return made(random, name, lines, end, times)
