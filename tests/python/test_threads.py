# SPDX-License-Identifier: MIT
"""Long solves leave the interpreter to other threads, and Ctrl-C ends them."""

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import fdebench

LONG = {
    "solve": 'fdebench.solve("pendulum", "l1", 2**20, history="direct", points=2)',
    "exact": 'fdebench.exact("fractional_oscillator", 1.0, digits=4000)',
    "choose": 'fdebench.choose("pendulum", 1e-12, seconds=600)',
    "problem": 'fdebench.solve(fdebench.Problem([0.5], [1.0], lambda t, y: -y, 1.0), "l1", 2**24, points=2)',
    "sweep": 'fdebench.sweep(["pendulum", "bagley_torvik"], schemes=["l1"], steps=[2**20])',
    "two_sided": 'fdebench.solve("fractional_extremum", "product_trapezoidal", 2**18, points=2)',
}


def processor_seconds(usage):
    return usage.ru_utime + usage.ru_stime


def processor_seconds_so_far(child):
    fields = Path(f"/proc/{child.pid}/stat").read_text().rpartition(") ")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@pytest.mark.parametrize("what", LONG)
def test_ctrl_c_ends_it_within_a_second(what):
    """Of the processor: the machine may be busy with others."""
    program = (
        "import fdebench\n"
        f"print('begins', flush=True)\ntry:\n  {LONG[what]}\n  print('done')\nexcept KeyboardInterrupt:\n  print('ended')\n"
    )
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    try:
        assert child.stdout.readline() == "begins\n"
        time.sleep(0.5)
        before = processor_seconds_so_far(child)
        child.send_signal(signal.SIGINT)
        assert child.stdout.read() == "ended\n"
        _, _, usage = os.wait4(child.pid, 0)
        assert processor_seconds(usage) - before < 1.0
    finally:
        child.kill()


def test_other_threads_run_during_a_solve():
    """The main thread counts on while another one solves: with the lock held it would not count before the solve is done."""
    began = threading.Event()

    def solve():
        began.set()
        fdebench.solve("pendulum", "l1", 2**15, history="direct", points=2)

    thread = threading.Thread(target=solve)
    thread.start()
    began.wait()
    naps = 0
    while thread.is_alive():
        time.sleep(0.005)
        naps += 1
    assert naps >= 5


def test_right_hand_sides_of_python_solve_side_by_side():
    """Eight solves of D^0.5 y = -a y in four threads have the values that each has alone."""

    def solve(a):
        problem = fdebench.Problem([0.5], [1.0], lambda t, y: -a * y, 1.0)
        return fdebench.solve(problem, "product_trapezoidal", 64)["y"]

    rates = [0.25 * k for k in range(1, 9)]
    with ThreadPoolExecutor(4) as workers:
        together = list(workers.map(solve, rates))
    for a, values in zip(rates, together):
        assert (values == solve(a)).all()


def test_multiprecision_of_several_threads_takes_turns():
    with ThreadPoolExecutor(4) as workers:
        texts = list(workers.map(lambda n: fdebench.mittag_leffler_digits(1, 1, "1", n), [50, 200, 50, 200, 100]))
    e = "2.718281828459045235360287471352662497757247"
    assert all(text.re.startswith(e) for text in texts)
