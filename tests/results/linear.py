#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""linear.py FDEBENCH COUNTER: twice the runs take twice the work, and the memory stays a small multiple of the file.

The work is the bytes that a command allocates, which COUNTER, a preloaded library, counts: a busy machine changes nothing. The
memory is the largest resident set.
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "programs" / "records"))
from many_runs import measured, write_copies  # noqa: E402

PROGRAM, COUNTER = sys.argv[1:3]
del sys.argv[1:3]
FEW = 4  # copies of 9 scenes


def commands(file, out):
    yield ["merge", file, "--out", out / "merged"]
    yield ["compare", file, file]
    yield ["export", file, "--to", "sqlite", "--out", out / "database"]
    yield ["export", file, "--to", "csv", "--out", out / "tables"]
    yield ["report", file, "--out", out / "report"]


class Linear(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        lines = measured(PROGRAM, "16,32")
        of_copy = sum('"ending":' in line for line in lines)
        for n in (1, 2, 4):
            write_copies(lines, n * FEW * of_copy, cls.folder / f"{n}.jsonl")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def costs(self, n, run):
        """What each command costs with n times the runs."""
        out = self.folder / f"{run.__name__}{n}"
        out.mkdir()
        return {" ".join(map(str, words[:1] + words[2:4] * (words[0] == "export"))): run(list(map(str, words)))
                for words in commands(self.folder / f"{n}.jsonl", out)}  # fmt: skip

    def allocated(self, words):
        counted = self.folder / "counted"
        subprocess.run([PROGRAM, *words], check=True, capture_output=True, env={**os.environ, "LD_PRELOAD": COUNTER, "ALLOCATED_BYTES": str(counted)})
        return int(counted.read_text())

    def memory(self, words):
        with subprocess.Popen([PROGRAM, *words], stdout=subprocess.DEVNULL) as process:
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return used.ru_maxrss * 1024

    def test_work(self):
        """Twice as many further rows cost twice as much; what is quadratic costs four times as much."""
        one, two, four = (self.costs(n, self.allocated) for n in (1, 2, 4))
        for command, count in one.items():
            with self.subTest(command=command):
                self.assertLess((four[command] - two[command]) / (two[command] - count), 2.2)

    def test_memory(self):
        """Bytes for each further byte of the file."""
        most = {"merge": 2.0, "export --to csv": 4.0, "export --to sqlite": 4.0, "compare": 6.0, "report": 6.0}
        one, four = (self.costs(n, self.memory) for n in (1, 4))
        further = (self.folder / "4.jsonl").stat().st_size - (self.folder / "1.jsonl").stat().st_size
        slack = 2e6
        for command, bytes_of_one in one.items():
            with self.subTest(command=command):
                self.assertLess(four[command] - bytes_of_one, most[command] * further + slack)


if __name__ == "__main__":
    unittest.main()
