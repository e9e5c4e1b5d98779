#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""kinds.py FDEBENCH [--write]: the table of docs/kinds.md, one row for each file of docs/examples/kinds.

Each solution is computed here a second time, by series and inverse Laplace transforms that share no line with fdebench. A value outside
of its bound, a rate that is not the theoretical one, and a solution that the page does not have, end the program. --write puts the rows into
the page, with what `fdebench choose` recommends. Needs mpmath.
"""
import csv
import json
import subprocess
import sys
from pathlib import Path

from mpmath import erfc, exp, factorial, findroot, gamma, invertlaplace, log, mp, mpf, pi, sin, sqrt

DOCS = Path(__file__).resolve().parent
FILES = DOCS / "examples/kinds"
mp.dps = 40


def inverse(transform, t):
    """The function with this Laplace transform; 0 up to t = 0."""
    return invertlaplace(transform, t, method="talbot", degree=60) if t > 0 else mpf(0)


def variable_coefficients(t, terms=240):
    """y = sum c_k t^(k/2), with D^(1/2) t^p = Gamma(p+1)/Gamma(p+1/2) t^(p-1/2)."""
    sine = [(-1) ** (k // 4) / factorial(k // 2) if k % 4 == 2 else mpf(0) for k in range(terms)]
    c, half = [mpf(1), mpf(0), mpf(0), mpf(0)], []
    for k in range(4, terms):
        half += [c[j] * gamma(mpf(j) / 2 + 1) / gamma(mpf(j + 1) / 2) for j in range(len(half) + 1, k - 2)]
        damping = sum(sine[j] * half[k - 4 - j] for j in range(k - 3))
        c.append(-(damping + (c[k - 6] if k >= 6 else 0)) / (mpf(k) / 2 * (mpf(k) / 2 - 1)))
    return sum(ck * t ** (mpf(k) / 2) for k, ck in enumerate(c))


def both_ends(t, terms=60):
    """w = sum c_j t^(1 + 7j/2); c_0 = w'(0) from w(1) = 1."""

    def at(slope, t):
        c = [mpf(slope)]
        for j in range(1, terms):
            cube = sum(c[i] * c[k] * c[j - 1 - i - k] for i in range(j) for k in range(j - i))
            c.append(-cube * gamma(mpf(7) / 2 * j + mpf(1) / 2) / gamma(mpf(7) / 2 * j + 2))
        return sum(ck * t ** (1 + mpf(7) / 2 * k) for k, ck in enumerate(c))

    return at(findroot(lambda slope: at(slope, mpf(1)) - 1, (mpf(1), mpf("1.1")), tol=mpf("1e-60")), t)


def delay(t):
    """The delayed Mittag-Leffler function from t = -1 on."""
    return sum(mpf("-1.5") ** k * max(t - k + 1, 0) ** (k * mpf("0.8")) / gamma(k * mpf("0.8") + 1) for k in range(int(t) + 2))


def samples(t):
    ramp = lambda t: inverse(lambda s: 1 / (s**2 * (sqrt(s) + 1)), t)
    return sum(change * ramp(t - k) for k, change in enumerate((mpf(2), mpf(-5), mpf("4.5"), mpf(-2))))


def start_and_steps(t):
    order = mpf("0.7")
    power = lambda p, t: inverse(lambda s: s**p / (s**order + 1), t)
    loads = power(-1, t - 1) / 4 + power(-2, t - 1) - mpf(3) / 4 * sum(power(-1, t - at) for at in (mpf("1.5"), mpf("2.25")))
    return power(order - 1, t - 1) / 2 + loads


def distributed_order(t):
    """The integral of 6 q (1-q) s^q over q from 0 to 1 has a closed form."""
    symbol = lambda s: 6 * ((s + 1) * log(s) - 2 * (s - 1)) / log(s) ** 3
    return inverse(lambda s: symbol(s) / s / (symbol(s) + 1), t)


FIELD = mpf("0.1") * 4 * 100**2 * sin(pi / 200) ** 2  # the smallest eigenvalue of the matrix


def relaxation(order, rate, t):
    return inverse(lambda s: s ** (order - 1) / (s**order + rate), t)


def six_terms(s):
    return s**3 + s ** mpf("2.5") / 16 + mpf("0.8") * s**2 + mpf("1.5") * s + mpf("0.04") * sqrt(s) + mpf("1.2")


def plant(s):
    return (2 * sqrt(s) + 1) / (s ** mpf("2.2") + mpf("0.9") * s ** mpf("1.1") + 1)


