# SPDX-License-Identifier: MIT
"""A sweep that is interrupted after its first run prints how to resume it, ends by the signal and keeps its results."""

import pathlib
import signal
import subprocess
import sys
import time

FDEBENCH = sys.argv[1]
RESULTS = pathlib.Path("interrupted.jsonl")
PATIENCE = 60  # timeout in seconds for the reference and the first run

RESULTS.unlink(missing_ok=True)
sweep = subprocess.Popen(
    [FDEBENCH, "run", "--scene", "pendulum", "--thorough", "--out", RESULTS], stderr=subprocess.PIPE, text=True
)
end = time.monotonic() + PATIENCE
while not (RESULTS.exists() and RESULTS.stat().st_size):
    assert sweep.poll() is None and time.monotonic() < end, "the sweep has measured nothing"
    time.sleep(0.01)
sweep.send_signal(signal.SIGINT)
_, said = sweep.communicate(timeout=5)
assert sweep.returncode == -signal.SIGINT, f"exit code {sweep.returncode}: {said}"
assert "fdebench: stopped; the same command continues, what is measured is kept" in said.splitlines(), said
assert RESULTS.stat().st_size
