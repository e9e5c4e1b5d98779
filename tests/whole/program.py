# SPDX-License-Identifier: MIT
"""Runs one command of fdebench and checks how it ends."""

import os
import shutil
import subprocess
import threading
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

SANITIZERS = ("AddressSanitizer", "LeakSanitizer", "ThreadSanitizer", "runtime error:", "UndefinedBehaviorSanitizer")


class Fault(Exception):
    """A property does not hold. `kind` stays the same while a case is shrunk."""

    def __init__(self, kind: str, text: str, arguments: tuple[str, ...] = ()) -> None:
        super().__init__(text)
        self.kind, self.arguments = kind, arguments


@dataclass(frozen=True)
class Outcome:
    arguments: tuple[str, ...]
    code: int
    out: str
    err: str

    @property
    def done(self) -> bool:
        return self.code == 0


def reasons(err: str, elapsed: float) -> list[str]:
    """The lines on standard error without progress lines, which are printed once a minute."""
    lines = err.splitlines()
    return lines if elapsed < 55.0 else [line for line in lines if line.startswith(("fdebench: ", '{"'))]


def ending_fault(outcome: Outcome, seconds: float, elapsed: float) -> tuple[str, str] | None:
    """The violation of docs/command.md, "Exit codes", by the end of a command; None if there is none."""
    lines = reasons(outcome.err, elapsed)
    if any(word in outcome.err for word in SANITIZERS):
        return "sanitizer", next(line for line in lines if any(word in line for word in SANITIZERS))
    if outcome.code in (-24, 152, 137, -9):
        return "time", f"still running after {seconds:g} s of processor time"
    if outcome.code < 0 or outcome.code >= 128:
        return "signal", f"ends by signal {-outcome.code if outcome.code < 0 else outcome.code - 128}"
    if outcome.code not in (0, 1, 2, 3) or (outcome.code == 1 and outcome.arguments[0] != "compare"):
        return "code", f"ends with exit code {outcome.code}"
    if any(not line.startswith(("fdebench: ", '{"')) for line in lines) and outcome.arguments[0] not in ("run", "reference", "choose"):
        return "stderr", f"says on standard error: {outcome.err[:300]!r}"
    if outcome.code in (2, 3) and len(lines) != 1:
        return "reason", f"exit code {outcome.code} with {len(lines)} lines of reason: {outcome.err[:300]!r}"
    if outcome.code in (2, 3) and outcome.out:
        return "output", f"exit code {outcome.code} behind {len(outcome.out.splitlines())} lines of output"
    if outcome.code in (2, 3) and any(ord(c) < 32 for c in lines[0]):
        return "reason", f"the reason has control characters: {lines[0]!r}"
    return None


class Program:
    """Runs commands in one folder and counts them. Raises Fault if a command does not end as documented."""

    def __init__(self, binary: Path, folder: Path, cache: Path, slow: float = 1.0) -> None:
        self.binary, self.folder, self.slow = binary.resolve(), folder, slow
        self.environment = {**os.environ, "FDEBENCH_CACHE": str(cache)}
        self.executions = 0
        self.last: tuple[str, ...] = ()
        self.lock = threading.Lock()
        self.notes: Counter[str] = Counter()  # of what a property counts
        self.doubts: list[str] = []

    def note(self, text: str) -> None:
        self.notes[text] += 1

    def fresh(self) -> None:
        """Empties the folder for the next case."""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def run(self, *arguments: str, seconds: float = 30.0) -> Outcome:
        """Runs a command with a limit of `seconds` of CPU time, times the factor for slow builds."""
        limit = seconds * self.slow
        budgets = [k + 1 for k, word in enumerate(arguments) if word == "--budget"]
        arguments = tuple(f"{float(word) * self.slow:g}" if k in budgets else word for k, word in enumerate(arguments))
        self.last = arguments
        with self.lock:
            self.executions += 1
        command = ["sh", "-c", f'ulimit -t {int(limit) + 1}; exec "$0" "$@"', str(self.binary), *arguments]
        begin = time.monotonic()
        try:
            ended = subprocess.run(command, capture_output=True, cwd=self.folder, env=self.environment,
                                   timeout=10 * limit + 60, stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            raise Fault("time", f"does not end within {10 * limit + 60:g} s") from None
        outcome = Outcome(arguments, ended.returncode, ended.stdout.decode(errors="replace"), ended.stderr.decode(errors="replace"))
        if fault := ending_fault(outcome, limit, time.monotonic() - begin):
            raise Fault(*fault, arguments)
        return outcome
