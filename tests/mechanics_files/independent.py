#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Independent values of seven mechanical systems, from their equations of motion as derived by hand in systems_*.py.

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

from systems_between_ends import LAGRANGIAN, VAKONOMIC, fractional_lagrangian, fractional_vakonomic_pair
from systems_from_a_start import (
    DISC, ORDERS, ORDERS_NONLINEAR, SLEIGH, SPHERE, chaplygin_sleigh, rolling_disc_friction, sphere_geodesic, two_orders, two_orders_nonlinear,
)

HERE = os.path.dirname(os.path.abspath(__file__))

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
