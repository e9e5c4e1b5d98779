#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The completion script of bash completes command lines; those of zsh and fish are read without a mistake where these shells are."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()

# A line of the command, up to the cursor, and what bash puts in place of its last word. ":" and "=" begin a new word.
COMPLETED = [
    ("fdebench sol", {"solve"}),
    ("fdebench -q scen", {"scenes"}),
    ("fdebench choose pendulum --error 1e-3 --norm ", {"end", "maximum"}),
    ("fdebench solve pendulum --scheme spec", {"spectral_collocation"}),
    ("fdebench solve pendulum --set al", {"alpha="}),
    ("fdebench solve pendulum:alpha=1.9,be", {"1.9,beta="}),
    ("fdebench solve mi", {"mine", "missing.toml"}),
    ("fdebench solve pendulum --grid graded:a", {"auto"}),
    ("fdebench report r", {"results.jsonl"}),
    ("fdebench report results.jsonl --out pa", {"page"}),
    ("fdebench help grid", {"grids"}),
]


def completed(line, script, folder):
    asked = f"source {script}; COMP_LINE={line!r}; COMP_POINT={len(line)}; _fdebench; printf '%s\\n' \"${{COMPREPLY[@]}}\""
    environment = {"PATH": f"{PROGRAM.parent}:{os.environ['PATH']}", "FDEBENCH_SCENES": f"{folder}/scenes", "HOME": folder}
    ended = subprocess.run(["bash", "--norc", "-c", asked], cwd=folder, env=environment, capture_output=True, text=True, check=True)
    return set(ended.stdout.split())


def main():
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        for name in ("scenes/mine.toml", "missing.toml", "results.jsonl", "rest.txt"):
            Path(folder, name).parent.mkdir(exist_ok=True)
            Path(folder, name).write_text("")
        Path(folder, "page").mkdir()
        scripts = {}
        for shell in ("bash", "zsh", "fish"):
            scripts[shell] = Path(folder, shell + ".script")
            scripts[shell].write_bytes(subprocess.run([PROGRAM, "completion", shell], capture_output=True, check=True).stdout)
        for line, wanted in COMPLETED:
            found = completed(line, scripts["bash"], folder)
            if found != wanted:
                faults.append(f"{line!r}: completed with {sorted(found)}, not {sorted(wanted)}")
        for shell, check in (("zsh", "-n"), ("fish", "--no-execute")):
            if shutil.which(shell):
                ended = subprocess.run([shell, check, scripts[shell]], capture_output=True, text=True, check=False)
                if ended.returncode != 0 or ended.stderr:
                    faults.append(f"{shell}: {ended.stderr}")
    print("\n".join(faults))
    sys.exit(bool(faults))


main()
