#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the times of codes and of fdebench on the same scenes as tables of Markdown: table.py [nearest] RESULTS...

A cell is the time of a later solve of a code's quickest run within an error at the end, relative to the solution, and how many times
that of fdebench it is; without such a run the smallest error; a code that solves nothing has its reason. With `nearest` one table, of the time of fdebench and of the quickest other code.
"""

import math
import sys

from peers import ACCURACIES, ERROR, code_of, runs_in, undisturbed


def time_text(seconds):
    unit, size = next((pair for pair in (("s", 1), ("ms", 1e-3)) if seconds >= pair[1]), ("µs", 1e-6))
    return f"{seconds / size:.3g} {unit}"


def read_codes(files):
    """By scene and code: the (error, seconds) of its runs, and how the first run without a solution ended."""
    scenes = {}
    for run in undisturbed([run for file in files for run in runs_in(file)]):
        scene = run["scene"] + "".join(f" {name}={value}" for name, value in sorted(run["settings"].items()))
        of = scenes.setdefault(scene, {}).setdefault(code_of(run), {"runs": [], "reason": ""})
        if ERROR in run["values"] and run["ending"] == "finished":
            of["runs"].append((run["values"][ERROR], run["time"].get("time_median", math.inf)))
        else:
            of["reason"] = of["reason"] or f"{run['ending'].replace('_', ' ')}: {run.get('detail', '')}"
    return scenes


def least_time(runs, accuracy):
    return min((seconds for error, seconds in runs if error <= accuracy), default=math.inf)


def cell(runs, ours, accuracy):
    least, of_ours = least_time(runs, accuracy), least_time(ours, accuracy)
    if least == math.inf:
        return f"({min(error for error, _ in runs):.1e})"
    return time_text(least) + (f" × {least / of_ours:,.0f}".replace(",", "\u202f") if of_ours < math.inf else "")


def print_scene(scene, codes):
    heads = [f"{accuracy:.0e}".replace("e-0", "e-") for accuracy in ACCURACIES]
    print(f"\n**{scene}**\n\n| code | {' | '.join(heads)} |\n|---|{'---|' * len(heads)}")
    ours = codes.get("fdebench", {"runs": []})["runs"]
    for code, of in sorted(codes.items(), key=lambda item: item[0] != "fdebench"):
        cells = [cell(of["runs"], ours if code != "fdebench" else [], accuracy) for accuracy in ACCURACIES] if of["runs"] else [of["reason"], *[""] * (len(heads) - 1)]
        print(f"| {code} | {' | '.join(cells)} |")


def print_nearest(scenes):
    shown = [ACCURACIES[i] for i in (1, 3, 5)]
    print(f"| problem | {' | '.join(f'{accuracy:.0e}'.replace('e-0', 'e-') for accuracy in shown)} |\n|---|{'---|' * len(shown)}")
    for scene, codes in scenes.items():
        ours = codes["fdebench"]["runs"]
        cells = []
        for accuracy in shown:
            others = [(least_time(of["runs"], accuracy), code) for code, of in codes.items() if code != "fdebench"]
            best = min(others, default=(math.inf, ""))
            other = f"{best[1]} {cell(codes[best[1]]['runs'], ours, accuracy)}" if best[0] < math.inf else "no other"
            cells.append(f"{cell(ours, [], accuracy)}; {other}")
        print(f"| {scene} | {' | '.join(cells)} |")


def main(words):
    scenes = read_codes([word for word in words if word != "nearest"])
    if "nearest" in words:
        print_nearest(scenes)
        return
    for scene, codes in scenes.items():
        print_scene(scene, codes)


if __name__ == "__main__":
    main(sys.argv[1:])
