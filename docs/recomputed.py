#!/usr/bin/env python3
"""recomputed.py FDEBENCH: motions of the papers beside values that share no line of fdebench's code.

Multipliers are eliminated here by hand; linear motions are Talbot inversions, nonlinear ones power series in
t^(1/M) or a Taylor method. Needs python3-mpmath.
"""
import subprocess
import sys

from mpmath import (cos, exp, expj, gamma, invertlaplace, lu_solve, matrix, mp, mpf, odefun, pade, pi,
                    polyval, sin)

mp.dps = 40


def number(x):
    return mpf(str(x))


def exact(scene, t):
    text = subprocess.run([sys.argv[1], "exact", scene, "--at", str(t)], check=True, capture_output=True, text=True)
    names, values = (line.split(",") for line in text.stdout.splitlines())
    return dict(zip(names, map(float, values)))


def compare(scene, t, known):
    ours = exact(scene, t)
    print(f"fdebench exact {scene} --at {t}")
    for name, value in known.items():
        print(f"  {name} {ours[name]:.15g} {mp.nstr(value, 15)} {float(abs(ours[name] - value)):.1e}")


def label(scene, values):
    return scene + ":" + ",".join(f"{name}={value}" for name, value in values.items())


def inverse(transform, t):
    return invertlaplace(transform, number(t), method="talbot", degree=50)


def plane(t, **values):
    """a.v + b.D^alpha q = C0 on springs: lambda from the transform of the constraint."""
    p = {name: number(value) for name, value in values.items()}
    alpha, both = p["alpha"], (1, 2)
    a, b, k, q, v = ([p[f"{name}{i}"] for i in both] for name in "abkqv")
    constant = p.get("C0", a[0] * v[0] + a[1] * v[1])

    def solve(s):
        start = [s ** (alpha - 1) * q[i] + (s ** (alpha - 2) * v[i] if alpha > 1 else 0) for i in range(2)]
        free = [(s * q[i] + v[i]) / (s * s + k[i]) for i in range(2)]
        row = [a[i] * s + b[i] * s ** alpha for i in range(2)]
        goal = constant / s + sum(a[i] * q[i] + b[i] * start[i] for i in range(2))
        answer = (goal - sum(row[i] * free[i] for i in range(2))) / sum(
            row[i] * a[i] / (s * s + k[i]) for i in range(2))
        place = [free[i] + answer * a[i] / (s * s + k[i]) for i in range(2)]
        return place + [s * place[i] - q[i] for i in range(2)] + [answer]

    known = {name: inverse(lambda s, i=i: solve(s)[i], t) for i, name in enumerate(("q1", "q2", "v1", "v2", "lambda"))}
    known["power"] = known["lambda"] * (a[0] * known["v1"] + a[1] * known["v2"])
    compare(label("fractional_constraint_2d", values), t, known)


def line(t, **values):
    """a q' + b D^alpha q = C0."""
    p = {name: number(value) for name, value in values.items()}
    alpha, a, b = p["alpha"], p["a"], p["b"]
    start = [p[f"q{k}"] for k in range(3) if alpha > k]
    constant = p.get("C0", a * p["q1"])

    def place(s):
        memory = sum(value * s ** (alpha - 1 - k) for k, value in enumerate(start))
        return (constant / s + a * start[0] + b * memory) / (a * s + b * s ** alpha)

    rate = lambda s: s * place(s) - start[0]
    compare(label("fractional_constraint_1d", values), t,
            {"q": inverse(place, t), "v": inverse(rate, t),
             "lambda": inverse(lambda s: (s * rate(s) - p["q1"]) / a, t)})


