# SPDX-License-Identifier: MIT
"""Two mechanical systems with values at both ends, whose motions minimise an action."""

import mpmath as mp
from mpmath import mpf

from power_series import numbers
from ritz import Ritz, exponents, right_derivative

LAGRANGIAN = dict(c="0.8", k="1.5", p="0.6", alpha="0.55")


def fractional_lagrangian(size, singular=True):
    """Near 0, x'' contains the powers that D^alpha from the right makes of D^alpha t^i: exponents i + (2 - 2 alpha) j, i > 0.
    Near T the right derivative of a value that is not 0 is (T-t)^(-alpha): exponents 2 - alpha + i + (2 - 2 alpha) j.
    The functional is strictly convex, so that its stationary point is the solution.
    """
    P = numbers(LAGRANGIAN)
    step = 2 - 2 * P["alpha"]
    left = exponents(1, [1, step] if singular else [1], size + (0 if singular else 12))
    right = [e for e in exponents(2 - P["alpha"], [1, step], size)] if singular else []
    ritz = Ritz(P["alpha"], left, right)
    T = mpf("1.2")
    ritz.solve(T, mpf(0), mpf(1), [[-P["k"], 0, 0], [0, mpf(1), 0], [0, 0, P["c"]]], [P["p"], mpf(0), mpf(0)])

    def columns(t):
        x, v, _, w = ritz.evaluate(t)
        return {"x": x, "D(x,1)": v, "D(x,0.55)": w}

    def check(t):
        x, _, acceleration, _ = ritz.evaluate(t)
        g = lambda s: ritz.evaluate(s)[3]
        return abs(-acceleration + P["c"] * right_derivative(ritz, g, ritz.fractional_rate, t) - P["k"] * x + P["p"])

    return columns, check


VAKONOMIC = dict(b="0.7", c="0.5", k="1.1", p="0.4", alpha="0.65")


def fractional_vakonomic_pair(size, singular=True):
    """The constraint gives y' = b D^alpha x + c x, so that the action is one of x alone,
    L = x'^2/2 + (b D^alpha x + c x)^2/2 - k x^2/2 + p x, under the condition that the integral of b D^alpha x + c x is
    y(T) - y(0). Exponents as above, with the step 2 - alpha of the mixed term as well.
    """
    P = numbers(VAKONOMIC)
    a, b, c = P["alpha"], P["b"], P["c"]
    steps = [1, 2 - 2 * a, 2 - a]
    left = exponents(1, steps if singular else [1], size + (0 if singular else 12))
    right = exponents(2 - a, steps, size) if singular else []
    ritz = Ritz(a, left, right)
    T = mpf("1.3")
    ritz.solve(T, mpf("0.2"), mpf("0.9"), [[c**2 - P["k"], 0, b * c], [0, mpf(1), 0], [b * c, 0, b**2]],
               [P["p"], mpf(0), mpf(0)], ([c, mpf(0), b], mpf("1.1") - mpf("0.1")))

    def rate(t):
        x, _, _, w = ritz.evaluate(t)
        return b * w + c * x

    def columns(t):
        x, v, _, w = ritz.evaluate(t)
        return {"x": x, "y": mpf("0.1") + mp.quad(rate, [0, t / 2, t]), "D(x,1)": v, "D(y,1)": b * w + c * x, "D(x,0.65)": w}

    def check(t):
        x, _, acceleration, _ = ritz.evaluate(t)
        g = lambda s: rate(s) + ritz.multiplier
        slope = lambda s: b * ritz.fractional_rate(s) + c * ritz.evaluate(s)[1]
        return abs(-acceleration + b * right_derivative(ritz, g, slope, t) + c * g(t) - P["k"] * x + P["p"])

    return columns, check
