# SPDX-License-Identifier: MIT
"""Properties of mittag-leffler, stability, poles, geometry and the lists."""

import json
import math
from decimal import Decimal, getcontext
from random import Random

from case import Case
from drawn_numbers import spread, typed
from drawn_scenes import Lists, drawn_scene
from program import Fault, Program
from properties import must_hold
from table import Table

getcontext().prec = 60


def drawn_function(random: Random, lists: Lists) -> Case:
    alpha, beta = typed(random.choice([random.uniform(0.05, 2), random.uniform(0.05, 5), 1, 2, 0.5]), 3), typed(random.choice([1, 2, random.uniform(-3, 6)]), 3)
    z = typed(random.choice([-1, 1]) * spread(random, 1e-6, 200), 4)
    if random.random() < 0.4:
        z += f",{typed(random.uniform(-20, 20), 3)}"
    return Case("mittag_leffler_is_within_its_bound", words=(alpha, beta, z), options=random.choice([{}, {}, {"--derivative": "1"}, {"--gamma": "1.5"}]))


@must_hold(drawn_function)
def mittag_leffler_is_within_its_bound(program: Program, case: Case, lists: Lists) -> None:
    """The double is within its bound of the value with 30 digits; E_{a,b}(z) = z E_{a,a+b}(z) + 1/Gamma(b) within both bounds."""
    alpha, beta, z = case.words
    ended = program.run("mittag-leffler", *case.words, *case.given(), "--budget", "10")
    if not ended.done:
        return
    re, im, bound = map(Decimal, ended.out.split())
    long = program.run("mittag-leffler", *case.words, *case.given(), "--digits", "30", "--budget", "20")
    if long.done:
        more = list(map(Decimal, long.out.split()))
        if max(abs(re - more[0]), abs(im - more[1])) > bound + more[2]:
            raise Fault("bound", f"{ended.out.strip()}, with 30 digits {long.out.strip()}")
    next_one = program.run("mittag-leffler", alpha, str(Decimal(alpha) + Decimal(beta)), z, "--digits", "30", "--budget", "20")
    if case.options or not (long.done and next_one.done) or (float(beta) <= 0 and float(beta) == int(float(beta))):
        return
    parts = [Decimal(p) for p in z.split(",")] + [Decimal(0)]
    a, b, off = map(Decimal, next_one.out.split())
    right = parts[0] * a - parts[1] * b + Decimal(1 / math.gamma(float(beta)))
    size = abs(parts[0] * a) + abs(parts[1] * b) + 1
    if abs(right - more[0]) > Decimal("1e-13") * size + off * (abs(parts[0]) + abs(parts[1])) + more[2]:
        raise Fault("recurrence", f"E = {long.out.strip()}, z E_(a,a+b) + 1/Gamma(b) = {right}")


def drawn_stability(random: Random, lists: Lists) -> Case:
    some = random.sample(list(lists.schemes), random.randint(1, 3))
    options = {"--gamma": typed(random.uniform(0.05, 1.99), 3)}
    if random.random() < 0.4:
        options["--delay"] = str(round(spread(random, 0.6, 10400)))
    return Case("stability_is_a_table", words=tuple(w for s in some for w in ("--scheme", s)), options=options)


@must_hold(drawn_stability, 0.3)
def stability_is_a_table(program: Program, case: Case, lists: Lists) -> None:
    ended = program.run("stability", *case.given(), *case.words, seconds=60)
    if not ended.done:
        return
    rows = Table.read(ended.out).rows
    if len(rows) == 0:
        raise Fault("rows", "no scheme has a row")
    if int(case.options.get("--delay", 0)) >= 32 and not all(0 < float(row[1]) < 2 * float(row[2]) for row in rows):
        raise Fault("interval", "no scheme is stable far beyond the equation: " + str(rows))


def drawn_poles(random: Random, lists: Lists) -> Case:
    scene, chosen = drawn_scene(random, lists, 0.3)
    return Case("poles_come_in_pairs", scene=scene, chosen=chosen, options={"--frequencies": typed(spread(random, 1e-3, 1e3), 3)})


@must_hold(drawn_poles, 0.4)
def poles_come_in_pairs(program: Program, case: Case, lists: Lists) -> None:
    """The conjugate of a pole is one; the note agrees with the real parts."""
    ended = program.run("poles", *case.problem())
    if ended.done:
        poles = [(float(re), float(im), int(count)) for re, im, count in Table.read(ended.out).rows]
        if any(not math.isfinite(re + im) or not any(abs(re - a) + abs(im + b) <= 1e-9 * math.hypot(re, im) and n == m for a, b, m in poles) for re, im, n in poles):
            raise Fault("pairs", ended.out)
        growing = any(re > 1e-9 * math.hypot(re, im) for re, im, _ in poles)
        if growing != ("unstable" in ended.err) and all(abs(re) > 1e-9 * math.hypot(re, im) for re, im, _ in poles):
            raise Fault("verdict", ended.out + ended.err)
    response = program.run("response", *case.problem(), *case.given())
    if response.done and any(not math.isfinite(float(x)) for row in Table.read(response.out).rows for x in row):
        raise Fault("finite", response.out)


def drawn_geometry(random: Random, lists: Lists) -> Case:
    scene, chosen = drawn_scene(random, lists, 0.2, having="constraint")
    return Case("metrics_are_symmetric", scene=scene, chosen=chosen)


@must_hold(drawn_geometry, 0.4)
def metrics_are_symmetric(program: Program, case: Case, lists: Lists) -> None:
    ended = program.run("geometry", *case.problem())
    if not ended.done:
        return
    rows = Table.read(ended.out).rows
    metric = {(row[1], row[2]): float(row[4]) for row in rows if row[0] == "metric"}
    if any(metric.get((j, i)) != value for (i, j), value in metric.items()):
        raise Fault("metric", f"{metric}")
    if any(not math.isfinite(float(row[4])) for row in rows):
        raise Fault("finite", next(",".join(row) for row in rows if not math.isfinite(float(row[4]))))


def drawn_name(random: Random, lists: Lists) -> Case:
    return Case("lists_are_told", scene=random.choice(list(lists.scenes)), scheme=random.choice(list(lists.schemes)))


@must_hold(drawn_name, 0.1)
def lists_are_told(program: Program, case: Case, lists: Lists) -> None:
    for words in (("scenes", case.scene), ("schemes", case.scheme), ("scenes", "--parameters"), ("schemes", "--needs"), ("scenes",), ("schemes",)):
        if not program.run(*words).done:
            raise Fault("list", " ".join(words))
