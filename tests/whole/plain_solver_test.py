#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The plain solver on equations with closed solutions: its error is below what it says, and small."""

import sys
from math import erfc, exp, gamma, pi, sqrt

from plain_solver import solution


def file(right: str, initial: str, *more: str) -> str:
    return "\n".join(("end = 3", "[unknown.x]", f'rhs = "{right}"', f"initial = [{initial}]", *more))


def event(zero: str, name: str, value: str) -> tuple[str, str, str]:
    return "[event.a]", f'zero = "{zero}"', f"set = {{ {name} = \"{value}\" }}"


def relaxation(t: float) -> float:
    return exp(t) * erfc(sqrt(t))


def delayed(t: float) -> float:
    """A power more after each delay."""
    return sum((-1) ** k * (t - (k - 1) * 0.7) ** (0.6 * k) / gamma(0.6 * k + 1) for k in range(7) if t > (k - 1) * 0.7)


def bounced(t: float) -> float:
    """Thrown up with 0.5 sqrt(2) where it falls from 1 to the ground, at sqrt(2)."""
    s = t - sqrt(2)
    return 1 - t * t / 2 if s < 0 else sqrt(2) / 2 * s - s * s / 2


CLOSED = {
    "relaxation": (file("-x", "1", "order = 0.5"), relaxation),
    "Riemann-Liouville": (file("-x", "1", "order = 0.5", 'derivative = "riemann-liouville"'), lambda t: 1 / sqrt(pi * t) - relaxation(t)),
    "integral": (file("1 - J(x, 0.5) - x", "1", "order = 0"), relaxation),
    "several terms": (file("2 + 6*t^0.7/gamma(1.7)", "0, 0", "terms = [[1, 2], [3, 1.3]]"), lambda t: t * t),
    "delay": (file("-x(t - 0.7)", "1", "order = 0.6", 'before = "1"'), delayed),
    "distributed": (file("(t - 1)/log(t)", "0", 'terms = [{ weight = "gamma(2 - q)", from = 0, to = 1 }]'), lambda t: t),
    "dose": (file("-x", "1", "order = 1", *event("t - 1", "x", "x + 1")), lambda t: exp(-t) + (exp(1 - t) if t > 1 else 0)),
    "level": (file("1", "0", "order = 0.5", *event("x - 1", "x", "0")), lambda t: 2 * sqrt(t / pi) - (t > pi / 4)),
    "bounce": (file("-1", "1, 0", "order = 2", *event("x", '"D(x,1)"', "-0.5*D(x,1)")), bounced),
    "start": (file("-x", "1", "order = 0.5").replace("end = 3", "start = 1\nend = 4"), lambda t: relaxation(t - 1)),
}


def main() -> int:
    wrong = 0
    for name, (text, right) in CLOSED.items():
        times = [1.3, 2.05, 2.6]
        for t, values in zip(times, solution(text, times)):
            value, off = values["x"]
            if not abs(value - right(t)) <= off or off > 0.05 * (1 + abs(right(t))):
                wrong += 1
                print(f"{name}: {value!r} to {off:.1g} at t = {t}, right is {right(t)!r}")
    print(f"{len(CLOSED)} closed solutions, {wrong} values wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
