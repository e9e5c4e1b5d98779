# SPDX-License-Identifier: MIT
"""The panels of the oracle and the rules on them."""

import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from math import exp, log

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np
from numpy.polynomial.legendre import leggauss, legroots, legvander

Array = np.ndarray
GAUSS = 12  # points of a rule on a piece


class Uncertain(Exception):
    """There is no value that could be relied on."""


legendre = lru_cache(None)(leggauss)


@lru_cache(None)
def radau(count: int) -> tuple[Array, Array, Array]:
    """The Radau points in (-1, 1] with 1 among them, the weights of the rule, and the coefficients of Legendre polynomials that follow
    from values at the points."""
    coefficients = np.zeros(count + 1)
    coefficients[count - 1], coefficients[count] = -1.0, 1.0  # P_n - P_(n-1)
    points = np.sort(legroots(coefficients).real)
    points[-1] = 1.0
    inverse = np.linalg.inv(legvander(points, count - 1))
    return points, 2 * inverse[0], inverse


@lru_cache(None)
def gauss(power: float) -> tuple[Array, Array]:
    """Points v and weights of the Gauss rule for the integral of v^(power - 1) f(v) over [0, 1]."""
    b, n = power - 1, np.arange(GAUSS)
    diagonal = np.where(n == 0, b / (b + 2), b * b / np.maximum((2 * n + b) * (2 * n + b + 2), 1e-300))
    k = np.arange(1, GAUSS)
    beside = 4 * k * k * (k + b) ** 2 / ((2 * k + b) ** 2 * (2 * k + b + 1) * (2 * k + b - 1))
    beside[0] = 4 * (1 + b) / ((2 + b) ** 2 * (3 + b))
    x, vectors = np.linalg.eigh(np.diag(diagonal) + np.diag(np.sqrt(beside), 1) + np.diag(np.sqrt(beside), -1))
    return (1 + x) / 2, vectors[0] ** 2 / power


def lagrange(count: int, x: Array) -> Array:
    """The values at each x (rows) of the polynomials that are 1 at one Radau point and 0 at the others (columns)."""
    return legvander(x, count - 1) @ radau(count)[2]


@dataclass
class Panel:
    """Times a + z (`linear`), a + e^z, or the first one beside a: from a to a + e^high with u constant (`point`)."""

    kind: str
    anchor: float
    low: float
    high: float
    z: Array = field(default_factory=lambda: np.zeros(0))

    @property
    def offsets(self) -> Array:
        return self.z if self.kind == "linear" else np.exp(self.z)

    @property
    def logs(self) -> Array:
        return np.log(self.z) if self.kind == "linear" else self.z


@dataclass(frozen=True)
class Shape:
    """What is known about a problem where its panels have to be short."""

    end: float
    jumps: Sequence[float] = ()  # times at which a load or one of its derivatives jumps
    pulses: Sequence[tuple[float, float, float]] = ()  # (time, distance up to which panels are short, their length)
    longest: float = 1.0  # of a panel
    order: float = 1.0  # the smallest of an integral
    rate: float = 1.0  # the size of the derivatives of g


def panels(shape: Shape, outputs: Sequence[float], scale: float) -> list[Panel]:
    """The panels up to the end; outputs are ends of panels."""
    least = 1e-6 * scale ** 20  # what is neglected beside a jump: not the same at two resolutions
    start = log(least / max(shape.rate, 1)) / shape.order
    anchors = sorted({0.0, *(a for a in shape.jumps if 0 < a < shape.end)})
    found = []
    for a, b in zip(anchors, [*anchors[1:], shape.end]):
        stops = [t - a for t in sorted({*outputs, b}) if a < t <= b]
        x = min(start, log(10 * least * min([1.0, stops[0], shape.longest, *(short for _, _, short in shape.pulses)])))
        found.append(Panel("point", a, -np.inf, x))
        position = exp(x)
        for stop in stops:
            while position < stop:
                size = scale * min([shape.longest, *(max(short, 0.4 * (abs(a + position - c) - reach)) for c, reach, short in shape.pulses)])
                size = min(size, scale * max(shape.longest * 0.05, 0.7 * (position)))
                length = scale * min(1.5 / shape.order, 1 + 0.5 * max(0.0, log(size) - x))
                if (grown := exp(x) * np.expm1(length)) < size and exp(x) + grown < 0.9 * stop:
                    found.append(Panel("log", a, x, x + length))
                    x += length
                    position = exp(x)
                else:
                    left = stop - position
                    upper = stop if left < 1.3 * size else position + size
                    if x < -500:
                        raise Uncertain("the first output is too early")
                    found.append(Panel("linear", a, position, upper))
                    position = upper
                    x = log(upper)
    return found
