#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""gallery.py FDEBENCH: each equation file of docs/examples has a section and a small picture in docs/gallery.md, two schemes give its
reference, and that agrees with transforms and formulas evaluated here."""

import csv
import math
import re
import subprocess
import sys
import unittest
from pathlib import Path

from mpmath import invertlaplace, mp

DOCS = Path(__file__).resolve().parents[2] / "docs"
EXAMPLES = sorted(path.stem for path in (DOCS / "examples").glob("*.toml"))
PROGRAM = sys.argv.pop(1)


def rows(command, name, *words):
    """The columns of a table that fdebench prints, as lists of numbers."""
    done = subprocess.run([PROGRAM, command, DOCS / f"examples/{name}", *words], capture_output=True, text=True, check=True)
    header, *lines = csv.reader(done.stdout.splitlines())
    return dict(zip(header, zip(*(map(float, line) for line in lines))))


def exact(name, *times):
    return rows("exact", name, "--at", ",".join(map(str, times)))


def transformed(of_s, t):
    """The function whose Laplace transform is of_s, by Talbot's contour."""
    with mp.workdps(30):
        return float(invertlaplace(of_s, t, method="talbot"))


def runge_kutta(f, y, end, steps):
    """y' = f(y) by the classical method of order 4."""
    h = end / steps
    for _ in range(steps):
        a = f(y)
        b = f([v + h / 2 * k for v, k in zip(y, a)])
        c = f([v + h / 2 * k for v, k in zip(y, b)])
        d = f([v + h * k for v, k in zip(y, c)])
        y = [v + h / 6 * (p + 2 * q + 2 * r + s) for v, p, q, r, s in zip(y, a, b, c, d)]
    return y


class Page(unittest.TestCase):
    def test_every_file_has_a_section_and_a_picture(self):
        page, script = (DOCS / "gallery.md").read_text(), (DOCS / "gallery.sh").read_text()
        sections = re.findall(r"^## .*?(?=^## |\Z)", page, re.MULTILINE | re.DOTALL)
        shown = [name for section in sections for name in re.findall(r"\(examples/(\w+)\.toml\)", section)]
        self.assertEqual(sorted(shown), EXAMPLES)
        self.assertEqual(re.findall(r"\(plots/gallery/(\w+)\.svg\)", page), shown)
        self.assertEqual(re.findall(r"(?m)^draw (\w+)", script), shown)
        self.assertEqual(sorted(path.stem for path in (DOCS / "plots/gallery").iterdir()), EXAMPLES)
        for picture in (DOCS / "plots/gallery").iterdir():
            self.assertLess(picture.stat().st_size, 12_000, picture.name)


