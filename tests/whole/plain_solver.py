# SPDX-License-Identifier: MIT
"""Equation files solved by Grünwald-Letnikov's rule in plain Python, which shares nothing with the program.

An unknown is a sum of terms c (t - a)^p/Gamma(p + 1) and of w, which is 0 at the start. The terms are the initial values, the singular powers
of a Riemann-Liouville derivative and the jumps at events. D^q is exact on the terms, and on w it is (1 - z)^q/h^q as a power series in the
backward shift z, with an error of order h; three steps h show it."""

import ast
import math
import operator
import tomllib
from bisect import bisect_right

from plain_formulas import Formulas, Uncertain

Known = list[dict[str, tuple[float, float]]]
State = dict[str, float]
STEPS = (300, 600, 1200)
ORDERS = 200  # in place of distributed ones
PLACES = 64  # on a step at which events are looked for
UNABLE = (NameError, ValueError, TypeError, AttributeError, LookupError, ArithmeticError, SyntaxError)


def sign_of(value: float) -> int:
    return 0 if abs(value) < 1e-9 else 1 if value > 0 else -1


class Unknown:
    def __init__(self, row: dict, formulas: Formulas, start: float) -> None:
        if set(row) - {"order", "terms", "rhs", "initial", "before", "derivative"}:
            raise Uncertain("a key of an unknown")
        self.terms: list[tuple[float, float]] = []  # coefficients and orders
        for one in row.get("terms", [[1, row.get("order", 0)]]):
            if isinstance(one, dict):
                width = (one["to"] - one["from"]) / ORDERS
                orders = [one["from"] + (k + 0.5) * width for k in range(ORDERS)]
                self.terms += [(width * formulas.number(one["weight"], q=q), q) for q in orders]
            else:
                self.terms.append((formulas.number(one[0]), formulas.number(one[1])))
        self.leading = max(q for _, q in self.terms)
        self.initial = [formulas.number(one) for one in row["initial"]]
        self.is_singular = row.get("derivative") == "riemann-liouville"
        self.starts = [(start, self.leading - 1 - k if self.is_singular else k, c) for k, c in enumerate(self.initial) if self.leading]
        self.right, self.before = formulas.code(row["rhs"]), formulas.code(row.get("before", "0"))
        self.w = [0.0]

    def known(self, t: float, q: float = 0.0) -> float:
        """D^q of the terms, which is 0 for q above p; a singular one has no D^q."""
        return sum(c * (t - a) ** (p - q) / math.gamma(p - q + 1) for a, p, c in self.starts if t >= a and (p >= q or q == 0))


