#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs public codes beside fdebench: peers.py list | check | run CODE --out FILE | try CODE SETTING SCENE STEPS.

codes.toml has the codes and problems.toml the problems; docs/peers.md explains both. FDEBENCH_PEERS names the folder with the codes.
"""

import argparse
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
STEPS = [2**k for k in range(4, 17)]


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
    """Doubles the steps of all settings of a code on each problem.

    A setting ends where its code refuses the problem or exceeds the budget, or where its error falls no longer. One that fails goes on:
    Newton's method may need small steps.
    """
    if arguments.code == "fdebench":
        run_fdebench(arguments)
        return
    code = CODES[arguments.code]
    if not is_found(code):
        sys.exit(f"peers.py: {code['name']}: FDEBENCH_PEERS must name a folder with {code['file']}")
    for problem in PROBLEMS:
        if arguments.scene not in (None, problem["scene"]):
            continue
        going = {line_name(code, setting): command(code, setting) for setting in code["settings"]}
        for steps in code.get("steps", STEPS):
            if not going:
                break
            externals = [word for name, text in going.items() for word in ("--external", f"{name}={text}")]
            subprocess.run([arguments.fdebench, "run", "--scene", problem["scene"], "--steps", str(steps), "--repeat", "1", *externals,
                            "--budget", str(arguments.budget), "--out", arguments.out, "--quiet"],
                           check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
            for name in (ended(arguments.out, steps) | settled(arguments.out)) & going.keys():
                del going[name]
    shorten(arguments.out)


def ended(file, steps):
    """The lines that more steps will not help, of the runs with this number of steps, the last in the file."""
    names = set()
    for line in reversed(pathlib.Path(file).read_text().splitlines()):
        row = json.loads(line)
        if row.get("steps") != steps:
            break
        if row["quantity"] == "ending" and row["ending"] in ("refused", "out_of_budget"):
            names.add(row["scheme"])
    return names


def settled(file):
    """The lines whose errors on the last scene of the file, below 1e-3, have not halved in the last two doublings."""
    rows = [row for row in map(json.loads, pathlib.Path(file).read_text().splitlines()) if "quantity" in row]
    errors = {}
    for row in rows:
        if row["scene"] == rows[-1]["scene"] and row["quantity"] == "error_end_relative":
            errors.setdefault(row["scheme"], []).append(row["value"])
    return {name for name, values in errors.items() if len(values) > 2 and values[-3] < 1e-3 and values[-1] > values[-3] / 2}


def attempt(arguments):
    """Runs one code on one scene and prints how it ends, its errors and its times."""
    code = CODES[arguments.code]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([arguments.fdebench, "run", "--scene", arguments.scene, "--steps", str(arguments.steps), "--repeat", "1", "--external",
                        f"{code['name']}={command(code, arguments.setting)}", "--out", f"{folder}/results.jsonl", "--quiet"],
                       check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
        rows = [row for row in map(json.loads, pathlib.Path(folder, "results.jsonl").read_text().splitlines()) if "quantity" in row]
    for row in rows:
        if row["quantity"] in ("error_end", "error_end_relative", "error_maximum", "time_start", "time_setup", "time_median"):
            print(f"{row['quantity']} {row['value']:.3g}")
        if row["quantity"] == "ending":
            print(f"ending {row['ending']} {row.get('detail', '')}".rstrip())


def shorten(file):
    """Keeps one session, whose parts differ in their date only, and the rows that tables and the page's section need."""
    kept, first = [], None
    for line in pathlib.Path(file).read_text().splitlines(keepends=True):
        row = json.loads(line)
        if (session := row.get("session")) is not None:
            session = {name: value for name, value in session.items() if name != "date"}
            if session == first:
                continue
            first = session
        if row.get("quantity", "ending").startswith(("ending", "error_", "time_")) or row.get("last"):
            kept.append(line)
    pathlib.Path(file).write_text("".join(kept))


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
    runs.set_defaults(do=run)
    arguments = parser.parse_args()
    arguments.do(arguments)


if __name__ == "__main__":
    main()