def chain_with_memory(power, parts, t, terms, **values):
    """v.v/2 + c v.w = K, alpha = power/parts: v = sum V_n u^n, lambda = sum L_n u^(n-power), u = t^(1/parts)."""
    c, k = number(values["coupling"]), number(values["k"])
    size = terms + parts + 1
    q, v, w = ([[mpf(0)] * size for _ in range(2)] for _ in range(3))
    answer = []

    def integrate(n):
        for i in range(2):
            q[i][n + parts] = v[i][n] * parts / mpf(n + parts)
            if n + parts - power < size:
                w[i][n + parts - power] = v[i][n] * gamma(mpf(n) / parts + 1) / gamma(mpf(n - power) / parts + 2)

    for i in range(2):
        q[i][0], v[i][0] = number(values[f"q{i + 1}"]), number(values[f"v{i + 1}"])
    integrate(0)
    for n in range(1, terms + 1):
        j, m = n - parts + power, n - parts
        rows, goal = matrix(3, 3), matrix(3, 1)
        for i in range(2):
            pushed = sum(answer[r] * (v[i][j - r] + c * w[i][j - r]) for r in range(max(j, 0)))
            goal[i] = pushed - (k * (2 * q[i][m] - q[1 - i][m]) if m >= 0 else 0)
            rows[i, i], rows[2, i] = mpf(n) / parts, v[i][0]
            rows[i, 2] = -v[i][0] if j >= 0 else 0
            goal[2] -= sum(v[i][r] * v[i][n - r] for r in range(1, n)) / 2
            goal[2] -= c * sum(v[i][r] * w[i][n - r] for r in range(n))
        if j >= 0:
            v[0][n], v[1][n], last = lu_solve(rows, goal)
            answer.append(last)
        integrate(n)

    def value(series):
        half = terms // 2
        above, below = pade(series[:2 * half + 1], half, half)
        u = number(t) ** (mpf(1) / parts)
        return polyval(above[::-1], u) / polyval(below[::-1], u)

    scene = label("fractional_constraint_nonlinear", {"alpha": power / parts, **values, "until": t})
    compare(scene, t, {"q1": value(q[0]), "q2": value(q[1]), "v1": value(v[0]), "v2": value(v[1]),
                       "w1": value(w[0])})


def blade(t, **values):
    """Heading and speed alone: theta' = V cos psi, sin(theta) phi' = V sin psi, V' = g sin(theta) cos psi."""
    theta, psi, speed, spin, inertia, g = (
        number(values[name]) for name in ("theta0", "psi0", "speed", "spin", "inertia", "gravity"))

    def rates(_, y):
        turn = y[3] * sin(y[2]) / sin(y[0])
        return [y[3] * cos(y[2]), turn, spin - turn * cos(y[0]), g * sin(y[0]) * cos(y[2])]

    mp.dps = 25
    y = odefun(rates, 0, [theta, mpf(0), psi, speed])(number(t))
    down, turn = rates(0, y)[:2]
    push = (g - inertia * spin * turn) * sin(y[0]) * sin(y[2]) - inertia * spin * down * cos(y[2])
    compare(label("blade_on_sphere", values), t,
            {"theta": y[0], "phi": y[1], "psi": y[2], "lambda": -y[3] * spin - push})
    mp.dps = 40


def oscillator(t, **values):
    """Tarasov & Zaslavsky's g is the residues, f what is left."""
    nu, w2, q0, dq0, c2 = (number(values[name]) for name in ("nu", "w2", "q0", "dq0", "c2"))
    whole = lambda s: (q0 * s ** (nu - 1) + dq0 * s ** (nu - 2) + c2 * s ** (nu - 3)) / (s ** nu + w2)
    pole = w2 ** (1 / nu) * expj(pi / nu)
    top = q0 * pole ** (nu - 1) + dq0 * pole ** (nu - 2) + c2 * pole ** (nu - 3)
    g = 2 * (top / (nu * pole ** (nu - 1)) * exp(pole * number(t))).real
    q = inverse(whole, t)
    compare(label("fractional_oscillator", {**values, "parts": "apart"}), t, {"q": q, "f": q - g, "g": g})


start = dict(k1=1, k2=2, q1=1, q2=0, v1=0.4, v2=-0.2)
plane(1, alpha=1.5, a1=1, a2=0.5, b1=0.8, b2=0.3, **start, C0=0)
plane(2.2, alpha=1.35, a1=0.8, a2=1.3, b1=0.4, b2=0.7, **start, C0=-0.3)
plane(2.2, alpha=0.65, a1=0.8, a2=-1.3, b1=0.4, b2=0.7, **start)
plane(1.3, alpha=1.4, a1=1, a2=2, b1=2, b2=-1, **start)
line(2.3, alpha=2.4, a=1.2, b=0.7, q0=0.4, q1=-0.8, q2=0.9, C0=0.3)
line(2.3, alpha=1.25, a=1.2, b=0.7, q0=0.4, q1=-0.8, q2=0, C0=0)
chain_with_memory(3, 5, 0.1, 120, coupling=-0.5, k=1.3, q1=0.3, q2=-0.6, v1=-0.5, v2=0.9)
chain_with_memory(9, 10, 0.01, 120, coupling=-0.5, k=1.3, q1=0.3, q2=-0.6, v1=-0.5, v2=0.9)
blade(3, theta0=0.9, psi0=1.4, speed=0.9, spin=-0.7, inertia=0.8, gravity=0.5)
oscillator(2.4, nu=1.3, w2=2.1, q0=0.7, dq0=-0.4, c2=0.6)
