#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the command, Python, C and a study file say of the same mistakes: the table of docs/messages.md.

    messages.py FDEBENCH LIBRARY            compare; the lines that differ, exit code 1 if there is one
    messages.py FDEBENCH LIBRARY --write    write the page
"""

import ctypes
import difflib
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import fdebench

PAGE = Path(__file__).resolve().parents[2] / "docs/messages.md"
HEAD = """# Messages

What each way to call fdebench says of the same mistake, with its own word for the argument: an option of the command, an argument
in Python, an option in C, and in a study file a key with file, line and column. A dash: there is no such argument; a study may
have steps and accuracies, each for the schemes that take them, or neither, and searches then.
`tests/fronts/messages.py` makes the calls and writes this table. The command puts `fdebench: ` in front; Python raises `ValueError`
or `TypeError`; in C it is what `fdebench_last_error()` returns.

| mistake | command | Python | C | study file |
|---|---|---|---|---|
"""

# Calls that are right.
SOLVE = {"scene": "pendulum", "scheme": "l1", "steps": 64}
CHOOSE = {"scene": "relaxation", "error": 1e-3}
EXACT = {"scene": "pendulum", "times": 1.0}
FUNCTION = {"alpha": 0.5, "beta": 1.0, "z": 1.0}

# What is wrong, with a call, and what is wrong in it: arguments in place of others, None for one that is left out.
MISTAKES = [
    ("no such scene", SOLVE, {"scene": "pendulun"}),
    ("no such parameter", SOLVE, {"scene": "pendulum:alfa=1.5"}),
    ("a parameter outside its range", SOLVE, {"scene": "pendulum:alpha=9"}),
    ("an end at 0", SOLVE, {"scene": "pendulum:until=0"}),
    ("no such scheme", SOLVE, {"scheme": "bdf9"}),
    ("no steps", SOLVE, {"steps": 0}),
    ("steps that are no number", SOLVE, {"steps": "ten"}),
    ("half a step", SOLVE, {"steps": 0.5}),
    ("more steps than are allowed", SOLVE, {"steps": 2_000_000_000}),
    ("neither steps nor accuracy", SOLVE, {"steps": None}),
    ("both", SOLVE, {"accuracy": 1e-6}),
    ("accuracy for a scheme over a grid", SOLVE, {"steps": None, "accuracy": 1e-6}),
    ("an accuracy of 0", SOLVE, {"scheme": "spectral_collocation", "steps": None, "accuracy": 0.0}),
    ("a grading below 1", SOLVE, {"grid": "graded:0.5"}),
    ("no such history", SOLVE, {"history": "fast"}),
    ("a tolerance of 2", SOLVE, {"tolerance": 2.0}),
    ("a negative budget", SOLVE, {"budget": -1.0}),
    ("a time beyond the end", SOLVE, {"at": 30.0}),
    ("each 0th time", SOLVE, {"every": 0}),
    ("one point", SOLVE, {"points": 1}),
    ("two ways to name times", SOLVE, {"at": 10.0, "points": 3}),
    ("an error of 0", CHOOSE, {"error": 0.0}),
    ("no such norm", CHOOSE, {"norm": "mean"}),
    ("no such scale", CHOOSE, {"scale": "log"}),
    ("no such column", CHOOSE, {"columns": "z"}),
    ("a search of 0 seconds", CHOOSE, {"seconds": 0.0}),
    ("a time before 0", EXACT, {"times": -1.0}),
    ("an order outside its range", FUNCTION, {"alpha": 6.0}),
]


def of_program(*words):
    """The message with which the program fails; "accepted" where it does not."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)
    return done.stderr.strip().removeprefix("fdebench: ") if done.returncode else "accepted"


def of_command(call, given):
    if call is FUNCTION:
        return of_program("mittag-leffler", *(f"{value:g}" for value in given.values()))
    name = "solve" if call is SOLVE else "choose" if call is CHOOSE else "exact"
    options = {"seconds": "max-time", "times": "at"}
    return of_program(name, given.pop("scene"), *(f"--{options.get(key, key)}={value}" for key, value in given.items()))


