# SPDX-License-Identifier: MIT
"""The events of a function of t alone are all its zeros."""

import math
from random import Random

from case import Case
from drawn_files import drawn_file
from drawn_formulas import frequency
from drawn_numbers import typed
from drawn_scenes import Lists
from drawn_solves import accuracy
from errors import end_of
from program import Fault, Program
from properties import must_hold
from table import Table


def drawn_events(random: Random, lists: Lists) -> Case:
    scheme, rate = random.choice(lists.takers("takes_accuracy")), frequency(random)
    zero = random.choice([f"sin({rate}*t)", f"cos({rate}*t)", f"(2 + tanh(x))*sin({rate}*t)"])
    file = (*drawn_file(random, 1, events=False), "[event.turn]", f'zero = "{zero}"')
    return Case("all_zeros_are_events", scheme=scheme, file=file, words=(rate, "0.5" if "cos" in zero else "0"), options={"--accuracy": accuracy(random, 1e-7), "--budget": "6"})


@must_hold(drawn_events, 2)
def all_zeros_are_events(program: Program, case: Case, lists: Lists) -> None:
    ended = program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given(), "--events")
    if not ended.done or not any(line.startswith("[event.turn]") for line in case.file):
        return
    zero = case.file[-1]
    function = next((name for name in ("sin", "cos") if name in zero), "")
    rate = float(zero.split(function + "(")[1].split("*")[0]) if function and "*t)" in zero else 0.0
    if rate <= 0:
        return
    end, half = end_of(case, lists), math.pi / rate
    wanted = [half * (k + (0.5 if function == "cos" else 1)) for k in range(int(end / half) + 1)]
    wanted = [t for t in wanted if t < end * (1 - 1e-9)]
    table = Table.read(ended.out)
    found = table.times if table.rows else []
    missing = [t for t in wanted if not any(abs(t - other) <= 1e-9 * end for other in found)]
    if missing:
        raise Fault("missing", f"{case.scheme} finds {len(wanted) - len(missing)} of {len(wanted)} zeros of {function}({rate:g} t) in [0, {end:g}]; the first that is missing is at {missing[0]:.6g}")
    if any(all(abs(t - other) > 1e-9 * end for other in [*wanted, end]) for t in found):
        raise Fault("false", "an event where the function has no zero")
