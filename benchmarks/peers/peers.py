#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs public codes beside fdebench: peers.py list | check | run CODE --out FILE | try CODE SETTING SCENE STEPS.

codes.toml has the codes and problems.toml the problems; docs/peers.md explains both. FDEBENCH_PEERS names the folder with the codes.
"""

import argparse
import itertools
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE.parent / "programs" / "records"))
from recorded_runs import runs_in  # noqa: E402

STEPS = [2**k for k in range(4, 17)]
ERROR = "error_end_relative"
ACCURACIES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)  # the errors of the tables
LARGEST_LOAD = 0.3  # tasks that may run on the machine, on average in the last minute, before times are measured


def read(name):
    return tomllib.loads((HERE / name).read_text())


CODES = {code["name"]: code for code in read("codes.toml")["code"]}
PROBLEMS = read("problems.toml")["problem"]


def interpreter(language, folder):
    """The words that start the adapter of this language; the name of the code and its settings follow."""
    python = f"env PYTHONPATH={folder / 'pycaputo-shims'}:{folder / 'pycaputo'} /usr/bin/python3"
    return {"octave": f"octave-cli --norc --quiet --no-history {HERE / 'octave' / 'peer.m'}",
            "python": f"{python} {HERE / 'python' / 'peer.py'}",
            "julia": f"julia --project={folder / 'julia'} {HERE / 'julia' / 'peer.jl'}",
            "rust": str(folder / "numra" / "peer")}[language]


def folder_of_codes():
    return pathlib.Path(os.environ.get("FDEBENCH_PEERS", ""))


def is_found(code):
    return "FDEBENCH_PEERS" in os.environ and (folder_of_codes() / code["file"]).exists()


def command(code, setting):
    """The shell command of one setting. Each family of codes is one adapter, which for pycaputo begins with the stepper."""
    name = [] if code["language"] in ("python", "rust") else [code["name"]]
    return f"{interpreter(code['language'], folder_of_codes())} {shlex.join([*name, *setting.split()])}".rstrip()


def line_name(code, setting):
    return f"{code['name']} {setting}".replace("=", " ").strip()


# Those that are the quickest somewhere in the default sweep over the problems; the file of all schemes is 11 MB.
OUR_SCHEMES = ("spectral_collocation", "radau_exponentials", "grunwald_letnikov", "product_trapezoidal", "fractional_trapezoidal",
               "newton_gregory_2", "newton_gregory_3", "bdf4", "bdf5", "bdf6")  # fmt: skip


def run_fdebench(arguments):
    """The default sweep over the problems, and the spectral scheme to tolerances that the sweep does not need."""
    ours = [word for scheme in OUR_SCHEMES for word in ("--scheme", scheme)]
    scenes = [word for problem in PROBLEMS for word in ("--scene", problem["scene"])]
    for words in (ours, ["--scheme", "spectral_collocation", "--accuracy", "1e-9,1e-10,1e-11,1e-12,1e-13,1e-14", "--budget", "1.5"]):
        subprocess.run([arguments.fdebench, "run", *scenes, *words, "--out", arguments.out, "--quiet"], check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
    shorten(arguments.out)


def run(arguments):
    """Doubles the steps of all settings of a code on each problem, then tries some numbers of steps between those.

    A setting ends where its code refuses the problem or exceeds the budget, or where its error falls no longer. One that fails goes on:
    Newton's method may need small steps.
    """
    load = os.getloadavg()[0]
    if load > LARGEST_LOAD and not arguments.busy:
        print(f"peers.py: the load of the machine is {load:.2f}, and at most {LARGEST_LOAD} is allowed; --busy runs all the same", file=sys.stderr)
        sys.exit(2)
    if arguments.code == "fdebench":
        run_fdebench(arguments)
        return
    code = CODES[arguments.code]
    if not is_found(code):
        sys.exit(f"peers.py: {code['name']}: FDEBENCH_PEERS must name a folder with {code['file']}")
    commands = {line_name(code, setting): command(code, setting) for setting in code["settings"]}
    for scene in [arguments.scene] if arguments.scene else [problem["scene"] for problem in PROBLEMS]:
        going = set(commands)
        for steps in code.get("steps", STEPS):
            if going:
                measure(arguments, scene, {name: commands[name] for name in commands if name in going}, [steps])
                going -= ended(arguments.out, steps) | settled(arguments.out)
        for name, steps in between(arguments.out).items():
            measure(arguments, scene, {name: commands[name]}, sorted(steps))
    shorten(arguments.out)


def measure(arguments, scene, commands, steps):
    """Adds the runs of these lines to the results file."""
    externals = [word for name, text in commands.items() for word in ("--external", f"{name}={text}")]
    subprocess.run([arguments.fdebench, "run", "--scene", scene, "--steps", ",".join(map(str, steps)), "--repeat", "1", *externals,
                    "--budget", str(arguments.budget), "--out", arguments.out, "--quiet"],
                   check=True, cwd=ROOT, stdout=subprocess.DEVNULL)  # fmt: skip


def ended(file, steps):
    """The lines that more steps will not help, of the runs with this number of steps, the last in the file."""
    runs = itertools.takewhile(lambda run: run["steps"] == steps, reversed(runs_in(file)))
    return {run["scheme"] for run in runs if run["ending"] in ("refused", "out_of_budget")}


def solved_lines(file):
    """The finished runs on the last scene of the file, by line."""
    runs, lines = runs_in(file), {}
    for run in runs:
        if run["scene"] == runs[-1]["scene"] and run["ending"] == "finished" and ERROR in run["values"]:
            lines.setdefault(run["scheme"], []).append(run)
    return lines


def settled(file):
    """The lines whose errors, below 1e-3, have not halved in the last two doublings."""
    errors = {name: [run["values"][ERROR] for run in runs] for name, runs in solved_lines(file).items()}
    return {name for name, values in errors.items() if len(values) > 2 and values[-3] < 1e-3 and values[-1] > values[-3] / 2}


def between(file):
    """By line: three numbers of steps before those of the quickest run within each error, so that no more than 19 % of its steps are too many."""
    lines, steps = solved_lines(file), {}
    for accuracy in ACCURACIES:
        within = [run for runs in lines.values() for run in runs if run["values"][ERROR] <= accuracy and "time_median" in run["time"]]
        if within:
            best = min(within, key=lambda run: run["time"]["time_median"])
            before = max((run["steps"] for run in lines[best["scheme"]] if run["steps"] < best["steps"]), default=best["steps"])
            steps.setdefault(best["scheme"], set()).update(round(before * (best["steps"] / before) ** (k / 4)) for k in (1, 2, 3))
    return steps


def attempt(arguments):
    """Runs one code on one scene and prints how it ends, its errors and its times."""
    code = CODES[arguments.code]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([arguments.fdebench, "run", "--scene", arguments.scene, "--steps", str(arguments.steps), "--repeat", "1", "--external",
                        f"{code['name']}={command(code, arguments.setting)}", "--out", f"{folder}/results.jsonl", "--quiet"],
                       check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
        (ran,) = runs_in(pathlib.Path(folder, "results.jsonl"))
    measured = {**ran["values"], **ran["time"]}
    for name in ("error_end", ERROR, "error_maximum", "time_start", "time_setup", "time_median"):
        if name in measured:
            print(f"{name} {measured[name]:.3g}")
    print(f"ending {ran['ending']} {ran.get('detail', '')}".rstrip())


def code_of(run):
    return run.get("program", {}).get("code", run["scheme"]) if "external" in run else "fdebench"


def undisturbed(runs):
    """Without the runs that other work on the machine made longer (docs/results.md), where there is another of the same kind."""

    def kind(run):
        return json.dumps([run.get(name) for name in ("scene", "settings", "scheme", "steps", "accuracy", "grid")])

    calm = {kind(run) for run in runs if not run["time"].get("disturbed")}
    return [run for run in runs if not run["time"].get("disturbed") or kind(run) not in calm]


def needed(runs):
    """Of each code on each problem: the runs with a kind of error that no quicker run is below; without any, the first run."""
    kept, groups = [], {}
    for run in runs:
        groups.setdefault((run["scene"], json.dumps(run["settings"]), code_of(run)), []).append(run)
    for group in groups.values():
        solved = sorted((run for run in group if run["ending"] == "finished" and run["values"]), key=lambda run: run["time"].get("time_median", math.inf))
        least = {}
        for run in solved:
            lower = {name: error for name, error in run["values"].items() if error < least.get(name, math.inf)}
            least.update(lower)
            if lower:
                kept.append(run)
        kept += group[:1] if not solved else []
    return kept


def shorten(file):
    """Keeps the first session, from which others differ in their date only, and what the tables and the page's section need: some runs, their errors and
    times, and the scenes of fdebench."""
    lines, runs = list(map(json.loads, pathlib.Path(file).read_text().splitlines())), undisturbed(runs_in(file))
    kept = lines[:1] + [line for line in lines if isinstance(line.get("scene"), dict) and any("external" not in run for run in runs)]
    for run in runs:
        run["values"] = {name: value for name, value in run["values"].items() if re.match("error_(end|maximum)", name)}
        run["time"] = {name: value for name, value in run["time"].items() if name.startswith("time_") or (name, value) == ("disturbed", 1)}
        if not run.get("columns", {}).get("part"):
            run.pop("columns", None)
        run.pop("courses", None)
    kept += ({name: value for name, value in run.items() if value != {}} for run in needed(runs))
    pathlib.Path(file).write_text("".join(json.dumps(line, ensure_ascii=False, separators=(",", ":"), sort_keys=True) + "\n" for line in kept))


def check(_):
    for code in CODES.values():
        print(f"{code['name']:20} {'found' if is_found(code) else 'not found: ' + code['get']}")


def show(_):
    for code in CODES.values():
        print(f"{code['name']}: {code['title']}. {code['authors']}; {code['get']}. Licence: {code['licence']}. Takes {code['takes']}.")
        for setting in code["settings"]:
            print(f"  {line_name(code, setting)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(required=True)
    commands.add_parser("list").set_defaults(do=show)
    commands.add_parser("check").set_defaults(do=check)
    tries = commands.add_parser("try")
    runs = commands.add_parser("run")
    for of in (tries, runs):
        of.add_argument("code", choices=[*CODES, "fdebench"] if of is runs else CODES)
        of.add_argument("--fdebench", default=str(ROOT / "build/release/fdebench"))
    tries.add_argument("setting")
    tries.add_argument("scene")
    tries.add_argument("steps", type=int)
    tries.set_defaults(do=attempt)
    runs.add_argument("--out", required=True)
    runs.add_argument("--budget", type=float, default=10.0, help="seconds for a process")
    runs.add_argument("--scene", help="this problem only")
    runs.add_argument("--busy", action="store_true", help="also while other programs run")
    runs.set_defaults(do=run)
    arguments = parser.parse_args()
    arguments.do(arguments)


if __name__ == "__main__":
    main()