class Run:
    """The file solved with `count` steps."""

    def __init__(self, text: str, end: float, count: int) -> None:
        document = tomllib.loads(text)
        if set(document) - {"start", "end", "title", "source", "parameters", "unknown", "event", "jump", "exact"}:
            raise Uncertain("a section")
        self.formulas = formulas = Formulas(document)
        start = formulas.number(document.get("start", 0))
        self.count, self.h, self.t = count, (end - start) / count, [start]
        self.unknowns = {name: Unknown(row, formulas, start) for name, row in document["unknown"].items()}
        self.events = [self.event(one) for one in document.get("event", {}).values() if "set" in one]
        self.passed: list[float] = []  # the times of events
        self.weights = {name: [sum(column) for column in zip(*([c * g for g in self.power(q)] for c, q in one.terms))] for name, one in self.unknowns.items()}
        self.of_nodes = [self.power(-q if letter == "J" else q) if letter != "x" else [0.0] for letter, _, q in formulas.nodes]
        self.integrands: list[list[float]] = [[] for _ in formulas.nodes]
        self.states, self.sides = [], [0] * len(self.events)
        self.push(self.state(start, {name: math.inf if one.is_singular else one.initial[0] for name, one in self.unknowns.items()}, [0.0] * len(formulas.nodes)))
        for k in range(1, count + 1):
            self.step(start + k * self.h)

    def power(self, q: float) -> list[float]:
        found = [self.h ** -q]
        for k in range(1, self.count + 1):
            found.append(found[-1] * (k - 1 - q) / k)
        return found

    def event(self, one: dict) -> tuple:
        """The code of the function, the signs after crossings that count, and what is set: unknown, order, its code before and after."""
        sets = []
        for key, formula in one["set"].items():
            of = ast.parse(key, mode="eval").body
            name, order = (key, 0.0) if isinstance(of, ast.Name) else (of.args[0].id, self.formulas.number(ast.unparse(of.args[1])))
            sets.append((name, order, self.formulas.code(key), self.formulas.code(str(formula))))
        return self.formulas.code(one["zero"]), {"rising": (1,), "falling": (-1,)}.get(one.get("crossing"), (1, -1)), sets

    def state(self, t: float, values: State, sums: list[float]) -> State:
        """t, the unknowns and the nodes."""
        state = {"t": t, **values}
        for k, (letter, of, q) in enumerate(self.formulas.nodes):
            if letter == "x":
                state[f"node{k}"] = self.at(of, t - q)
            elif letter == "D":
                state[f"node{k}"] = self.unknowns[of].known(t, q) + sums[k] + self.of_nodes[k][0] * (values[of] - self.unknowns[of].known(t))
            else:
                state[f"node{k}"] = sums[k] + self.of_nodes[k][0] * self.formulas.value(of, state)
        return state

    def at(self, name: str, t: float) -> float:
        one = self.unknowns[name]
        if t <= self.t[0]:
            return self.formulas.value(one.before, {"t": t})
        k = bisect_right(self.t, t) - 1
        if k + 1 == len(one.w):
            if t > self.t[k]:
                raise Uncertain("a short delay")
            return self.states[k][name]
        return one.known(t) + one.w[k] + (t - self.t[k]) / self.h * (one.w[k + 1] - one.w[k])

    def push(self, state: State) -> None:
        self.states.append(state)
        for k, (letter, of, _) in enumerate(self.formulas.nodes):
            value = self.formulas.value(of, state) if letter == "J" else 0.0
            self.integrands[k].append(value if math.isfinite(value) else 0.0)
        self.sides = [sign or side for sign, side in zip(self.signs(state), self.sides)]

    def signs(self, state: State) -> list[int]:
        return [sign_of(self.formulas.value(zero, state)) for zero, _, _ in self.events]

    def step(self, t: float) -> None:
        def newest(weights: list[float], values: list[float]) -> float:
            return sum(map(operator.mul, weights[1:], reversed(values)))

        sums = [newest(weights, self.unknowns[of].w if letter == "D" else values) for weights, (letter, of, _), values in zip(self.of_nodes, self.formulas.nodes, self.integrands)]
        rows = {name: newest(self.weights[name], one.w) for name, one in self.unknowns.items()}
        values = self.solved(t, sums, rows)
        if self.set_at_events(t, self.state(t, values, sums)):
            values = self.solved(t, sums, rows)
            self.sides = [0] * len(self.events)
        self.t.append(t)
        for name, one in self.unknowns.items():
            one.w.append(values[name] - one.known(t))
        self.push(self.state(t, values, sums))

    def residual(self, t: float, values: State, sums: list[float], rows: State) -> list[float]:
        state, found = self.state(t, values, sums), []
        for name, one in self.unknowns.items():
            left = rows[name] + self.weights[name][0] * (values[name] - one.known(t)) + sum(c * one.known(t, q) for c, q in one.terms if q < one.leading)
            found.append((left if one.leading else 0.0) - self.formulas.value(one.right, state))
        return found

    def solved(self, t: float, sums: list[float], rows: State) -> State:
        """Newton's method with differences."""
        values = {name: value if math.isfinite(value) else 0.0 for name, value in self.states[-1].items() if name in self.unknowns}
        for _ in range(40):
            here, columns = self.residual(t, values, sums, rows), []
            for name, value in values.items():
                step = 1e-7 * (1 + abs(value))
                columns.append([(a - b) / step for a, b in zip(self.residual(t, values | {name: value + step}, sums, rows), here)])
            change = eliminated([[*row, right] for *row, right in zip(*columns, here)])
            values = {name: value - one for (name, value), one in zip(values.items(), change)}
            if all(abs(one) <= 1e-10 * (1 + abs(value)) for one, value in zip(change, values.values())):
                return values
        raise Uncertain("Newton's method")

    def set_at_events(self, t: float, state: State) -> bool:
        """Adds the jumps of the events in the step to t."""
        last, crossed = self.states[-1], []

        def between(part: float) -> State:
            return {name: last[name] + part * (state[name] - last[name]) for name in state}

        ends = self.signs(state)
        for k in range(1, PLACES if self.events else 0):
            if any(side and sign == -side == -end for side, sign, end in zip(self.sides, self.signs(between(k / PLACES)), ends)):
                raise Uncertain("two events in one step")
        for (zero, counts, sets), side, sign in zip(self.events, self.sides, ends):
            if side and sign == -side and sign in counts:
                a, b = self.formulas.value(zero, last), self.formulas.value(zero, state)
                crossed.append((a / (a - b), sets))
        if not crossed:
            return False
        part = min(one for one, _ in crossed)
        if any(one > part + 1e-6 for one, _ in crossed) or not 0 <= part <= 1 or len(self.passed) > 100:
            raise Uncertain("two events in one step")
        before = between(part)
        self.passed.append(before["t"])
        for name, order, old, new in (one for _, sets in crossed for one in sets):
            self.unknowns[name].starts.append((before["t"], order, self.formulas.value(new, before) - self.formulas.value(old, before)))
        return True


def eliminated(rows: list[list[float]]) -> list[float]:
    """The solution of a linear system, each row with its right-hand side."""
    for k in range(len(rows)):
        rows[k:] = sorted(rows[k:], key=lambda row: -abs(row[k]))
        rows = [row if i == k else [a - row[k] / rows[k][k] * b for a, b in zip(row, rows[k])] for i, row in enumerate(rows)]
    return [row[-1] / row[k] for k, row in enumerate(rows)]


def solution(text: str, times: list[float]) -> Known:
    """For each time the unknowns with their values and errors, where no event is near."""
    try:
        runs = [Run(text, max(times), count) for count in STEPS]
        found = [[{name: run.at(name, t) for name in run.unknowns} for t in times] for run in runs]
    except UNABLE as wrong:
        raise Uncertain(f"{type(wrong).__name__}: {wrong}") from None
    if len({len(run.passed) for run in runs}) > 1:
        raise Uncertain("other events")
    rate = min([1.0, *(1 + p for one in runs[0].unknowns.values() for _, p, _ in one.starts)])  # of a singular right-hand side
    safety, known = 8 / (2 ** rate - 1), []  # jumps of loads and events are at any part of a step
    for t, a, b, c in zip(times, *found):
        near = any(abs(t - fine) <= 3 * max(abs(fine - middle), abs(middle - coarse)) + 1e-9 * t for coarse, middle, fine in zip(*(run.passed for run in runs)))
        known.append({} if near else {name: (c[name], safety * max(abs(c[name] - b[name]), abs(b[name] - a[name]) / 2) + 1e-6 * (1 + abs(c[name])))
                                      for name in c if abs(c[name] - b[name]) <= min(0.97, 1.6 * 2 ** -rate) * abs(b[name] - a[name]) + 1e-6 * (1 + abs(c[name]))})
    return known
