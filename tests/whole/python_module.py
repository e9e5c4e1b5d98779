# SPDX-License-Identifier: MIT
"""The Python module, if it is built, returns the values of the command."""

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


@must_hold(drawn_call, 0.3)
def python_agrees(program: Program, case: Case, lists: Lists) -> None:
    folder = program.binary.parent / "python"
    modules = list(folder.glob("fdebench/*.so"))
    if not modules:
        return
    ended = program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given(), "--points", "5")
    if not ended.done:
        return
    table = Table.read(ended.out)
    run = subprocess.run([sys.executable, "-c", SCRIPT, case.problem()[0], case.scheme, case.options["--steps"],
                          ",".join(row[0] for row in table.rows), *table.unknowns], capture_output=True, text=True,
                         cwd=program.folder, env={**program.environment, **sanitizers_of(modules[0]), "PYTHONPATH": str(folder)}, timeout=120 * program.slow)
    if "ModuleNotFoundError" in run.stderr:  # the module is compiled for another Python
        return
    if run.returncode != 0:
        raise Fault("fails", f"Python ends with {run.returncode}: {run.stderr.strip().splitlines()[-1:]}")
    columns = [table.names.index(name) for name in ["t", *table.unknowns]]
    for ours, row in zip(run.stdout.splitlines(), table.rows):
        if [float(v) for v in ours.split(",")] != [float(row[k]) for k in columns]:
            raise Fault("differs", f"Python says {ours}, the command {','.join(row)}")
