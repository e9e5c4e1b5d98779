#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""interrupted.py FDEBENCH: a signal ends a sweep and the external program it runs, and leaves no temporary file and no partial row."""

import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = sys.argv.pop(1)
SLOW = 'echo $$ > "$0.pid"; test -e "$0.go" || { sleep 100; }; echo t,y; echo 0,0; echo 1,1\n'


def is_alive(pid):
    """Whether the process exists and is no zombie."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def wait_until(condition):
    for _ in range(2000):
        if condition():
            return True
        time.sleep(0.01)
    return False


class Interrupted(unittest.TestCase):
    def test_ends_its_program_and_is_continued(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            with self.subTest(signal=number.name), tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                script, results, temporary = folder / "slow.sh", folder / "results.jsonl", folder / "temporary"
                temporary.mkdir()
                script.write_text(SLOW)
                command = [PROGRAM, "run", "--scene", "power:p=1", "--steps", "1", "--repeat", "1", "--scheme", "l1",
                           "--external", f"slow=sh {script}", "--out", results]  # fmt: skip
                environment = {**os.environ, "TMPDIR": str(temporary)}
                run = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                noted = Path(f"{script}.pid")
                self.assertTrue(wait_until(lambda: noted.exists() and noted.read_text().endswith("\n")))
                child = int(noted.read_text())
                self.assertTrue(is_alive(child))
                self.assertTrue(list(temporary.iterdir()))
                run.send_signal(number)
                said = run.communicate(timeout=20)[1]
                if number != signal.SIGKILL:
                    self.assertIn("the same command continues", said)
                self.assertEqual(run.returncode, -number)
                self.assertTrue(wait_until(lambda: not is_alive(child)))
                self.assertTrue(wait_until(lambda: not list(temporary.iterdir())))
                before = results.read_text()
                self.assertIn('"scheme":"l1"', before)
                self.assertFalse('"scheme":"slow"' in before, before[-400:])
                Path(f"{script}.go").touch()
                again = subprocess.run(command, env=environment, capture_output=True, text=True)
                self.assertEqual(again.returncode, 0, again.stderr)
                self.assertTrue(results.read_text().startswith(before))
                self.assertIn('"scheme":"slow"', results.read_text())


if __name__ == "__main__":
    unittest.main()
