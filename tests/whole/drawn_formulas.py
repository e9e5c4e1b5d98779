# SPDX-License-Identifier: MIT
"""Random formulas of equation files: loads, couplings, switches."""

from random import Random

from drawn_numbers import spread, typed


def number(random: Random) -> str:
    return typed(random.choice([spread(random, 0.1, 4), random.choice([1, 2, 0.5, 3])]), 3)


def signed(random: Random) -> str:
    return random.choice(["", "-"]) + number(random)


def frequency(random: Random) -> str:
    return typed(spread(random, 0.5, 60), 3)


def drive(random: Random) -> str:
    """A load: a function of time."""
    a, w = number(random), frequency(random)
    return random.choice([
        a, f"{a}*t", f"{a}*t^{number(random)}", f"sqrt(t)", f"sin({w}*t)", f"{a}*cos({w}*t)", f"exp(-{a}*t)", f"sinh(t)/(1 + cosh(t))",
        f"step(t - {a})", f"{a}*step({number(random)} - t)", f"sign(sin({w}*t))", f"sign(t - {a})", f"abs(sin({w}*t))",
        f"min(t,{a})", f"max(t - {a},0)", f"step(sin({w}*t))", f"mittag_leffler({typed(random.uniform(0.3, 1.9), 2)},1,-t)", f"log(1 + {a}*t)",
        f"gamma({number(random)})", f"mod(t,{a})", f"{a}*floor({number(random)}*t)", f"ceil(t - {a})", f"erf({a}*t)", f"erfc(t - {a})", f"{a}*pi", f"atan2(t,{a})"])


def switch(random: Random, x: str) -> str:
    """A function of an unknown with a jump or a kink."""
    a, level = number(random), signed(random)
    return random.choice([
        f"{a}*step({x} - {level})", f"-{a}*step({x} - {level})", f"{a}*sign({x} - {level})", f"-{a}*sign({x})", f"{a}*abs({x} - {level})",
        f"-{a}*abs({x})", f"{a}*min({x},{level})", f"-{a}*max({x},{level})", f"{a}*max({x} - {level},0)", f"step({x})*step(t - {a})",
        f"floor({a}*{x})", f"-{a}*mod({x},{a})", f"ceil({x} - {level})"])


def smooth(random: Random, x: str) -> str:
    """A smooth nonlinearity, bounded or damping."""
    a = signed(random)
    return random.choice([f"{a}*sin({x})", f"{a}*cos({x})", f"{a}*tanh({x})", f"{a}*atan({x})", f"-{x}^3", f"{a}/(1 + {x}^2)",
                          f"{a}*exp(-{x}^2)", f"{a}*sqrt(1 + {x}^2)", f"{a}*asin(tanh({x}))", f"{a}*log(1 + {x}^2)", f"{a}*tan(tanh({x})/2)",
                          f"{a}*acos(tanh({x}))", f"{a}*erf({x})", f"{a}*erfc(abs(2 + {x}^2))"])


def integral(random: Random, x: str) -> str:
    """A fractional integral of an unknown, of a load or of both, or the derivative of a smooth load, of any order."""
    a, q, w = typed(random.uniform(-0.6, 0.6), 2), typed(random.choice([0.5, random.uniform(0.05, 2.5)]), 2), number(random)
    inner = random.choice([x, x, f"t*{x}", f"sin({x})", drive(random), f"J({x},{q})"])
    load = random.choice([f"sin({w}*t)", "t^2", "t^3", f"exp(-{w}*t)", "1", f"t + cos({w}*t)"])
    return random.choice([f"{a}*J({inner}, {q})", f"{a}*J({inner}, {q})", f"{a}*exp(-{w}*t)*J(exp({w}*t)*{x}, {q})", f"{a}*D({load}, {q})"])


def right_side(random: Random, own: str, names: list[str], parameters: list[str]) -> str:
    """A sum of terms; most have damping in their own unknown, so that the problem is well conditioned."""
    parts = []
    if random.random() < 0.75:
        parts.append(random.choice([f"-{own}", f"-{number(random)}*{own}", *(f"-{p}*{own}" for p in parameters)]))
    kinds = random.choice(["d", "ds", "s", "dn", "n", "dsn", "d", "dds", "dk", "k"])
    for kind in kinds:
        x = random.choice(names)
        parts.append({"d": drive, "s": lambda r: switch(r, x), "n": lambda r: smooth(r, x),
                      "k": lambda r: f"{typed(r.uniform(-0.6, 0.6), 2)}*{x}"}[kind](random))
    if random.random() < 0.15:
        parts.append(integral(random, random.choice(names)))
    random.shuffle(parts)
    return " + ".join(parts)