def of_python(call, given):
    function = (
        fdebench.solve if call is SOLVE else fdebench.choose if call is CHOOSE else fdebench.exact if call is EXACT else fdebench.mittag_leffler
    )
    try:
        function(**given)
    except (TypeError, ValueError) as error:
        return str(error)
    return "accepted"


def set_option(options, name, value):
    """The status."""
    name = {"seconds": "max-time"}.get(name, name).encode()
    if isinstance(value, str):
        return C.fdebench_options_set_text(options, name, value.encode())
    if isinstance(value, int):
        return C.fdebench_options_set_integer(options, name, ctypes.c_longlong(value))
    return C.fdebench_options_set_real(options, name, ctypes.c_double(value))


def status_of(call, given):
    """Of the first call in C that fails, otherwise 0."""
    problem, options, result = ctypes.c_void_p(), ctypes.c_void_p(), ctypes.c_void_p()
    if call is FUNCTION:
        numbers = [ctypes.c_double(value) for value in (*given.values(), 0.0)]
        return C.fdebench_mittag_leffler(*numbers, (ctypes.c_double * 2)(), ctypes.byref(ctypes.c_double()))
    status = C.fdebench_problem_of_scene(given.pop("scene").encode(), ctypes.byref(problem))
    if status == 0 and call is EXACT:
        return C.fdebench_exact(problem, ctypes.c_size_t(1), ctypes.byref(ctypes.c_double(given["times"])), ctypes.byref(result))
    scheme = given.pop("scheme", "").encode()
    status = status or C.fdebench_options_new(ctypes.byref(options))
    for name, value in given.items():
        status = status or set_option(options, name, value)
    if call is CHOOSE:
        return status or C.fdebench_choose(problem, options, ctypes.byref(result))
    return status or C.fdebench_solve(problem, scheme, options, ctypes.byref(result))


def of_c(call, given):
    return C.fdebench_last_error().decode() if status_of(call, given) else "accepted"


def of_study(call, given):
    keys = {"scheme": "schemes", "accuracy": "accuracies"} | {key: key for key in ("steps", "grid", "history", "tolerance", "budget")}
    scene, _, setting = given.pop("scene", "").partition(":")
    if call is not SOLVE or not given.keys() <= keys.keys():
        return "-"
    parameter, _, value = setting.partition("=")
    lines = [f"{keys[key]} = {json.dumps(argument)}" for key, argument in given.items()] + ["[[family]]", f'scene = "{scene}"']
    if setting:
        lines.append(f"until = {value}" if parameter == "until" else f"parameters = {{{setting}}}")
    Path("study.toml").write_text("\n".join(lines) + "\n")
    return of_program("study", "plan", "study.toml")


def row(mistake, call, wrong):
    given = {key: value for key, value in (call | wrong).items() if value is not None}
    cells = [front(call, dict(given)) for front in (of_command, of_python, of_c, of_study)]
    shown = [cell if cell in ("-", "accepted") else f"`{cell}`".replace("|", "\\|") for cell in cells]
    return f"| {mistake} | {' | '.join(shown)} |\n"


PROGRAM = str(Path(sys.argv[1]).resolve())
C = ctypes.CDLL(str(Path(sys.argv[2]).resolve()))
C.fdebench_last_error.restype = ctypes.c_char_p
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    page = HEAD + "".join(row(*mistake) for mistake in MISTAKES)
if "--write" in sys.argv:
    PAGE.write_text(page)
    sys.exit()
found = list(difflib.unified_diff(PAGE.read_text().splitlines(), page.splitlines(), "docs/messages.md", "what is said", n=0, lineterm=""))
print(*(found or ["each front says what docs/messages.md shows"]), sep="\n")
sys.exit(bool(found))