class Examples(unittest.TestCase):
    def assert_near(self, found, wanted, error):
        self.assertLess(abs(found - wanted) / (1 + abs(wanted)), error)

    def test_two_schemes_give_the_reference(self):
        for name in EXAMPLES:
            scene = f"{name}.toml" + (":until=1.5" if name == "falling" else "")  # before it is on the ground
            # Starting weights are exact for few of the powers of control, and a kink leaves order 2.
            grid = ["bdf4", "--steps", {"control": "8000", "measured_load": "16000"}.get(name, "4000")]
            if name == "radiation":  # an algebraic row
                grid = ["product_trapezoidal", "--steps", "4000", "--grid", "graded:4"]
            for words, error in [(["spectral_collocation", "--accuracy", "1e-9"], 1e-8), (grid, 1e-6)]:
                run = rows("solve", scene, "--points", "6", "--scheme", *words)
                known = exact(scene, *run["t"])
                self.assertEqual(len(run["t"]), 6)
                for column in run.keys() & known.keys():
                    for found, wanted in zip(run[column], known[column]):
                        with self.subTest(name, scheme=words[0], column=column):
                            self.assert_near(found, wanted, error)

    def test_duffing_starts_with_the_power_of_its_order(self):
        """x = 1/5 + c t^1.8 / Gamma(2.8) + O(t^3.1), where c is the right-hand side at the start."""
        known, t = exact("duffing.toml", 1e-3), 1e-3
        self.assertAlmostEqual((known["x"][0] - 0.2) / (t**1.8 / math.gamma(2.8)), 0.3 - 0.2 - 0.2**3, delta=1e-4)

    def test_falling_is_its_transform(self):
        known = exact("falling.toml", 1, 10)
        for t, x in zip(known["t"], known["x"]):
            self.assert_near(x, 1 - transformed(lambda s: 1 / (s * s * (s + 0.5 * mp.sqrt(s))) , t), 1e-13)

    def test_zener_is_its_transform(self):
        known = exact("zener.toml", 0.5, 5, 20)
        for t, x in zip(known["t"], known["x"]):
            self.assert_near(x, transformed(lambda s: 1 / (s * (s * s + (1 + 4 * s**0.6) / (1 + s**0.6))), t), 1e-13)

    def test_control_is_its_transform(self):
        def controlled(s):
            plant, controller = 0.8 * s**2.2 + 0.5 * s**0.9 + 1, 20.5 + 3.7343 * s**1.15
            return controller / (plant + controller) / s

        known = exact("control.toml", 0.2, 3, 10)
        for t, y0, y in zip(known["t"], known["y0"], known["y"]):
            self.assert_near(y0, transformed(lambda s: 1 / (0.8 * s**2.2 + 0.5 * s**0.9 + 1) / s, t), 1e-13)
            self.assert_near(y, transformed(controlled, t), 1e-13)

    def test_plate_is_its_transform_scaled_to_its_place_at_the_end(self):
        known = exact("plate.toml", 0.5, 1.5, 3)
        values = [transformed(lambda s: (1 + s**-0.5 / 2) / (s * s + s**1.5 / 2 + 0.5), t) for t in known["t"]]
        for found, value in zip(known["y"], values):
            self.assert_near(found, value / values[-1], 1e-13)

    def test_subdiffusion_is_a_sum_over_modes(self):
        """Mode k of n cells decays like E_alpha(-4 sin^2(pi k / 2n) t^alpha)."""
        n, t = 11, 2.5
        known = exact("subdiffusion.toml", t)
        modes = [transformed(lambda s: s**-0.4 / (s**0.6 + 4 * mp.sin(mp.pi * k / (2 * n))**2), t) for k in range(n)]
        for cell in range(1, n + 1):
            parts = [math.cos(math.pi * k * (cell - 0.5) / n) * math.cos(math.pi * k * 5.5 / n) * mode for k, mode in enumerate(modes)]
            self.assert_near(known[f"u[{cell}]"][0], (parts[0] + 2 * sum(parts[1:])) / n, 1e-13)

    def test_epidemic_keeps_the_population_and_kermacks_integral(self):
        known = exact("epidemic.toml", 5, 30, 60)
        for share in zip(known["S"], known["I"], known["R"]):
            self.assert_near(sum(share), 1, 1e-14)
        classical = exact("epidemic.toml:alpha=1", 5, 30, 60)
        integral = [i + s - 0.4 * math.log(s) for s, i in zip(classical["S"], classical["I"])]
        for value in integral:
            self.assert_near(value, 1 - 0.4 * math.log(0.99), 1e-12)

    def test_roessler_at_order_one_is_the_classical_system(self):
        classical = exact("roessler.toml:q1=1,q2=1,q3=1", 5)
        wanted = runge_kutta(lambda u: [-u[1] - u[2], u[0] + 0.5 * u[1], 0.2 + u[2] * (u[0] - 10)], [0.5, 1.5, 0.1], 5, 4000)
        for column, value in zip("xyz", wanted):
            self.assert_near(classical[column][0], value, 1e-9)

    def test_delayed_growth_at_order_one_is_hutchinsons_equation(self):
        # By the classical Runge-Kutta method with steps of 2 h; x[k] is x(k h - 1), so that a delay is 1/h places.
        back = 400
        h, x = 1 / back, [0.1] * (back + 1)
        growth = lambda value, earlier: 1.5 * value * (1 - earlier)  # noqa: E731
        for k in range(0, 6 * back, 2):
            now, (first, middle, last) = x[-1], x[k : k + 3]
            a = growth(now, first)
            b = growth(now + h * a, middle)
            c = growth(now + h * b, middle)
            d = growth(now + 2 * h * c, last)
            after = now + h / 3 * (a + 2 * b + 2 * c + d)
            # The middle by Hermite's polynomial, of the same order as the method.
            x += [(now + after) / 2 + h / 4 * (a - growth(after, last)), after]
        self.assert_near(exact("delayed_growth.toml:g=1", 6)["x"][0], x[-1], 1e-8)

    def test_radiation_is_known_for_newtons_law_and_by_the_trapezoidal_rule(self):
        self.assert_near(exact("radiation.toml:n=1", 1)["u"][0], math.exp(1) * math.erfc(1), 1e-14)
        # u = 1 - J^1/2 u^4 with u^4 linear between the times (k/N)^4, at which its integral against (t - s)^-1/2 is known.
        times, u = [(k / 300) ** 4 for k in range(301)], [1.0]
        for t in times[1:]:
            known, last = 1.0, 0.0
            for k in range(len(u)):
                a, b = times[k], times[k + 1]
                whole = 2 * (math.sqrt(t - a) - math.sqrt(t - b))
                moment = 2 / 3 * ((t - a) ** 1.5 - (t - b) ** 1.5)  # of t - s
                upper = (whole * (t - a) - moment) / (b - a)
                known -= (whole - upper) * u[k] ** 4 / math.sqrt(math.pi)
                if k + 1 < len(u):
                    known -= upper * u[k + 1] ** 4 / math.sqrt(math.pi)
                else:
                    last = upper / math.sqrt(math.pi)
            value = u[-1]
            for _ in range(30):
                value -= (value + last * value**4 - known) / (1 + 4 * last * value**3)
            u.append(value)
        self.assert_near(exact("radiation.toml", 1)["u"][0], u[-1], 2e-6)

    def test_multi_order_is_its_formula(self):
        known = exact("multi_order.toml", 0.25, 1)
        for t, *found in zip(*(known[name] for name in ("t", "y1", "y2", "y3"))):
            for value, wanted in zip(found, [t + 1, t**1.2 + 0.5, t**1.8 + 0.3]):
                self.assert_near(value, wanted, 1e-15)

    def test_sleigh_keeps_its_constraint(self):
        for residual in exact("sleigh.toml", 1, 5, 10)["constraint"]:
            self.assertLess(abs(residual), 1e-10)


if __name__ == "__main__":
    unittest.main()
