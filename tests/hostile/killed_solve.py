# SPDX-License-Identifier: MIT
"""A solve that is killed repeatedly, also while it writes its checkpoint, prints the same bits as an uninterrupted one.

killed_solve.py FDEBENCH [KILLS]: 12 kills by default. A checkpoint is written after every step.
"""

import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

FDEBENCH = sys.argv[1]
KILLS = int(sys.argv[2]) if len(sys.argv) > 2 else 12
RUN = [FDEBENCH, "solve", "fractional_diffusion:components=300", "--scheme", "l1", "--steps", "400", "--every", "100"]

seed = random.SystemRandom().randrange(1 << 32)
random.seed(seed)
print("seed", seed)
start = time.monotonic()
whole = subprocess.run(RUN, capture_output=True, text=True, check=True).stdout
LONGEST = 2.0 * (time.monotonic() - start)  # longest time before a kill, in seconds; runs with checkpoints take longer
with tempfile.TemporaryDirectory() as folder:
    state = pathlib.Path(folder) / "state"
    keeping = [*RUN, "--checkpoint", state, "--checkpoint-every", "0", "--cost"]
    kills = continued = ended = 0
    while kills < KILLS or not ended:
        was_there = state.exists()
        run = subprocess.Popen(keeping, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if kills < KILLS:
            time.sleep(random.uniform(0.0, LONGEST))
            run.send_signal(random.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGINT, signal.SIGTERM]))
        out, said = run.communicate()
        if run.returncode < 0:
            kills += 1
            continue
        assert run.returncode == 0, f"exit code {run.returncode}: {said}"
        assert out == whole, "the bits are others than those of a run that nobody killed"
        assert json.loads(said).get("continued", False) == was_there, said
        assert not list(pathlib.Path(folder).iterdir()), "something is left of the state"
        continued += was_there
        ended += 1
    assert continued, "no run went on from a state"
print(f"{kills} kills of {ended} runs, {continued} of them continued at their end: the bits of a run that nobody killed")
