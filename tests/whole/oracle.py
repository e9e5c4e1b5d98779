# SPDX-License-Identifier: MIT
"""Solutions by collocation on given panels, in NumPy; shares nothing with the program.

The unknowns u_i(t) satisfy g(t, u, J^p u) = 0 at every t, with fractional integrals J^p u_i of orders p > 0. On each panel u is a
polynomial through the Radau points, in log(t - a) next to a time a where the problem jumps, in t elsewhere. The integrals of
polynomial times kernel are computed by Gauss rules on pieces no longer than their distance from t, and with the kernel as weight on
the last piece. The error is the difference of two resolutions. Earlier values are those of the polynomials through the nodes.
"""

from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import exp, lgamma

import numpy as np
from oracle_panels import GAUSS, Array, Panel, Shape, Uncertain, gauss, lagrange, legendre, panels, radau

FAR = 40.0  # e^-FAR is below the rounding


class History:
    """The nodes up to now with their values, and the weights of integrals over them."""

    def __init__(self, orders: Sequence[float]) -> None:
        self.orders = list(orders)
        self.panels: list[Panel] = []
        self.nodes: tuple[list[Array], ...] = ([], [], [], [])

    def push(self, panel: Panel) -> None:
        self.panels.append(panel)
        measures = panel.z
        if panel.kind != "point":
            measures = np.log(radau(len(panel.z))[1] * (panel.high - panel.low) / 2) + (panel.z if panel.kind == "log" else 0)
        for known, one in zip(self.nodes, (np.full(len(panel.z), panel.anchor), panel.offsets, panel.logs, measures)):
            known.append(one)

    def far(self, target: Panel, p: float, anchors: Array, offsets: Array, logs: Array, measures: Array) -> Array:
        """The weights by the rule of the nodes themselves."""
        x = target.logs[:, None]
        same = anchors == target.anchor
        apart = (target.anchor - anchors) + (target.offsets[:, None] - offsets)
        # Next to an anchor differences are those of logarithms, since offsets may be below the least double.
        distance = np.where(same, x + np.log(-np.expm1(np.minimum(logs - x, -1e-300))), np.log(np.maximum(apart, 1e-300)))
        return np.exp((p - 1) * distance + measures)

    def point(self, target: Panel, source: Panel, p: float) -> Array:
        x = target.logs if target.anchor == source.anchor else np.log(target.anchor - source.anchor + target.offsets)
        return -np.exp(p * x - lgamma(p + 1)) * np.expm1(p * np.log1p(-np.exp(source.high - x)))

    def near(self, target: Panel, source: Panel, p: float) -> Array:
        """The weights of a panel which is longer than its distance from the target."""
        in_logs, length = source.kind == "log", source.high - source.low
        if in_logs and target.anchor == source.anchor:
            beyond = target.logs - source.high
        else:
            end = np.exp(source.high) if in_logs else source.high
            between = target.anchor - source.anchor - end
            beyond = (between if abs(between) > 1e-14 * target.anchor else 0.0) + target.offsets
            beyond = np.log1p(beyond / end) if in_logs else beyond
        # Pieces between distances from the panel's end, of which the last are as short as the distance of the target.
        edges = list(np.linspace(length, 0, int(np.ceil(length / 2)) + 1 if in_logs else 2))
        while edges[-2] > beyond[0] > 0 and len(edges) < 1100:
            edges.insert(-1, edges[-2] / 2)
        rule, weights = legendre(GAUSS)
        half = -np.diff(edges) / 2
        d = (np.array(edges[1:])[:, None] + half[:, None] * (1 + rule)).ravel()
        w = (half[:, None] * weights).ravel()
        apart = beyond[:, None] + d
        if in_logs:
            kernel = np.exp((p - 1) * (source.high + beyond[:, None] + np.log(-np.expm1(-apart))) + source.high - d)
        else:
            kernel = apart ** (p - 1)
        return (kernel * w) @ lagrange(len(source.z), 1 - 2 * d / length) / exp(lgamma(p))

    def own(self, panel: Panel, p: float) -> Array:
        """The weights of a panel's own nodes."""
        if panel.kind == "point":
            return np.array([[np.exp(p * panel.high - lgamma(p + 1))]])
        length = panel.high - panel.low
        if panel.kind == "log":
            return np.exp(p * panel.high) * self.scaled(len(panel.z), p, round(length, 10))
        return length ** p * self.scaled(len(panel.z), p, 0.0)

    @staticmethod
    @lru_cache(None)
    def scaled(count: int, p: float, length: float) -> Array:
        """The own weights of [0, 1], or of [e^-length, 1] in logarithms."""
        v, weights = gauss(p)
        rule, w = legendre(GAUSS)
        rows = []
        for c in (1 + radau(count)[0]) / 2:
            if not length:
                rows.append(c ** p * weights @ lagrange(count, 2 * c * (1 - v) - 1))
                continue
            # From the node backwards: a piece with the kernel as weight, then pieces of about 1.
            x, last = (c - 1) * length, min(c * length, 1.0)
            d = last * v
            factor = last ** p * weights * np.exp((p - 1) * (x + np.log(-np.expm1(-d) / d)) + x - d)
            row = factor @ lagrange(count, 2 * (c - d / length) - 1)
            if (rest := c * length - last) > 0:
                half = rest / np.ceil(rest) / 2
                d = (last + half * (2 * np.arange(np.ceil(rest))[:, None] + 1 + rule)).ravel()
                kernel = np.exp((p - 1) * (x + np.log(-np.expm1(-d))) + x - d)
                row = row + (kernel * np.tile(half * w, int(np.ceil(rest)))) @ lagrange(count, 2 * (c - d / length) - 1)
            rows.append(row)
        return np.array(rows) / exp(lgamma(p))

    def weights(self, target: Panel) -> dict[float, Array]:
        """For each order a row for each node of the target, a column for each earlier node."""
        if not self.panels:
            return {p: np.zeros((len(target.z), 0)) for p in self.orders}
        anchors, offsets, logs, measures = (np.concatenate(one) for one in self.nodes)
        found = {p: self.far(target, p, anchors, offsets, logs, measures) / exp(lgamma(p)) for p in self.orders}
        begin = 0
        for source in self.panels:
            place = slice(begin, begin + len(source.z))
            begin += len(source.z)
            if source.kind == "point":
                for p in self.orders:
                    found[p][:, place] = self.point(target, source, p)[:, None]
            elif self.is_near(target, source):
                for p in self.orders:
                    found[p][:, place] = self.near(target, source, p)
        return found

    @staticmethod
    def is_near(target: Panel, source: Panel) -> bool:
        if source.kind == "log" and target.anchor == source.anchor:
            gap, length = target.logs[0] - source.high, source.high - source.low
            return gap < length or (length > 2.5 and gap < FAR)
        begin, end = (np.exp(source.low), np.exp(source.high)) if source.kind == "log" else (source.low, source.high)
        gap = target.anchor - source.anchor + target.offsets[0] - end
        return gap < end - begin or (source.kind == "log" and source.high - source.low > 2.5 and gap < end)