# For each file: what it shows, a time, the solution then, and a rule over uniform grids with the rate that it should have there.
KINDS = {
    "variable_coefficients": ("any order on the right, variable coefficients", "3", variable_coefficients, "bdf2", 2),
    "derivative_of_load": ("derivative of a known function", "3", lambda t: inverse(lambda s: 3 * s ** mpf("0.4") / (s**2 + 9) / (sqrt(s) + 1), t), "bdf2", 2),
    "abel_first_kind": ("Abel's equation of the first kind", "2", lambda t: inverse(lambda s: 1 / (sqrt(s) * (s + 1)), t), "product_trapezoidal", 1.5),
    "abel_second_kind": ("Abel's equation of the second kind", "2", lambda t: exp(t) * erfc(sqrt(t)), "product_trapezoidal", 1.5),
    "volterra": ("Volterra equation of the second kind with another kernel", "2", lambda t: inverse(lambda s: 1 / s / (1 + 1 / sqrt(s + 2)), t), "grunwald_letnikov", 1),
    "order_three": ("order above 2, six terms", "10", lambda t: inverse(lambda s: mpf("1.376") * s / (s**2 + mpf("0.64")) / six_terms(s), t), "bdf2", 2),
    "delay": ("delay", "3", delay, "bdf3", 1.8),
    "plant": ("transfer function with an input", "10", lambda t: inverse(lambda s: plant(s) / (s**2 + 1), t), "bdf2", 2),
    "samples": ("sampled input", "4", samples, "product_trapezoidal", 2),
    "both_ends": ("values at both ends", "0.5", both_ends, "product_trapezoidal", 2),
    "riemann_liouville": ("Riemann-Liouville derivative", "2", lambda t: inverse(lambda s: 1 / (sqrt(s) + 1), t), "bdf2", 2),
    "distributed_order": ("distributed order", "2", distributed_order, "l1", 1),
    "impulses": ("impulses at events", "3.5", lambda t: sum(relaxation(mpf("0.8"), 1, t - k) for k in range(4)), None, None),
    "start_and_steps": ("another start; a sawtooth", "3", start_and_steps, "grunwald_letnikov", 1),
    "vector": ("field as a vector of unknowns", "1", lambda t: relaxation(mpf("0.8"), FIELD, t), "bdf2", 2),
}


def fdebench(*arguments):
    return subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True, check=True, cwd=FILES).stdout


def exact(name, t):
    """The first column of the reference, and its bound."""
    row = [float(value) for value in list(csv.reader(fdebench("exact", f"{name}.toml", "--at", t).splitlines()))[-1]]
    return row[1], row[-1]


def error(name, t, known, scheme, steps):
    last = list(csv.reader(fdebench("solve", f"{name}.toml", "--scheme", scheme, "--steps", str(steps), "--at", t).splitlines()))[-1]
    return abs(float(last[1]) - known)


def rate(name, t, known, scheme):
    """Over grids that contain the breaking points of the files."""
    steps = 1536
    return float(log(error(name, t, known, scheme, steps) / error(name, t, known, scheme, 2 * steps), 2))


def row(name, what, time, solution, scheme, theory):
    known = solution(mpf(time))
    value, bound = exact(name, time)
    if abs(value - known) > bound + mpf(2) ** -52 * abs(known):
        sys.exit(f"{name}: {value} to {bound:.1e} at t = {time}, {mp.nstr(known, 17)} by mpmath")
    rates = "grids locate no events"
    if scheme:
        measured = rate(name, time, known, scheme)
        if abs(measured - theory) > 0.1:
            sys.exit(f"{name}: {scheme} has the rate {measured:.3f}, theory {theory}")
        rates = f"`{scheme}` {measured:.2f}, theory {theory}"
    return f"| [{what}](examples/kinds/{name}.toml) | {time} | {mp.nstr(known, 11)} | {float(abs(value - known)):.0e} | {bound:.0e} | {rates} |"


def recommended(name):
    """What `choose` answers to an error of 1e-8 at the end."""
    answer = json.loads(fdebench("choose", f"{name}.toml", "--error", "1e-8", "--norm", "end", "--json", "--quiet"))
    how = f"to {answer['asked']:.1e}" if answer["asked"] else f"N = {answer['steps']}"
    return f" `{answer['scheme']}` {how} | {answer['error']:.0e} | {answer['seconds'] * 1e3:.2g} ms |"


def main():
    page = (DOCS / "kinds.md").read_text()
    rows = [row(name, *about) for name, about in KINDS.items()]
    if "--write" in sys.argv:
        rows = [one + recommended(name) for one, name in zip(rows, KINDS)]
        above, _, below = page.partition("|---|")
        rule, _, below = below.partition("\n")
        below = below[below.index("\n\n") :]
        (DOCS / "kinds.md").write_text(above + "|---|" + rule + "\n" + "\n".join(rows) + below)
        return
    missing = [one for one in rows if "\n" + "|".join(one.split("|")[:4]) not in page]  # errors depend on the machine
    sys.exit("\n".join(["docs/kinds.md does not have", *missing]) if missing else 0)


if __name__ == "__main__":
    main()
