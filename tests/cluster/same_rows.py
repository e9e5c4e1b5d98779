#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether two results files say the same but for times: same_rows.py FIRST SECOND.

The order of the lines, the sessions, what belongs to a timing, and how long a reference took may differ. The files must have the
times of the same runs. Prints what differs, or how much is the same.
"""

import collections
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks" / "programs" / "records"))
from recorded_runs import joined, key_of  # noqa: E402


def contents(path):
    """How often each run and scene is in the file; the timed runs; the number of timings that were disturbed."""
    lines, timed, disturbed = collections.Counter(), set(), 0
    with open(path, encoding="utf-8") as file:
        for line in joined(map(json.loads, file)):
            if "session" in line:
                continue
            if isinstance(line["scene"], dict):
                line["scene"].pop("reference_seconds", None)
            elif times := line.pop("time", None):
                timed.add(key_of(line))
                disturbed += times.get("disturbed", 0) > 0
            lines[json.dumps(line, sort_keys=True)] += 1
    return lines, timed, disturbed


def differences(first, second):
    """Sentences; none if the files say the same."""
    (lines, timed, _), (other_lines, other_timed, _) = contents(first), contents(second)
    found = [f"only in {first}: {line[:300]}" for line in (lines - other_lines)]
    found += [f"only in {second}: {line[:300]}" for line in (other_lines - lines)]
    found += [f"timed in one file only: {run[:300]}" for run in timed ^ other_timed]
    return found


if __name__ == "__main__":
    wrong = differences(*sys.argv[1:3])
    print(*wrong[:10], sep="\n")
    if wrong:
        sys.exit(f"{len(wrong)} differences")
    lines, runs, shaken = contents(sys.argv[2])
    print(f"the same {sum(lines.values())} runs and scenes, {len(runs)} timed runs; {shaken} of {len(runs)} timings disturbed")