Residual = Callable[[Array, float, list, list], list]


class Past:
    """The columns at the nodes of the panels solved so far, and the values before t = 0."""

    def __init__(self, before: Callable[[str, float], float]) -> None:
        self.before = before
        self.solved: list[tuple[Panel, dict[str, Array]]] = []
        self.ends: list[float] = []

    def push(self, panel: Panel, columns: dict[str, Array]) -> None:
        self.solved.append((panel, columns))
        self.ends.append(panel.anchor + float(panel.offsets[-1]))

    def value(self, name: str, times: Array) -> Array:
        return np.array([self.at(name, float(t)) for t in np.atleast_1d(times)])

    def at(self, name: str, t: float) -> float:
        if t < 0:
            return float(self.before(name, t))
        panel, columns = self.solved[min(bisect_left(self.ends, t), len(self.ends) - 1)]
        if panel.kind == "point" or t <= panel.anchor:
            return float(columns[name][0])
        z = t - panel.anchor if panel.kind == "linear" else np.log(t - panel.anchor)
        x = np.clip(2 * (z - panel.low) / (panel.high - panel.low) - 1, -1, 1)
        return float((lagrange(len(panel.z), np.array([x])) @ columns[name])[0])


@dataclass(frozen=True)
class Equations:
    """g(t, middle, u, integrals) = 0, for arrays of times; `middle` is a time within the panel, by which steps are decided."""

    count: int
    integrals: Sequence[tuple[int, float]]  # (unknown, order)
    residual: Residual
    start: Sequence[float]  # near the values of u at 0
    columns: Callable[[float, list, list], dict[str, float]]
    past: Past | None = None  # where the residual looks back


