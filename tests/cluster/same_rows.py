#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether two results files say the same but for times: same_rows.py FIRST SECOND.

The order of the lines, the sessions, what belongs to a timing, and how long a reference took may differ. The files must have the
times of the same runs. Prints what differs, or how much is the same.
"""

import collections
import json
import sys

OF_TIMING = {"load", "switches", "frequency", "disturbed"}
VALUES = {"quantity", "value", "unit", "last"}


def contents(path):
    """How often each row and scene is in the file; the timed runs; the number of timings that were disturbed."""
    lines, timed, disturbed = collections.Counter(), collections.Counter(), 0
    with open(path, encoding="utf-8") as file:
        for line in map(json.loads, file):
            if "session" in line:
                continue
            if isinstance(line["scene"], dict):
                line["scene"].pop("reference_seconds", None)
            elif line["unit"] == "s" or line["quantity"] in OF_TIMING:
                disturbed += line["quantity"] == "disturbed" and line["value"] > 0
                if line["quantity"] == "time_minimum":
                    timed[json.dumps({key: line[key] for key in line.keys() - VALUES}, sort_keys=True)] += 1
                continue
            lines[json.dumps(line, sort_keys=True)] += 1
    return lines, timed, disturbed


def differences(first, second):
    """Sentences; none if the files say the same."""
    (lines, timed, _), (other_lines, other_timed, _) = contents(first), contents(second)
    found = [f"only in {first}: {line[:300]}" for line in (lines - other_lines)]
    found += [f"only in {second}: {line[:300]}" for line in (other_lines - lines)]
    found += [f"timed in one file only: {run[:300]}" for run in timed.keys() ^ other_timed.keys()]
    return found


if __name__ == "__main__":
    wrong = differences(*sys.argv[1:3])
    print(*wrong[:10], sep="\n")
    if wrong:
        sys.exit(f"{len(wrong)} differences")
    rows, runs, shaken = contents(sys.argv[2])
    print(f"the same {sum(rows.values())} rows and scenes, {len(runs)} timed runs; {shaken} of {sum(runs.values())} timings disturbed")
