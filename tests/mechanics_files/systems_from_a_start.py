# SPDX-License-Identifier: MIT
"""Five mechanical systems with initial values, their equations of motion derived by hand."""

import mpmath as mp
from mpmath import mpf

from power_series import Motion, constant, numbers, sine_and_cosine, sine_of_time, substituted

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
