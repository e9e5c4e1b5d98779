# SPDX-License-Identifier: MIT
"""The Python module, if it is built, returns the values of the command, and tries schemes of one's own on any problem."""

import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from random import Random

from case import Case
from drawn_scenes import Lists
from drawn_solves import drawn_problem
from program import Fault, Program
from properties import must_hold
from table import Table

SCRIPT = """
import sys, fdebench
solution = fdebench.solve(sys.argv[1], sys.argv[2], int(sys.argv[3]), at=[float(t) for t in sys.argv[4].split(",")])
names = sys.argv[5:]
for k, t in enumerate(solution.times):
    print(",".join("%.17g" % v for v in [t, *(solution[n][k] for n in names)]))
"""


def drawn_call(random: Random, lists: Lists) -> Case:
    scheme = random.choice([name for name, one in lists.schemes.items() if one["takes_grid"]])
    case = Case("python_agrees", scheme=scheme, options={"--steps": str(random.randint(1, 3000))}, **drawn_problem(random, lists, wild=0.1))
    return replace(case, chosen={k: v for k, v in case.chosen.items() if "," not in v})


def sanitizers_of(module: Path) -> dict[str, str]:
    """The environment that lets Python, compiled without sanitizers, load a module compiled with them."""
    libraries = subprocess.run(["ldd", module], capture_output=True, text=True, check=True).stdout
    sanitizers = re.findall(r"=> (\S*lib[at]san\S*)", libraries)
    return {"LD_PRELOAD": " ".join(sanitizers), "ASAN_OPTIONS": "detect_leaks=0"} if sanitizers else {}


def python(program: Program, script: str, *words: str) -> subprocess.CompletedProcess[str] | None:
    """A script with the module that is built beside the program; None where there is none for this Python."""
    folder = program.binary.parent / "python"
    modules = list(folder.glob("fdebench/*.so"))
    if not modules:
        return None
    environment = {**program.environment, **sanitizers_of(modules[0]), "PYTHONPATH": str(folder)}
    run = subprocess.run([sys.executable, "-c", script, *words], capture_output=True, text=True, cwd=program.folder, env=environment,
                         timeout=120 * program.slow)
    if "ModuleNotFoundError" in run.stderr:  # the module is compiled for another Python
        return None
    if run.returncode != 0:
        raise Fault("fails", f"Python ends with {run.returncode}: {run.stderr.strip().splitlines()[-1:]}")
    return run


@must_hold(drawn_call, 0.3)
def python_agrees(program: Program, case: Case, lists: Lists) -> None:
    ended = program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given(), "--points", "5")
    if not ended.done:
        return
    table = Table.read(ended.out)
    run = python(program, SCRIPT, case.problem()[0], case.scheme, case.options["--steps"], ",".join(row[0] for row in table.rows), *table.unknowns)
    if run is None:
        return
    columns = [table.names.index(name) for name in ["t", *table.unknowns]]
    for ours, row in zip(run.stdout.splitlines(), table.rows):
        if [float(v) for v in ours.split(",")] != [float(row[k]) for k in columns]:
            raise Fault("differs", f"Python says {ours}, the command {','.join(row)}")


# The explicit rule of rectangles, which is a scheme for every problem without rows of order 0, and one that solves nothing.
OWN = """
import math, sys, fdebench, numpy
def rule(problem, times):
    orders = numpy.array(problem.orders)
    y, f = (numpy.zeros((len(times), len(orders))) for _ in range(2))
    taylor = numpy.array([[*initial, 0.0][:2] for initial in problem.initial])
    for n, t in enumerate(times):
        weights = (t - times[:n, None]) ** orders - (t - times[1 : n + 1, None]) ** orders if n else f[:0]
        y[n] = taylor[:, 0] + taylor[:, 1] * t + (weights * f[:n]).sum(axis=0) / numpy.array([math.gamma(order + 1) for order in orders])
        f[n] = problem.rhs(t, y[n])
    return y
own = {"mine": rule, "none": lambda problem, times: numpy.full((len(times), len(problem.orders)), numpy.nan)}
numpy.seterr(all="ignore")
error = float(sys.argv[2])
def size(times, values, reference):
    assert values.shape == reference.shape and len(values) == len(times)
    return float(abs(values).max())
try:
    answer = fdebench.choose(sys.argv[1], error=error, norm=sys.argv[3], scale=sys.argv[4], runs=sys.argv[5], seconds=2, schemes=own,
                             measures={"size": size})
except (ValueError, fdebench.NumericalFailure):
    sys.exit()
assert answer["error"] <= error, answer
assert answer["scheme"] != "none", answer
assert (answer["command"] is None) == (answer["scheme"] == "mine"), answer
assert answer["measures"]["size"] >= 0.0, answer
names = {answer["scheme"]: own.get(answer["scheme"]), "mine": rule, "none": own["none"]}
file = sys.argv[6]
for _ in range(2):
    runs = fdebench.sweep([sys.argv[1]], schemes=names, steps=[3, 8], accuracies=[1e-2], repeat=1, measures={"size": size}, results=file)
    assert {run["scheme"] for run in runs} == set(names), runs
    assert all(run["ending"] != "finished" or run["values"]["size"] >= 0.0 for run in runs), runs
    assert all(run["ending"] != "finished" for run in runs if run["scheme"] == "none"), runs
"""


def drawn_choice(random: Random, lists: Lists) -> Case:
    options = {"--error": random.choice(["1e-1", "1e-2", "1e-4", "1e-7"]), "--norm": random.choice(["end", "maximum"]),
               "--scale": random.choice(["absolute", "relative", "mixed", "peak"]), "--runs": random.choice(["1", "many"])}
    case = Case("python_schemes", options=options, **drawn_problem(random, lists, wild=0.1))
    return replace(case, chosen={k: v for k, v in case.chosen.items() if "," not in v})


@must_hold(drawn_choice, 0.2)
def python_schemes(program: Program, case: Case, lists: Lists) -> None:
    options = (case.options[name] for name in ("--error", "--norm", "--scale", "--runs"))
    if python(program, OWN, case.problem()[0], *options, "own.jsonl") and (program.folder / "own.jsonl").exists():
        page = program.run("report", "own.jsonl", "--out", "own")
        if not page.done:
            raise Fault("differs", f"no page of a file with runs of one's own: {page.err}")
