# SPDX-License-Identifier: MIT
"""Motions as power series in s = t^(1/m), whose coefficients are computed one after another."""

import mpmath as mp
from mpmath import mpf


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
