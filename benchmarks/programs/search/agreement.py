#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""agreement.py FDEBENCH RESULTS [--sample N] [SCENE...]: asks `choose` for each scene of a results file, or for these, six
accuracies and two norms, or N of these questions at random, the same for the same N, and compares the answer with the
cheapest run of the results. Prints CSV, a line for each question, then how many answers agree: the same scheme, or a time that is not above the other's interval.
Also checks that each scheme that is called slower has a run outside the accuracy that takes longer than the answer."""

import csv
import json
import subprocess
import sys
import tempfile
from itertools import product
from random import Random

ACCURACIES = ["1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12"]


def ask(program, scene, *options):
    done = subprocess.run([program, "choose", scene, "--json", *options], capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.returncode == 0 else None


def rows_by_scene(results):
    """The lines of each scene by its label, with the sessions."""
    sessions, rows = [], {}
    with open(results, encoding="utf-8") as lines:
        for line in lines:
            row = json.loads(line)
            if "session" in row:
                sessions.append(line)
            if "scheme" not in row or "checksum" in row:
                continue
            settings = ",".join(f"{name}={value}" for name, value in row.get("settings", {}).items())
            rows.setdefault(row["scene"] + (":" + settings if settings else ""), sessions[-1:]).append(line)
    return rows


def unsupported(answer):
    return [other["scheme"] for other in answer["others"] if other["outcome"].startswith("slower") and
            not (other["seconds"] and other["seconds"] > answer["seconds"] * 0.99)]


def main():
    program, results, *rest = sys.argv[1:]
    sample = int(rest[1]) if rest[:1] == ["--sample"] else 0
    scenes, rows = rest[2:] if sample else rest, rows_by_scene(results)
    questions = list(product(scenes or rows, ("maximum", "end"), ACCURACIES))
    if sample:
        questions = Random(sample).sample(questions, sample)
    writer = csv.writer(sys.stdout)
    writer.writerow(["scene", "norm", "accuracy", "choose", "steps", "seconds", "sweep", "its steps", "its seconds", "ratio"])
    agree, slower, neither = 0, 0, 0
    part = tempfile.mktemp(suffix=".jsonl")
    for scene, norm, accuracy in questions:
        with open(part, "w", encoding="utf-8") as file:
            file.writelines(rows[scene])
        question = (scene, "--error", accuracy, "--norm", norm)
        answer, swept = ask(program, *question), ask(program, *question, "--results", part)
        if answer is None:
            writer.writerow([scene, norm, accuracy, "none", "", "", swept["scheme"] if swept else "none"])
            neither += swept is None
            continue
        slower += len(unsupported(answer))
        same = swept is None or answer["scheme"] in [swept["scheme"], *swept["same_as"]]
        agree += same or answer["seconds_low"] <= swept["seconds_high"]
        writer.writerow([scene, norm, accuracy, answer["scheme"], answer["steps"], f"{answer['seconds']:.3g}"] +
                        ([swept["scheme"], swept["steps"], f"{swept['seconds']:.3g}",
                          f"{answer['seconds'] / swept['seconds']:.2f}"] if swept else ["none"]))
        sys.stdout.flush()
    print(f"{agree + neither} of {len(questions)} answers agree, {neither} of them that there is none; "
          f"{slower} schemes are called slower without a run that shows it")


if __name__ == "__main__":
    main()
