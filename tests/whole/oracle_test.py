#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The oracle on equations with closed solutions: its error is below what it says, and small."""

import sys
from math import erfc, exp, gamma, pi, sin, sqrt

from case import Case
from kinds import known


def erfcx(x: float) -> float:
    return exp(x * x) * erfc(x)


def file(order: str, right: str, initial: str, *more: str) -> tuple[str, ...]:
    return ("end = 2", *more, "[unknown.x]", f"order = {order}", f'rhs = "{right}"', f"initial = [{initial}]")


def pulses(t: float) -> float:
    """The response of order 1/2 to two boxes: the increments of 1 - E(-sqrt(t - a))."""
    return sum(sign * (1 - erfcx(sqrt(t - a))) for sign, a in ((1, 0.5), (-1, 0.6), (2, 1.1), (-2, 1.101)) if t > a)


def delayed(t: float) -> float:
    """D^0.6 x = -x(t - 0.7), x = 1 before: a power more after each delay."""
    return sum((-1) ** k * (t - (k - 1) * 0.7) ** (0.6 * k) / gamma(0.6 * k + 1) for k in range(5) if t > (k - 1) * 0.7)


CLOSED = {
    "delay": ((*file("0.6", "-x(t - 0.7)", "1"), 'before = "1"'), delayed),
    "relaxation": (file("0.5", "-x", "1"), lambda t: erfcx(sqrt(t))),
    "boxes": (file("0.5", "step(t - 0.5) - step(t - 0.6) + 2*(step(t - 1.1) - step(t - 1.101)) - x", "0"), pulses),
    "oscillator": (file("2", "-9*x", "0, 3"), lambda t: sin(3 * t)),
    "power": (file("0.3", f"{gamma(2.5)!r}/{gamma(2.2)!r}*t^1.2 + t^3 - x^2", "0"), lambda t: t ** 1.5),
    "decay": (file("1", "-40*x^2", "1"), lambda t: 1 / (1 + 40 * t)),
    "narrow": (file("1", "exp(-((t - place1)/width1)^2)/width1", "0", "[parameters]", "place1 = 0.7", "width1 = 1e-3"), lambda t: sqrt(pi) if t > 0.7 else 0.0),
    "Abel": (("end = 2", "[unknown.w]", "order = 0.5", 'rhs = "x"', "initial = [0]", "[unknown.x]", "order = 0", 'rhs = "w - t"', "initial = [0]"),
             lambda t: 2 * sqrt(t / pi)),
}


def main() -> int:
    wrong = 0
    for name, (lines, right) in CLOSED.items():
        times = [0.3, 0.95, 1.102, 2.0]
        for t, values in zip(times, known(Case("oracle", file=lines), times)):
            value, off = values["x"]
            if not abs(value - right(t)) <= 3 * off + 1e-13 or off > 1e-6:
                wrong += 1
                print(f"{name}: {value!r} to {off:.1g} at t = {t}, right is {right(t)!r}")
    print(f"{len(CLOSED)} closed solutions, {wrong} values wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
