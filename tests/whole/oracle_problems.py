# SPDX-License-Identifier: MIT
"""Equation files and constrained mechanics as equations of the oracle.

The oracle is told where a load is steep: the parameters place1, width1, omega1, place2, ... are times, widths and frequencies, and
`step`, `max`, `min` and `abs` of t alone have their jumps and kinks where their arguments are written to be 0."""

import re
import tomllib
from collections.abc import Callable
from dataclasses import replace
from math import gamma, pi

import numpy as np

from case import Case
from oracle import Equations, Past
from oracle_panels import Array, Shape, Uncertain

FUNCTIONS = {name: getattr(np, name) for name in ("sin", "cos", "tanh", "sinh", "cosh", "exp", "log", "sqrt", "abs")}
FUNCTIONS |= {"atan": np.arctan, "min": np.minimum, "max": np.maximum, "gamma": gamma, "pi": pi, "step": lambda x: np.where(x > 0, 1.0, 0.0)}
STEP = re.compile(r"step\(([^()]*)\)")
SWITCH = re.compile(r"\b(?:step|max|min|abs)\((?:0, |1, |max\(0, )*\(?(?:t - ([^(),]+?)|([^(),]+?) - t)\)?[,)/]")
EARLIER = re.compile(r"\b([a-z])\((?=t - ([^()]+)\))")
NUMBER = re.compile(r"(?<![\w.])\d+\.?\d*(?:e[+-]?\d+)?(?![\w.])")


def compiled(formula: str) -> Callable[[dict], Array]:
    """A formula as a function of the values of its names; `middle` decides steps of t."""
    text = STEP.sub(lambda found: "step(" + re.sub(r"\bt\b", "middle", found[1]) + ")", formula).replace("^", "**")
    code = compile(text, formula, "eval")
    return lambda names: eval(code, {"__builtins__": {}}, {**FUNCTIONS, **names})  # noqa: S307


def parameters(case: Case, document: dict) -> dict[str, float]:
    found = {name: float(value) for name, value in document.get("parameters", {}).items()}
    return found | {name: float(value) for name, value in case.chosen.items() if name in found}


def steep(texts: list[str], names: dict[str, float], end: float, least: float) -> Shape:
    """Where loads are steep, by the names of parameters and the arguments of switches."""
    jumps: set[float] = set()
    for text in texts:
        for found in SWITCH.finditer(text):
            jumps.add(float(compiled(found[1] or found[2])(names)))
    pulses = []
    for name, place in names.items():
        if (kind := re.fullmatch(r"place(\d)", name)) and (width := names.get(f"width{kind[1]}")):
            omega = names.get(f"omega{kind[1]}", 0.0)
            smooth = any(f"{name})/width{kind[1]})^2)" in text for text in texts)
            pulses.append((place, (4.5 if smooth else 1.0) * width, min(width / 3, 2 / max(omega, 1e-9))))
            if any(f"abs(t - {name})/width" in text or f"(t - {name})/width{kind[1]}))" in text for text in texts):
                jumps |= {place - width, place, place + width}
    fast = max([1.0, *(value for name, value in names.items() if name.startswith("omega") and f"width{name[-1]}" not in names)])
    rate = max([1.0, *map(abs, names.values()), *(float(number) for text in texts for number in NUMBER.findall(text))])
    return Shape(end, tuple(jumps), tuple(pulses), min(end / 10, 1.5 / fast), least, rate)


def sums(lags: set[float], end: float) -> set[float]:
    """The times that sums of lags reach."""
    found, newest = set(), {0.0}
    while newest := {round(a + lag, 12) for a in newest for lag in lags if a + lag < end} - found:
        found |= newest
    return found


def power(t: Array, q: float) -> Array:
    """D^q of t."""
    return t ** (1 - q) / gamma(2 - q) if q < 1 else (1.0 if q == 1 else 0.0)


