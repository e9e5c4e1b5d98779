#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Calls of libfdebench.so with random arguments, many of them bad: each returns a status, and a message where it is not 0.

    random_arguments.py LIBRARY [SEED [COUNT]]
"""

import ctypes
import math
import random
import sys
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_longlong, c_size_t, c_void_p

STATUSES = {0, 2, 3, 4, 5}  # 6 is an error of fdebench
NUMBERS = POINTER(c_double)
# By their kinds: f(t, y, f, user), f(t, y, past, f, user), before(t, y, user).
CALLBACKS = {
    "function": ctypes.CFUNCTYPE(c_int, c_double, NUMBERS, NUMBERS, c_void_p),
    "delayed": ctypes.CFUNCTYPE(c_int, c_double, NUMBERS, NUMBERS, NUMBERS, c_void_p),
    "before": ctypes.CFUNCTYPE(c_int, c_double, NUMBERS, c_void_p),
}
REALS = [0.5, 1.0, 0.0, -1.0, 2.0, 1.5, 3.0, 1e-300, 1e300, math.inf, -math.inf, math.nan]
TEXTS = [None, b"", b"steps", b"at", b"l1", b"bdf2", b"grid", b"uniform", b"graded:2", b"1e-3", b"relaxation", b"scheme", b"seconds",
         b"relaxation:gamma=0.7", b"relaxation:gamma=9", b"pendulum:until=1", b"\xff\xfe", b"--json", b"a" * 5000, b"-1", b"nan", b"1,2,,"]
SIZES = [0, 1, 2, 3]


def callback(random_source, kind):
    code = random_source.choice([0, 0, 0, 1, -5])

    def f(_t, *arrays):
        y, into = arrays[0], arrays[-2]
        into[0] = random_source.choice([-y[0], 1.0, math.nan]) if code else -y[0]
        return code

    return CALLBACKS[kind](f)


class Caller:
    """Makes calls; handles that are made are arguments of later ones."""

    def __init__(self, library, source):
        self.library, self.source, self.kept = library, source, []
        self.handles = {kind: [None] for kind in ("problem", "options", "table", "choice")}
        library.fdebench_last_error.restype = c_char_p

    def argument(self, kind):
        choose = self.source.choice
        if kind in self.handles:
            return c_void_p(choose(self.handles[kind]))
        if kind == "real":
            return c_double(choose(REALS))
        if kind == "reals":
            return choose([None, *[(c_double * 4)(*self.source.choices(REALS, k=4))] * 4])
        if kind == "text":
            return c_char_p(choose(TEXTS))
        if kind == "texts":
            return choose([None, (c_char_p * 4)(*self.source.choices(TEXTS, k=4))])
        if kind == "size":
            return c_size_t(choose(SIZES))
        if kind == "integer":
            return c_longlong(choose([0, 1, 8, 64, -1, -(2**63), 2**63 - 1]))
        if kind in CALLBACKS:
            made = callback(self.source, kind)
            return choose([ctypes.cast(made, c_void_p), ctypes.cast(made, c_void_p), None]) if self.kept.append(made) is None else None
        if kind == "memory":
            return choose([None, *[ctypes.create_string_buffer(64)] * 4])
        return None  # user

    def call(self, name, kinds):
        made = c_void_p()
        arguments = [byref(made) if kind.startswith("new ") else self.argument(kind) for kind in kinds]
        if any(kind.startswith("new ") for kind in kinds) and self.source.random() < 0.1:
            arguments[-1] = None
        status = getattr(self.library, f"fdebench_{name}")(*arguments)
        if status not in STATUSES:
            sys.exit(f"{name}{arguments}: status {status}, {self.library.fdebench_last_error()}")
        if status and not self.library.fdebench_last_error():
            sys.exit(f"{name}{arguments}: status {status} without a message")
        if (made.value is not None) != (status == 0 and kinds[-1].startswith("new ") and arguments[-1] is not None):
            sys.exit(f"{name}{arguments}: status {status} with the handle {made.value}")
        if made.value is not None:
            self.handles[kinds[-1].split()[1]].append(made.value)
        return status


# The sizes of memory are at most 4 numbers, as capacities and counts are.
CALLS = {
    "problem_new": ["size", "reals", "size", "reals", "real", "function", "user", "new problem"],
    "problem_of_scene": ["text", "new problem"],
    "problem_set_jacobian": ["problem", "function"],
    "problem_set_names": ["problem", "size", "texts"],
    "problem_set_jumps": ["problem", "size", "reals"],
    "problem_set_delays": ["problem", "size", "reals", "delayed", "delayed", "before"],
    "problem_size": ["problem", "memory", "memory"],
    "problem_name": ["problem", "size", "memory"],
    "problem_order": ["problem", "size", "memory"],
    "problem_end": ["problem", "memory"],
    "options_new": ["new options"],
    "options_set_integer": ["options", "text", "integer"],
    "options_set_real": ["options", "text", "real"],
    "options_set_reals": ["options", "text", "size", "reals"],
    "options_set_text": ["options", "text", "text"],
    "solve": ["problem", "text", "options", "new table"],
    "exact": ["problem", "size", "reals", "new table"],
    "table_size": ["table", "memory", "memory"],
    "table_name": ["table", "size", "memory"],
    "table_times": ["table", "memory", "size"],
    "table_values": ["table", "memory", "size"],
    "table_bounds": ["table", "memory", "size"],
    "table_number": ["table", "text", "memory"],
    "table_text": ["table", "text", "memory"],
    "choice_number": ["choice", "text", "memory"],
    "mittag_leffler": ["real", "real", "real", "real", "memory", "memory"],
    "scheme_count": ["memory"],
    "scheme_name": ["size", "memory"],
    "scene_count": ["memory"],
    "scene_name": ["size", "memory"],
}


def main(path, seed="1", count="1000"):
    source = random.Random(int(seed))
    caller = Caller(ctypes.CDLL(path), source)
    counts = dict.fromkeys(STATUSES, 0)
    for _ in range(int(count)):
        name = source.choice(list(CALLS))
        if name == "exact" and source.random() < 0.9:
            continue  # a reference by two methods takes its time
        counts[caller.call(name, CALLS[name])] += 1
    for kind, handles in caller.handles.items():
        for handle in handles:
            getattr(caller.library, f"fdebench_{kind}_free")(c_void_p(handle))
    if not counts[0] or not counts[2]:
        sys.exit(f"the calls are not various: {counts}")
    print(f"calls by their status: {counts}")


main(*sys.argv[1:])
