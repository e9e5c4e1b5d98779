#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""On a terminal: the width of help, colours, progress that begins after two seconds and is erased. In a pipe there is none of it."""

import fcntl
import os
import pty
import re
import struct
import subprocess
import sys
import termios
import time

PROGRAM = sys.argv[1]
COLOUR = re.compile(r"\x1b\[[0-9;]*m")
# Direct sums of so many steps take longer than the budget.
LONG = ["solve", "relaxation", "--scheme", "l1", "--steps", "500000", "--history", "direct", "--at", "1", "--budget"]
FAULTS = []


def must(holds, what):
    if not holds:
        FAULTS.append(what)


def on_terminal(arguments, columns=80, streams=("out", "err"), **environment):
    """What a command writes to a terminal, and the seconds until its first byte; streams that are not named are discarded."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    begin, first, text = time.monotonic(), None, b""
    process = subprocess.Popen([PROGRAM, *arguments], env={**os.environ, "TERM": "xterm", "NO_COLOR": "", **environment},
                               stdout=theirs if "out" in streams else subprocess.DEVNULL, stderr=theirs if "err" in streams else subprocess.DEVNULL)
    os.close(theirs)
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:
            break
        if not piece:
            break
        first = first if first is not None else time.monotonic() - begin
        text += piece
    process.wait()
    os.close(ours)
    return text.decode(), first


def check_help():
    for columns in (80, 120):
        text, _ = on_terminal(["solve", "--help"], columns)
        lines = COLOUR.sub("", text).split("\r\n")
        prose = [line for line in lines if not line.startswith("  fdebench solve relaxation")]
        must(max(map(len, prose)) <= columns, f"help at {columns} columns has a line of {max(map(len, prose))}")
        must(max(map(len, prose)) > columns - 15, f"help at {columns} columns is narrow")
        must(COLOUR.search(text), f"help at {columns} columns has no colours")
    piped = subprocess.run([PROGRAM, "solve", "--help"], capture_output=True, text=True, check=True).stdout
    must(not COLOUR.search(piped), "help in a pipe has colours")
    for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
        must(not COLOUR.search(on_terminal(["solve", "--help"], **environment)[0]), f"help has colours in spite of {environment}")


def check_streams():
    """Both streams are judged separately."""
    out, _ = on_terminal(["help"], streams=["out"])
    must(COLOUR.search(out), "standard output has no colours where only it is a terminal")
    err, _ = on_terminal(["solv"], streams=["err"])
    must(COLOUR.search(err) and "fdebench" in err, "an error has no colours")
    must(not COLOUR.search(on_terminal(["solv"], NO_COLOR="1")[0]), "an error has colours in spite of NO_COLOR")


def check_progress():
    for budget in ("3", "8"):  # on a loaded machine the weights alone take seconds
        text, first = on_terminal([*LONG, budget])
        if " left" in text:
            break
    must(first is not None and first >= 2, f"progress begins after {first} s")
    must(" %  " in text and "/500000" in text and " left" in text, f"progress is {text!r}")
    last = text.split("\r")
    must(any(not line.strip() and len(line) >= 79 for line in last), "progress is not erased")
    must("\n" not in text.partition("fdebench:")[0], "progress is more than a line")
    quiet, _ = on_terminal([*LONG, "3", "--quiet"])
    must("/500000" not in quiet and "fdebench:" in quiet, f"--quiet leaves {quiet!r}")
    piped = subprocess.run([PROGRAM, *LONG, "3"], capture_output=True, text=True, check=False)
    must(piped.returncode == 3 and piped.stderr.count("\n") == 1 and "\r" not in piped.stderr, f"a pipe has {piped.stderr!r}")


check_help()
check_streams()
check_progress()
print("\n".join(FAULTS))
sys.exit(bool(FAULTS))