def file_problem(case: Case, end: float) -> tuple[Equations, Shape]:
    document = tomllib.loads("\n".join(case.file))
    names = parameters(case, document)

    def number(value: object) -> float:
        return float(compiled(value)(names)) if isinstance(value, str) else float(value)  # type: ignore[arg-type]

    rows, integrals = [], []
    texts = [row["rhs"] for row in document["unknown"].values()]
    lags = {float(compiled(found[2])(names)) for text in texts for found in EARLIER.finditer(text) if found[1] in document["unknown"]}
    before = {name: compiled(row.get("before", "0")) for name, row in document["unknown"].items()}
    past = Past(lambda name, t: before[name](names | {"t": t})) if lags else None
    for name, row in document["unknown"].items():
        terms = [(number(c), number(q)) for c, q in row.get("terms", [[1, row.get("order", 0)]])]
        leading, initial = max(q for _, q in terms), [number(one) for one in row["initial"]] + [0.0]
        rows.append((name, leading, terms, initial, compiled(EARLIER.sub(r"earlier_\1(", row["rhs"]))))
        integrals += [(len(rows) - 1, leading - q) for q in {0.0, *(q for _, q in terms)} if q < leading]

    def derivative(index: int, q: float, t: Array, u: list, values: list) -> Array:
        name, leading, _, initial, _ = rows[index]
        if q == leading:
            return u[index]
        return (initial[0] if q == 0 else 0) + initial[1] * power(t, q) + values[integrals.index((index, leading - q))]

    def unknowns(t: Array, u: list, values: list) -> dict:
        return {row[0]: u[k] if row[1] == 0 else derivative(k, 0, t, u, values) for k, row in enumerate(rows)}

    def residual(t: Array, middle: float, u: list, values: list) -> list:
        known = {**names, "t": t, "middle": middle, **unknowns(t, u, values)}
        if past:
            known |= {f"earlier_{row[0]}": lambda times, name=row[0]: past.value(name, times) for row in rows}
        return [right(known) if leading == 0 else sum(c * derivative(k, q, t, u, values) for c, q in terms) - right(known)
                for k, (_, leading, terms, _, right) in enumerate(rows)]

    shape = steep(texts, names, end, min((p for _, p in integrals), default=1.0))
    if lags:
        shape = replace(shape, jumps=(*shape.jumps, *sums(lags, end)), longest=min(shape.longest, min(lags) / 1.4))
    start = [initial[0] if leading == 0 else 0.0 for _, leading, _, initial, _ in rows]
    return Equations(len(rows), integrals, residual, start, unknowns, past), shape


def mechanics_problem(names: dict[str, float], columns: tuple[str, ...], end: float) -> tuple[Equations, Shape]:
    """Two unit masses in (k1 x^2 + k2 y^2 + k3 x^2 y^2)/2 + g y with friction c1 D^q x under a.v + b.w = C, w = D^alpha (x, y).

    With the impulse J^1 lambda = J^s m of the reaction, which is along a, all of v = v0 + J^1 p + a J^s m, w, D^q x and x are integrals of
    the forces p and of m, where s is 0 below order 1 and alpha - 1 above it: nothing is differentiated."""
    alpha, q = names["alpha"], names.get("q", 0.5)
    a, b, v0, x0 = ([names[f"{letter}{k}"] for k in (1, 2)] for letter in "abvq")
    k1, k2, k3, c1, g = (names.get(name, 0.0) for name in ("k1", "k2", "k3", "c1", "g"))
    constant = names.get("C0", a[0] * v0[0] + a[1] * v0[1])
    s = max(0.0, alpha - 1)
    kinds = sorted({0.0, 1.0, alpha, *([q] if c1 else [])})  # orders of the derivatives of x and y
    impulses = {r: 0.0 if r == alpha > 1 else 1 - r + s for r in kinds}
    integrals = [(i, 2 - r) for i in (0, 1) for r in kinds] + [(2, impulses[r]) for r in kinds if impulses[r] > 0]

    def derivative(i: int, r: float, t: Array, u: list, values: list) -> Array:
        from_impulse = values[integrals.index((2, impulses[r]))] if impulses[r] > 0 else u[2]
        return (x0[i] if r == 0 else 0) + v0[i] * power(t, r) + values[integrals.index((i, 2 - r))] + a[i] * from_impulse

    def residual(t: Array, _: float, u: list, values: list) -> list:
        x, y = (derivative(i, 0.0, t, u, values) for i in (0, 1))
        forces = [u[0] + k1 * x + k3 * x * y ** 2 + (c1 * derivative(0, q, t, u, values) if c1 else 0), u[1] + k2 * y + k3 * x ** 2 * y + g]
        return [*forces, sum(a[i] * derivative(i, 1.0, t, u, values) + b[i] * derivative(i, alpha, t, u, values) for i in (0, 1)) - constant]

    def printed(t: float, u: list, values: list) -> dict:
        return dict(zip(columns, [derivative(i, r, t, u, values) for r in (0.0, 1.0, alpha) for i in (0, 1)]))

    least = min([abs(alpha - 1), 2 - alpha, *(p for _, p in integrals)])
    shape = Shape(end, (), (), min(end / 10, 1 / max(1, k1, k2) ** 0.5), least, max([1.0, *map(abs, names.values())]))
    return Equations(3, integrals, residual, [0.0, 0.0, 0.0], printed), shape


def problem(case: Case, end: float) -> tuple[Equations, Shape]:
    if case.scene:
        return mechanics_problem({name: float(value) for name, value in case.chosen.items() if name not in ("formulation", "until")}, ("q1", "q2", "v1", "v2", "w1", "w2"), end)
    document = tomllib.loads("\n".join(case.file))
    if "mechanics" in document:
        return mechanics_problem(parameters(case, document), ("x", "y", "D(x,1)", "D(y,1)", "w1", "w2"), end)
    if "unknown" not in document:
        raise Uncertain("not a file of equations")
    return file_problem(case, end)
