# SPDX-License-Identifier: MIT
"""Reads the runs of a results file (docs/results.md)."""

import json
from pathlib import Path

KEY = ("scene", "checksum", "settings", "scheme", "external", "steps", "accuracy", "grid", "history", "tolerance", "budget")


def key_of(line):
    """What identifies the run of a line; with an accuracy the steps do not."""
    return json.dumps({name: line[name] for name in KEY if name in line and not (name == "steps" and "accuracy" in line)}, sort_keys=True)


def joined(lines):
    """The lines with the times of each run in the line of its last examination."""
    kept, last = [], {}
    for line in lines:
        if "session" in line or isinstance(line["scene"], dict):
            kept.append(line)
        elif "ending" in line:
            kept.append(line)
            last[key_of(line)] = line
        elif key_of(line) in last:
            last[key_of(line)].update({name: line[name] for name in ("time", "wall_clock") if name in line})
    return kept


def runs_in(file):
    """The last examination of each run in a results file, with its times; `settings`, `values` and `time` may be empty."""
    runs = {}
    for line in joined(map(json.loads, Path(file).read_text(encoding="utf-8").splitlines())):
        if "ending" in line:
            runs.pop(key_of(line), None)
            runs[key_of(line)] = {"settings": {}, "values": {}, "time": {}, **line}
    return list(runs.values())
