# SPDX-License-Identifier: MIT
"""Functions between two ends with exact fractional derivatives from both, among which an action is minimised."""

import mpmath as mp
from mpmath import mpf

NODES_PER_UNIT = 40


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
