#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Independent values of seven mechanical systems, from their equations of motion as derived by hand below.

Initial value problems are solved by a convergent power series in s = t^(1/m), m such that all orders are multiples of 1/m.
Coefficients are computed one after another in many digits: there is no step in time and no quadrature. The linear
system is solved a second time by inversion of its Laplace transform. Problems with values at both ends minimise the action
over powers of t and of T - t, with the exact fractional derivatives of both.

The digits of a file are those in which all of these agree: two lengths of the series in two precisions, the substitution
of the series of the coordinates alone in Lagrange's equations with multiplier and in the constraint, and, where there
is one, the second method.

usage: independent.py [--out FILE] [NAME...]     all seven take three to four minutes
"""
import json
import os
import sys
import tomllib

import mpmath as mp
from mpmath import mpf

HERE = os.path.dirname(os.path.abspath(__file__))


class Series:
    """A power series in s = t^(1/m), whose coefficients are computed when asked for, in increasing order."""

    def __init__(self, coefficient):
        self.c = []
        self.coefficient = coefficient

    def upto(self, n):
        while len(self.c) <= n:
            self.c.append(self.coefficient(len(self.c)))
        return self.c

    def __getitem__(self, n):
        return self.upto(n)[n]

    def __add__(self, other):
        if not isinstance(other, Series):
            other = constant(other)
        return Series(lambda n: self[n] + other[n])

    __radd__ = __add__

    def __neg__(self):
        return Series(lambda n: -self[n])

    def __sub__(self, other):
        return self + (-other)

    def __rsub__(self, other):
        return (-self) + other

    def __mul__(self, other):
        if not isinstance(other, Series):
            factor = mpf(other)
            return Series(lambda n: factor * self[n])
        return Series(lambda n: mp.fdot(self.upto(n)[: n + 1], other.upto(n)[n::-1]))

    __rmul__ = __mul__

    def __truediv__(self, other):
        if not isinstance(other, Series):
            return self * (1 / mpf(other))
        quotient = Series(None)

        def coefficient(n):
            value = self[n]
            if n:
                value -= mp.fdot(quotient.c[:n], other.upto(n)[n:0:-1])
            return value / other[0]

        quotient.coefficient = coefficient
        return quotient


def constant(value):
    return Series(lambda n: mpf(value) if n == 0 else mpf(0))


def sine_and_cosine(u):
    """From (sin u)' = u' cos u and (cos u)' = -u' sin u; the power of s is counted in place of the time."""
    sine, cosine = Series(None), Series(None)

    def product(n, of):
        return mp.fdot([k * u[k] for k in range(1, n + 1)], of.upto(n - 1)[n - 1 :: -1] if n > 0 else []) / n

    sine.coefficient = lambda n: mp.sin(u[0]) if n == 0 else product(n, cosine)
    cosine.coefficient = lambda n: mp.cos(u[0]) if n == 0 else -product(n, sine)
    return sine, cosine


def sine_of_time(m):
    """sin t as a series in s."""

    def coefficient(n):
        if n % m:
            return mpf(0)
        k = n // m
        return mpf(0) if k % 2 == 0 else (-1) ** (k // 2) / mp.factorial(k)

    return Series(coefficient)


class Motion:
    """States that are integrals of functions of the states; solve() computes n coefficients of all of them."""

    def __init__(self, m):
        self.m = m
        self.states = []

    def state(self, start, order_times_m=None):
        """A state whose derivative of the given order, 1 where none is given, is set later by rate()."""
        k = self.m if order_times_m is None else order_times_m
        series = Series(None)
        series.k, series.start, series.rate = k, mpf(start), None

        def coefficient(n):
            if n == 0:
                return series.start
            if n < k:
                return mpf(0)
            return self.gamma_quotient(n - k, n) * series.rate[n - k]

        series.coefficient = coefficient
        self.states.append(series)
        return series

    def gamma_quotient(self, i, n):
        return mp.gamma(mpf(i) / self.m + 1) / mp.gamma(mpf(n) / self.m + 1)

    def solve(self, n):
        for i in range(n + 1):
            for state in self.states:
                state[i]

    def value(self, series, t, n):
        s = mp.root(mpf(t), self.m)
        return mp.polyval(series.upto(n)[n::-1], s)

    def derivative(self, series, order, t, n):
        """The Caputo derivative of a multiple of 1/m, term by term, at one time above 0."""
        t, order = mpf(t), mpf(order)
        whole = int(mp.ceil(order))
        total = mpf(0)
        for i, c in enumerate(series.upto(n)[: n + 1]):
            if c == 0 or (i % self.m == 0 and i // self.m < whole):
                continue
            e = mpf(i) / self.m
            total += c * mp.gamma(e + 1) * mp.rgamma(e + 1 - order) * t ** (e - order)
        return total


def numbers(parameters):
    """Decimals as decimals."""
    return {name: mpf(value) for name, value in parameters.items()}


def substituted(reaction_and_rest):
    """Equations rest_i = sum_j reaction_ij lambda_j: the multipliers by least squares, and what is left of the equations."""
    matrix = mp.matrix([row for row, _ in reaction_and_rest])
    rest = mp.matrix([value for _, value in reaction_and_rest])
    multipliers = mp.lu_solve(matrix, rest)
    left = rest - matrix * multipliers
    return list(multipliers), max(abs(x) for x in left)


SLEIGH = dict(m="1.3", J="0.45", a="0.35", b="0.4", g="0.7", c="0.25", alpha="0.5", phi0="0.3", u0="0.9")


def chaplygin_sleigh(n):
    """u, v are the velocities along and across the blade, e1 = (cos phi, sin phi), e2 = (-sin phi, cos phi), w = phi'.

    The momentum is m u e1 + m (v + a w) e2 and its time derivative g e_x + lambda e2. Along e1, with e1' = w e2:
        m u' = m w (v + a w) + g cos phi.
    The angular momentum p = (J + m a^2) w + m a v has p' = dL/dphi + force = -m a w u - c w.
    The constraint is v = -b (-sin phi D^alpha x + cos phi D^alpha y). So x, y, phi, u, p and the two fractional
    derivatives, of order 1 - alpha from the velocities, are determined without lambda.
    """
    P = numbers(SLEIGH)
    motion = Motion(2)
    x, y = motion.state("0.1"), motion.state("-0.2")
    phi, u = motion.state(P["phi0"]), motion.state(P["u0"])
    inertia = P["J"] + P["m"] * P["a"] ** 2
    p = motion.state(inertia * mpf("0.8"))
    wx, wy = motion.state(0, 1), motion.state(0, 1)
    sine, cosine = sine_and_cosine(phi)
    v = P["b"] * (sine * wx - cosine * wy)
    w = (p - P["m"] * P["a"] * v) / inertia
    x.rate = wx.rate = u * cosine - v * sine
    y.rate = wy.rate = u * sine + v * cosine
    phi.rate = w
    u.rate = w * (v + P["a"] * w) + (P["g"] / P["m"]) * cosine
    p.rate = -(P["m"] * P["a"]) * (w * u) - P["c"] * w
    motion.solve(n)

    def check(t):
        d = lambda q, order: motion.derivative(q, order, t, n)
        angle = motion.value(phi, t, n)
        s, c = mp.sin(angle), mp.cos(angle)
        m, a, b = P["m"], P["a"], P["b"]
        x1, y1, f1, x2, y2, f2 = d(x, 1), d(y, 1), d(phi, 1), d(x, 2), d(y, 2), d(phi, 2)
        constraint = -s * (x1 + b * d(x, P["alpha"])) + c * (y1 + b * d(y, P["alpha"]))
        equations = [
            ([-s], m * x2 - m * a * (f2 * s + f1**2 * c) - P["g"]),
            ([c], m * y2 + m * a * (f2 * c - f1**2 * s)),
            (
                [mpf(0)],
                inertia * f2
                + m * a * (c * y2 - s * x2 - f1 * (s * y1 + c * x1))
                + m * a * f1 * (s * y1 + c * x1)
                + P["c"] * f1,
            ),
        ]
        multipliers, left = substituted(equations)
        return multipliers, max(left, abs(constraint))

    return motion, dict(x=x, y=y, phi=phi), check


DISC = dict(m="1.1", R="0.6", I="0.25", J="0.35", c="0.3", d="0.22", p="0.45", phi0="0.4", w0="1.2")


def rolling_disc_friction(n):
    """The reactions are lambda_1 on x, lambda_2 on y and -R (lambda_1 cos phi + lambda_2 sin phi) on psi.

    With lambda_1 = m x'' - p, lambda_2 = m y'' and the constraints differentiated,
    lambda_1 cos phi + lambda_2 sin phi = m R psi'' - p cos phi, so
        (I + m R^2) psi'' = R p cos phi - c D^0.5 psi,   J phi'' = -d D^0.7 phi.
    """
    P = numbers(DISC)
    motion = Motion(10)
    x, y = motion.state(0), motion.state("0.3")
    phi, psi = motion.state(P["phi0"]), motion.state("0.15")
    turning, rolling = motion.state("0.9"), motion.state(P["w0"])
    half, other = motion.state(0, 5), motion.state(0, 3)
    sine, cosine = sine_and_cosine(phi)
    phi.rate = other.rate = turning
    psi.rate = half.rate = rolling
    turning.rate = -(P["d"] / P["J"]) * other
    rolling.rate = (P["R"] * P["p"] * cosine - P["c"] * half) / (P["I"] + P["m"] * P["R"] ** 2)
    x.rate = P["R"] * (rolling * cosine)
    y.rate = P["R"] * (rolling * sine)
    motion.solve(n)

    def check(t):
        d = lambda q, order: motion.derivative(q, order, t, n)
        angle = motion.value(phi, t, n)
        s, c = mp.sin(angle), mp.cos(angle)
        R = P["R"]
        constraint = max(abs(d(x, 1) - R * d(psi, 1) * c), abs(d(y, 1) - R * d(psi, 1) * s))
        equations = [
            ([mpf(1), mpf(0)], P["m"] * d(x, 2) - P["p"]),
            ([mpf(0), mpf(1)], P["m"] * d(y, 2)),
            ([mpf(0), mpf(0)], P["J"] * d(phi, 2) + P["d"] * d(phi, mpf("0.7"))),
            ([-R * c, -R * s], P["I"] * d(psi, 2) + P["c"] * d(psi, mpf("0.5"))),
        ]
        multipliers, left = substituted(equations)
        # phi = phi0 + phi'(0) t E_{1.3,2}(-(d/J) t^1.3) by inversion of the Laplace transform.
        transform = lambda z: P["phi0"] / z + mpf("0.9") / (z**2 + (P["d"] / P["J"]) * z ** mpf("0.7"))
        second = abs(mp.invertlaplace(transform, t, method="talbot") - angle)
        return multipliers, max(left, constraint, second)

    return motion, dict(x=x, y=y, phi=phi, psi=psi), check


SPHERE = dict(b="0.45", k="0.6", alpha="0.4", theta0="1.1", e0="0.7")


def sphere_geodesic(n):
    """e = theta' and h = sin(theta) phi' are the velocities in an orthonormal frame:
        e' = cot(theta) h^2 - k lambda,   h' = -cot(theta) e h + lambda.
    The constraint is h - k e = -b w with w = sin(theta) D^alpha phi - k D^alpha theta. z = e + k h has no lambda in it:
        z' = cot(theta) h (h - k e) = -b cot(theta) h w,   e = (z + k b w)/(1 + k^2),   h = k e - b w.
    """
    P = numbers(SPHERE)
    motion = Motion(5)
    k, b = P["k"], P["b"]
    theta, phi = motion.state(P["theta0"]), motion.state("0.2")
    z = motion.state(P["e0"] * (1 + k**2))
    wt, wp = motion.state(0, 3), motion.state(0, 3)
    sine, cosine = sine_and_cosine(theta)
    w = sine * wp - k * wt
    e = (z + (k * b) * w) / (1 + k**2)
    h = k * e - b * w
    theta.rate = wt.rate = e
    phi.rate = wp.rate = h / sine
    z.rate = -b * ((cosine / sine) * (h * w))
    motion.solve(n)

    def check(t):
        d = lambda q, order: motion.derivative(q, order, t, n)
        angle = motion.value(theta, t, n)
        s, c = mp.sin(angle), mp.cos(angle)
        t1, p1 = d(theta, 1), d(phi, 1)
        constraint = s * (p1 + b * d(phi, P["alpha"])) - k * (t1 + b * d(theta, P["alpha"]))
        equations = [
            ([-k], d(theta, 2) - s * c * p1**2),
            ([s], s**2 * d(phi, 2) + 2 * s * c * t1 * p1),
        ]
        multipliers, left = substituted(equations)
        return multipliers, max(left, abs(constraint))

    return motion, dict(theta=theta, phi=phi), check


ORDERS = dict(a1="1.2", a2="0.7", b1="0.5", b2="-0.35", c1="0.15", c2="0.4", C="0.39", k1="2.3", k2="1.4", alpha="0.3", beta="0.6")
ORDERS_NONLINEAR = dict(ORDERS, s="0.3", h="0.55", r="0.8")


def two_orders(n, nonlinear=False):
    """q'' = -grad u + a lambda. Across a, z = a1 y' - a2 x' has z' = a2 du/dx - a1 du/dy; along a the constraint is
    a.q' = C + s sin t - b.D^alpha q - c.D^beta q. Then q' = (a (a.q') + (-a2, a1) z)/|a|^2.
    """
    P = numbers(ORDERS_NONLINEAR)
    if not nonlinear:
        P["s"] = P["h"] = P["r"] = mpf(0)
    motion = Motion(10)
    a1, a2 = P["a1"], P["a2"]
    norm = a1**2 + a2**2
    q0, v0 = (mpf("0.4"), mpf("-0.3")), (mpf("0.5"), mpf("-0.3"))
    x, y = motion.state(q0[0]), motion.state(q0[1])
    z = motion.state(a1 * v0[1] - a2 * v0[0])
    xa, ya, xb, yb = motion.state(0, 7), motion.state(0, 7), motion.state(0, 4), motion.state(0, 4)
    along = constant(P["C"]) - (P["b1"] * xa + P["b2"] * ya + P["c1"] * xb + P["c2"] * yb)
    ux, uy = P["k1"] * x, P["k2"] * y
    if nonlinear:
        along = along + P["s"] * sine_of_time(10)
        square = x * x
        ux = ux + (2 * P["h"]) * (x * y) + P["r"] * (square * x)
        uy = uy + P["h"] * square
    x.rate = xa.rate = xb.rate = (a1 * along - a2 * z) / norm
    y.rate = ya.rate = yb.rate = (a2 * along + a1 * z) / norm
    z.rate = a2 * ux - a1 * uy
    motion.solve(n)

    def transforms(p):
        """Both coordinates and the multiplier from the 3 x 3 system of the transforms."""
        weights = [a + b * p ** (P["alpha"] - 1) + c * p ** (P["beta"] - 1)
                   for a, b, c in ((a1, P["b1"], P["c1"]), (a2, P["b2"], P["c2"]))]
        # p Q - q(0) is the transform of q', and p^(alpha-1) (p Q - q(0)) that of D^alpha q.
        matrix = mp.matrix([[p**2 + P["k1"], 0, -a1], [0, p**2 + P["k2"], -a2], [p * weights[0], p * weights[1], 0]])
        right = mp.matrix([p * q0[0] + v0[0], p * q0[1] + v0[1], P["C"] / p + weights[0] * q0[0] + weights[1] * q0[1]])
        return mp.lu_solve(matrix, right)

    def check(t):
        d = lambda q, order: motion.derivative(q, order, t, n)
        X, Y = motion.value(x, t, n), motion.value(y, t, n)
        constraint = (
            a1 * d(x, 1) + a2 * d(y, 1) + P["b1"] * d(x, P["alpha"]) + P["b2"] * d(y, P["alpha"])
            + P["c1"] * d(x, P["beta"]) + P["c2"] * d(y, P["beta"]) - P["C"] - P["s"] * mp.sin(t)
        )
        equations = [
            ([a1], d(x, 2) + P["k1"] * X + 2 * P["h"] * X * Y + P["r"] * X**3),
            ([a2], d(y, 2) + P["k2"] * Y + P["h"] * X**2),
        ]
        multipliers, left = substituted(equations)
        worst = max(left, abs(constraint))
        if not nonlinear:
            for i, value in enumerate((X, Y)):
                worst = max(worst, abs(mp.invertlaplace(lambda p: transforms(p)[i], t, method="talbot", degree=40) - value))
        return multipliers, worst

    return motion, dict(x=x, y=y), check


def two_orders_nonlinear(n):
    return two_orders(n, nonlinear=True)


class Ritz:
    """Functions t^mu and (1-t)^gamma on [0, 1], less the line through their ends, with their exact fractional derivatives.

    D^alpha (1-t)^g = -g/Gamma(2-alpha) t^(1-alpha) F(1-g, 1; 2-alpha; t), F Gauss's function, transformed to 1-t near 1.
    Integrals are sums over the nodes of the double exponential rule, which exact values of both t and 1-t enter.
    """

    def __init__(self, alpha, left, right):
        self.alpha = mpf(alpha)
        self.basis = [("t", mpf(e)) for e in left if e != 1] + [("u", mpf(e)) for e in right]
        self.build_nodes()
        self.tables = [self.table(kind, e) for kind, e in self.basis]
        self.line = self.table("t", mpf(1))

    def build_nodes(self):
        digits = mp.mp.dps
        h = mpf(1) / NODES_PER_UNIT
        self.nodes = []
        top = mp.asinh(2 * (digits + 5) * mp.log(10) / mp.pi)
        for i in range(-int(top / h), int(top / h) + 1):
            y = mp.pi * mp.sinh(i * h)
            t, u = 1 / (1 + mp.exp(-y)), 1 / (1 + mp.exp(y))
            self.nodes.append((t, u, h * mp.pi * mp.cosh(i * h) * t * u))

    def fractional(self, kind, e, t, u):
        a = self.alpha
        if kind == "t":
            return mp.gamma(e + 1) / mp.gamma(e + 1 - a) * t ** (e - a)
        factor = -e * mp.rgamma(2 - a)
        if t < mpf(1) / 2:
            return factor * t ** (1 - a) * mp.hyp2f1(1 - e, 1, 2 - a, t)
        first = (1 - a) / (e - a) * t ** (1 - a) * mp.hyp2f1(1 - e, 1, 1 - e + a, u)
        return factor * (first + mp.gamma(2 - a) * mp.gamma(a - e) * mp.rgamma(1 - e) * u ** (e - a))

    def value(self, kind, e, t, u, order):
        base, sign = (t, 1) if kind == "t" else (u, -1)
        if order == 0:
            return base**e
        if order == 1:
            return sign * e * base ** (e - 1)
        return e * (e - 1) * base ** (e - 2)

    def at(self, kind, e, t, u):
        """Value, derivative, second derivative and fractional derivative of a function that is 0 at both ends."""
        a = self.alpha
        if (kind, e) == ("t", 1):
            return [t, mpf(1), mpf(0), self.fractional("t", mpf(1), t, u)]
        out = [self.value(kind, e, t, u, 0), self.value(kind, e, t, u, 1), self.value(kind, e, t, u, 2), self.fractional(kind, e, t, u)]
        line = self.fractional("t", mpf(1), t, u)
        if kind == "t":
            return [out[0] - t, out[1] - 1, out[2], out[3] - line]
        return [out[0] - u, out[1] + 1, out[2], out[3] + line]

    def table(self, kind, e):
        """Weighted by the square root of the weights, so that products need no more."""
        rows = [[], [], []]
        for t, u, weight in self.nodes:
            root = mp.sqrt(weight)
            value, first, _, fractional = self.at(kind, e, t, u)
            rows[0].append(value * root)
            rows[1].append(first * root)
            rows[2].append(fractional * root)
        return rows

    def solve(self, T, start, end, quadratic, linear, condition=None):
        """Stationary: half the integral of the quadratic form in (x, x', D^alpha x) plus that of the linear form, under
        an optional condition (form, value) on the integral of a linear form. Derivatives are those in t = T tau."""
        scale = (mpf(1), 1 / T, T ** (-self.alpha))
        count = len(self.basis)
        tables = [[[scale[j] * z for z in row[j]] for j in range(3)] for row in self.tables]
        root = [mp.sqrt(w) for _, _, w in self.nodes]
        slope = end - start
        particular = [[scale[j] * slope * z for z in self.line[j]] for j in range(3)]
        particular[0] = [start * r + z for r, z in zip(root, particular[0])]
        size = count + (1 if condition else 0)
        matrix, right = mp.zeros(size, size), mp.zeros(size, 1)

        def applied(table):
            return [[mp.fsum(quadratic[i][j] * table[j][n] for j in range(3) if quadratic[i][j]) for n in range(len(root))]
                    for i in range(3)]

        loads = applied(particular)
        for i in range(count):
            image = applied(tables[i])
            for j in range(i + 1):
                matrix[i, j] = matrix[j, i] = mp.fsum(mp.fdot(image[l], tables[j][l]) for l in range(3))
            right[i] = -mp.fsum(mp.fdot(loads[l], tables[i][l]) + linear[l] * mp.fdot(root, tables[i][l]) for l in range(3))
        if condition:
            form, total = condition
            for i in range(count):
                matrix[i, count] = matrix[count, i] = mp.fsum(form[l] * mp.fdot(root, tables[i][l]) for l in range(3))
            right[count] = total / T - mp.fsum(form[l] * mp.fdot(root, particular[l]) for l in range(3))
        solution = mp.lu_solve(matrix, right)
        self.T, self.start, self.slope = T, start, slope
        self.weights = [solution[i] for i in range(count)]
        self.multiplier = solution[count] if condition else None

    def evaluate(self, t):
        """x, x', x'' and D^alpha x at the time t."""
        tau = mpf(t) / self.T
        total = [self.start + self.slope * tau, self.slope, mpf(0), self.slope * self.fractional("t", mpf(1), tau, 1 - tau)]
        for weight, (kind, e) in zip(self.weights, self.basis):
            total = [z + weight * y for z, y in zip(total, self.at(kind, e, tau, 1 - tau))]
        T = self.T
        return [total[0], total[1] / T, total[2] / T**2, total[3] * T ** (-self.alpha)]

    def fractional_rate(self, t):
        """The derivative of D^alpha x, from D^alpha x' and the velocity at 0."""
        tau, a = mpf(t) / self.T, self.alpha
        u = 1 - tau
        straight = tau ** (-a) * mp.rgamma(1 - a)
        total = self.slope * straight
        for weight, (kind, e) in zip(self.weights, self.basis):
            if kind == "t":
                total += weight * (mp.gamma(e + 1) / mp.gamma(e - a) * tau ** (e - a - 1) - straight)
            else:
                total += weight * (-e * self.fractional("u", e - 1, tau, u) - e * straight + straight)
        return total * self.T ** (-a - 1)


NODES_PER_UNIT = 40


def exponents(start, steps, below):
    """All start + sums of the steps below a limit."""
    found, new = set(), {mpf(start)}
    while new:
        found |= new
        new = {mp.nint((e + mpf(d)) * 100) / 100 for e in new for d in steps} - found
        new = {e for e in new if e < below}
    return sorted(e for e in found if e < below)


def right_derivative(ritz, g, rate, t):
    """The right Riemann-Liouville derivative of order alpha from T of a function g with the given rate."""
    T, a = ritz.T, ritz.alpha
    power = 1 / (1 - a)
    # With s = t + r^power the kernel (s-t)^(-alpha) ds becomes power dr.
    top = (T - t) ** (1 - a)
    integral = mp.quad(lambda r: rate(t + r**power), [0, top / 2, top]) * power
    return mp.rgamma(1 - a) * (g(T) * (T - t) ** (-a) - integral)


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


INITIAL = {
    "chaplygin_sleigh": (SLEIGH, chaplygin_sleigh, ["0.3", "0.7", "1.0"], (280, 340)),
    "rolling_disc_friction": (DISC, rolling_disc_friction, ["0.5", "1.2", "2.0"], (1000, 1200)),
    "sphere_geodesic": (SPHERE, sphere_geodesic, ["0.3", "0.7", "1.0"], (640, 760)),
    "two_orders": (ORDERS, two_orders, ["0.5", "1.2", "2.0"], (400, 500)),
    "two_orders_nonlinear": (ORDERS_NONLINEAR, two_orders_nonlinear, ["0.3", "0.7", "1.0"], (400, 500)),
}
BOTH_ENDS = {
    "fractional_lagrangian": (LAGRANGIAN, fractional_lagrangian, ["0.3", "0.7", "1.1"], (6, 7)),
    "fractional_vakonomic_pair": (VAKONOMIC, fractional_vakonomic_pair, ["0.3", "0.8", "1.2"], (4, 5)),
}


def digits_of(error):
    return 30 if error == 0 else max(0, min(30, int(mp.floor(-mp.log10(error)))))


def as_number(value):
    return float(mp.nstr(value, 17))


def same_parameters(name, parameters):
    with open(os.path.join(HERE, name + ".toml"), "rb") as file:
        found = tomllib.load(file)["parameters"]
    if found != {key: float(value) for key, value in parameters.items()}:
        sys.exit(f"independent.py: the parameters of {name}.toml are not those here")


def series_values(name):
    parameters, system, times, lengths = INITIAL[name]
    same_parameters(name, parameters)
    tables = []
    for digits, length in zip((40, 60), lengths):
        mp.mp.dps = digits
        motion, coordinates, check = system(length)
        table, worst = {}, mpf(0)
        for text in times:
            t = mpf(text)
            multipliers, left = check(t)
            worst = max(worst, left)
            for key, series in coordinates.items():
                table.setdefault(key, []).append(motion.value(series, t, length))
            for key, series in coordinates.items():
                table.setdefault(f"D({key},1)", []).append(motion.derivative(series, 1, t, length))
            for i, value in enumerate(multipliers):
                table.setdefault(f"lambda{i + 1}" if len(multipliers) > 1 else "lambda", []).append(value)
        tables.append(table)
        print(f"{name}: length {length}, {digits} digits, left of the equations {mp.nstr(worst, 3)}", file=sys.stderr)
    change = max(abs(a - b) for key in tables[0] for a, b in zip(tables[0][key], tables[1][key]))
    print(f"{name}: the two differ by {mp.nstr(change, 3)}", file=sys.stderr)
    return times, tables[1], digits_of(max(change, worst))


def extremum_values(name):
    parameters, system, times, sizes = BOTH_ENDS[name]
    same_parameters(name, parameters)
    tables = []
    for digits, size, singular in ((70, sizes[0], False), (70, sizes[0], True), (90, sizes[1], True)):
        mp.mp.dps = digits
        columns, check = system(size, singular)
        table = {}
        for text in times:
            for key, value in columns(mpf(text)).items():
                table.setdefault(key, []).append(value)
        mp.mp.dps = 25
        worst = max(check(mpf(text)) for text in times)
        tables.append(table)
        change = max(abs(a - b) for key in table for a, b in zip(tables[-2][key], table[key])) if len(tables) > 1 else mpf(0)
        print(f"{name}: size {size}, singular powers {singular}, left of the equation {mp.nstr(worst, 3)}, "
              f"change {mp.nstr(change, 3)}", file=sys.stderr)
    return times, tables[-1], digits_of(max(change, worst))


def main():
    arguments = sys.argv[1:]
    out = None
    if "--out" in arguments:
        place = arguments.index("--out")
        out = arguments[place + 1]
        del arguments[place : place + 2]
    result = {}
    for name in arguments or [*INITIAL, *BOTH_ENDS]:
        times, table, digits = series_values(name) if name in INITIAL else extremum_values(name)
        columns = {key: [as_number(v) for v in values] for key, values in table.items() if not key.startswith("lambda")}
        multipliers = {key: [as_number(v) for v in values] for key, values in table.items() if key.startswith("lambda")}
        entry = {"times": [float(t) for t in times], "columns": columns, "digits": min(digits, 15)}
        if multipliers:
            entry["multipliers"] = multipliers
        result[name + ".toml"] = entry
    text = json.dumps(result, indent=1) + "\n"
    if out:
        with open(out, "w") as file:
            file.write(text)
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
