#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""agreement.py FDEBENCH RESULTS [SCENE...]: asks `choose` for each scene of a results file (by default the scenes of the
default sweep), six accuracies and two norms, and compares the answer with the cheapest run of the results. Prints CSV, a
line for each question, then how many answers agree: the same scheme, or a time that is not above the other's interval.
Also checks that each scheme that is called slower has a run outside the accuracy that takes longer than the answer."""

import csv
import json
import subprocess
import sys
import tempfile

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
    program, results, *scenes = sys.argv[1:]
    writer = csv.writer(sys.stdout)
    writer.writerow(["scene", "norm", "accuracy", "choose", "steps", "seconds", "sweep", "its steps", "its seconds", "ratio"])
    agree, asked, slower = 0, 0, 0
    part = tempfile.mktemp(suffix=".jsonl")
    rows = rows_by_scene(results)
    for scene in scenes or rows:
        with open(part, "w", encoding="utf-8") as file:
            file.writelines(rows[scene])
        for norm in ("maximum", "end"):
            for accuracy in ACCURACIES:
                question = (scene, "--error", accuracy, "--norm", norm)
                answer, swept = ask(program, *question), ask(program, *question, "--results", part)
                if answer is None:
                    writer.writerow([scene, norm, accuracy, "none"])
                    continue
                slower += len(unsupported(answer))
                asked += 1
                same = swept is None or answer["scheme"] in [swept["scheme"], *swept["same_as"]]
                agree += same or answer["seconds_low"] <= swept["seconds_high"]
                writer.writerow([scene, norm, accuracy, answer["scheme"], answer["steps"], f"{answer['seconds']:.3g}"] +
                                ([swept["scheme"], swept["steps"], f"{swept['seconds']:.3g}",
                                  f"{answer['seconds'] / swept['seconds']:.2f}"] if swept else ["none"]))
                sys.stdout.flush()
    print(f"{agree} of {asked} answers agree; {slower} schemes are called slower without a run that shows it")


if __name__ == "__main__":
    main()