def advance(equations: Equations, panel: Panel, past: dict[float, Array], own: dict[float, Array], values: list[Array],
            last: Array, level: dict[int, tuple[float, Array]]) -> tuple[Array | None, list]:
    """The values of the unknowns on a panel by Newton's method, with derivatives by a complex step; and the integrals.

    The first guess leaves the integrals in `level` as they are before the panel: unlike constant u, it stays next to the same root."""
    m, n = len(panel.z), equations.count
    times = panel.anchor + panel.offsets
    low, high = (0 if panel.kind == "point" else panel.offsets[0]), panel.offsets[-1]
    middle = max(panel.anchor + (low + high) / 2, np.nextafter(panel.anchor, np.inf))
    before = [past[p] @ values[i] for i, p in equations.integrals]
    u = np.repeat(last[:, None], m, axis=1)
    try:
        for i, (p, value) in level.items():
            u[i] = np.linalg.solve(own[p], value - past[p] @ values[i])
    except np.linalg.LinAlgError:
        return None, []
    for _ in range(25):
        integrals = [h + own[p] @ u[i] for h, (i, p) in zip(before, equations.integrals)]
        g = np.array([np.broadcast_to(one, (m,)) for one in equations.residual(times, middle, list(u), integrals)], dtype=float)
        jacobian = np.zeros((n, m, n, m))
        diagonal = np.arange(m)
        for k in range(n):
            moved = [one + (1e-30j if j == k else 0) for j, one in enumerate(u)]
            for row, one in enumerate(equations.residual(times, middle, moved, integrals)):
                jacobian[row, diagonal, k, diagonal] += np.imag(one) * 1e30
        for place, (k, p) in enumerate(equations.integrals):
            moved = [one + (1e-30j if j == place else 0) for j, one in enumerate(integrals)]
            for row, one in enumerate(equations.residual(times, middle, list(u), moved)):
                derivative = np.broadcast_to(np.imag(one) * 1e30, (m,))
                jacobian[row, :, k, :] += derivative[:, None] * own[p]
        try:
            change = np.linalg.solve(jacobian.reshape(n * m, n * m), g.ravel()).reshape(n, m)
        except np.linalg.LinAlgError:
            return None, []
        u = u - change
        if not np.isfinite(u).all():
            return None, []
        if np.abs(change).max() <= 1e-12 * (1e-3 + np.abs(u).max()):
            return u, [h + own[p] @ u[i] for h, (i, p) in zip(before, equations.integrals)]
    return None, []


def trajectory(equations: Equations, shape: Shape, outputs: Sequence[float], nodes: int, scale: float) -> list[dict[str, float]]:
    orders = sorted({p for _, p in equations.integrals})
    history = History(orders)
    if equations.past:
        equations.past.__init__(equations.past.before)
    values = [np.zeros(0) for _ in range(equations.count)]
    guess, found = np.array(equations.start, dtype=float), []
    mesh, halvings = panels(shape, outputs, scale), 0
    left, level = sorted(outputs), {}
    lowest = {i: min(p for j, p in equations.integrals if j == i) for i, _ in equations.integrals}
    while mesh:
        if (len(mesh) + len(history.panels)) * nodes > 5000:
            raise Uncertain(f"{len(mesh)} panels")
        panel = mesh.pop(0)
        panel.z = np.array([panel.high]) if panel.kind == "point" else panel.low + (panel.high - panel.low) * (1 + radau(nodes)[0]) / 2
        past, own = history.weights(panel), {p: history.own(panel, p) for p in orders}
        for start in (level, {}):
            u, integrals = advance(equations, panel, past, own, values, guess, start)
            if u is not None and (panel.kind == "point" or continues(u, guess)):
                break
        else:
            halvings += 1
            if panel.kind == "point" or halvings > 60:
                raise Uncertain(f"nothing continues the solution at t = {panel.anchor + panel.offsets[0]:g}")
            middle = (panel.low + panel.high) / 2
            mesh[:0] = [Panel(panel.kind, panel.anchor, panel.low, middle), Panel(panel.kind, panel.anchor, middle, panel.high)]
            continue
        history.push(panel)
        values = [np.concatenate([one, more]) for one, more in zip(values, u)]
        guess = u[:, -1]
        if equations.past:
            equations.past.push(panel, equations.columns(panel.anchor + panel.offsets, list(u), integrals))
        level = {i: (p, integrals[equations.integrals.index((i, p))][-1]) for i, p in lowest.items()}
        time = panel.anchor + panel.offsets[-1]
        if left and abs(time - left[0]) <= 4e-16 * time:
            found.append(equations.columns(left.pop(0), list(u[:, -1]), [one[-1] for one in integrals]))
    return found


def continues(u: Array, last: Array) -> bool:
    begin = u @ lagrange(u.shape[1], np.array([-1.0]))[0]
    return bool((np.abs(begin - last) <= 0.02 * (1e-3 + np.abs(u).max(axis=1))).all())


def solution(equations: Equations, shape: Shape, outputs: Sequence[float]) -> list[dict[str, tuple[float, float]]]:
    """For each output (sorted) the columns with their values and errors."""
    with np.errstate(all="ignore"):
        coarse, fine = (trajectory(equations, shape, outputs, nodes, scale) for nodes, scale in ((6, 1.0), (9, 0.8)))
    if len(fine) != len(outputs) or len(coarse) != len(outputs):
        raise Uncertain("an output is missing")
    return [{name: (value, abs(value - other[name]) + 1e-13 * abs(value)) for name, value in one.items()} for one, other in zip(fine, coarse)]
