#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Random whole commands: any two features are combined, and properties are checked from outside the program.

    whole.py FDEBENCH [--seconds S] [--seed N|date] [--jobs J] [--keep DIR] [--coverage] [--slow FACTOR] [--only PROPERTY]...
    whole.py FDEBENCH --kinds --count N        N cases of the kinds of kinds.py, which need NumPy: every finding, and what was counted
    whole.py FDEBENCH --replay [FILE]...       the cases of kept/, or these

Exit code 1 if a property does not hold: the case is shrunk, printed and stored in DIR.
"""

import argparse
import datetime
import hashlib
import importlib.util
import itertools
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random

import agreement  # noqa: F401  (each of these modules registers properties)
import errors  # noqa: F401
import events  # noqa: F401
import fitting  # noqa: F401
import functions  # noqa: F401
import help_options  # noqa: F401
import mechanics  # noqa: F401
import programs  # noqa: F401
import python_module  # noqa: F401
import references  # noqa: F401
import results  # noqa: F401
import solving  # noqa: F401
import studies  # noqa: F401
from case import Case, shell
from drawn_scenes import Lists
from program import Fault, Program
from properties import PROPERTIES
from shrinking import shrunk

if importlib.util.find_spec("numpy"):
    import kinds  # noqa: F401

KEPT = Path(__file__).with_name("kept")


def fault_of(program: Program, case: Case, lists: Lists) -> Fault | None:
    program.fresh()
    case.write(program.folder)
    try:
        PROPERTIES[case.holds].check(program, case, lists)
    except Fault as fault:
        return fault
    except (ValueError, KeyError, IndexError, OverflowError, ZeroDivisionError) as wrong:
        return Fault("unread", f"{type(wrong).__name__}: {wrong}")
    return None


class Search:
    """The cases tried and the faults found, by all jobs together."""

    def __init__(self, options: argparse.Namespace, lists: Lists, cache: Path) -> None:
        self.options, self.lists, self.cache = options, lists, cache
        self.end = time.monotonic() + options.seconds
        self.chosen = [one for one in PROPERTIES.values() if (one.name in options.only if options.only else one.kind == options.kinds)]
        self.numbers = itertools.count()
        self.lock = threading.Lock()
        self.tried: Counter[str] = Counter()
        self.spent: Counter[str] = Counter()
        self.executions = 0
        self.features: set[tuple[str, str]] = set()
        self.pairs: set[tuple[tuple[str, str], tuple[str, str]]] = set()
        self.found: Counter[tuple[str, str, str]] = Counter()
        self.notes: Counter[tuple[str, str]] = Counter()

    def drawn(self, number: int) -> Case:
        """Case `number`: depends on the seed and the number only, not on the number of jobs. Of a count each property has its part."""
        random = Random(f"{self.options.seed}:{number}")
        if self.options.count:
            turns = [one for one in self.chosen for _ in range(max(1, round(one.weight)))]
            return turns[number % len(turns)].draw(random, self.lists)
        return random.choices(self.chosen, [one.weight for one in self.chosen])[0].draw(random, self.lists)

    def goes_on(self, number: int) -> bool:
        return number < self.options.count if self.options.count else time.monotonic() < self.end

    def note(self, case: Case, seconds: float, program: Program) -> None:
        self.spent[case.holds] += seconds
        self.notes.update({(case.holds, text): count for text, count in program.notes.items()})
        features = sorted(case.features())
        self.tried[case.holds] += 1
        self.features.update(features)
        self.pairs.update((a, b) for a, b in itertools.combinations(features, 2) if a[0] != b[0])

    def work(self, folder: Path) -> None:
        program = Program(self.options.fdebench, folder, self.cache, self.options.slow)
        while self.goes_on(number := next(self.numbers)):
            program.notes.clear()
            case = self.drawn(number)
            begin = time.monotonic()
            fault = fault_of(program, case, self.lists)
            with self.lock:
                self.note(case, time.monotonic() - begin, program)
                key = (case.holds, fault.kind, case.scheme) if fault else None
                known = key is None or key in self.found
                if key:
                    self.found[key] += 1
            if fault and (not known or self.options.count):
                self.report(program, case, fault, number, 0 if known else self.options.shrink)
        with self.lock:
            self.executions += program.executions

    def report(self, program: Program, case: Case, fault: Fault, number: int, seconds: float) -> None:
        def fails(other: Case) -> bool:
            same = fault_of(program, other, self.lists)
            return same is not None and same.kind == fault.kind

        last = fault
        if seconds:
            case = shrunk(case, fails, seconds * self.options.slow)
            last = fault_of(program, case, self.lists) or fault
        with self.lock:
            print(f"\nFOUND {case.holds} ({last.kind}; case {number} of seed {self.options.seed}): {last}\n{shell(case, last.arguments or program.last)}", flush=True)
            if self.options.keep:
                self.options.keep.mkdir(parents=True, exist_ok=True)
                name = hashlib.sha256(case.json().encode()).hexdigest()[:8]
                (self.options.keep / f"{case.holds}-{last.kind.replace(' ', '_')}-{name}.json").write_text(case.json())


def pairs_of(features: set[tuple[str, str]]) -> Iterator[tuple]:
    return ((a, b) for a, b in itertools.combinations(sorted(features), 2) if a[0] != b[0])


def search(options: argparse.Namespace) -> bool:
    with tempfile.TemporaryDirectory(prefix="fdebench-whole-") as name:
        folder = Path(name)
        first = Program(options.fdebench, folder / "first", folder / "cache", options.slow)
        first.fresh()
        state = Search(options, Lists.read(first), folder / "cache")
        with ThreadPoolExecutor(options.jobs) as pool:
            list(pool.map(state.work, [folder / str(k) for k in range(options.jobs)]))
        possible = sum(1 for _ in pairs_of(state.features))
        print(f"\nseed {options.seed}: {sum(state.tried.values())} cases, {state.executions} executions, "
              f"{len(state.pairs)} of {possible} pairs of {len(state.features)} features, {len(state.found)} findings")
        print(*(f"  {count:6} {holds}: {text}" for (holds, text), count in sorted(state.notes.items())), sep="\n")
        if options.count:
            print(*(f"  {count:6} {holds}: FOUND {kind} {scheme}" for (holds, kind, scheme), count in state.found.items()), sep="\n")
        if options.coverage:
            print(*(f"  {count:6} {holds}, {state.spent[holds]:.0f} s" for holds, count in state.tried.most_common()), sep="\n")
            missing = Counter((a[0], b[0]) for a, b in set(pairs_of(state.features)) - state.pairs)
            print(*(f"  {count:6} pairs not met of {a} and {b}" for (a, b), count in missing.most_common(12)), sep="\n")
        return bool(state.found)


def replay(options: argparse.Namespace) -> bool:
    failed = 0
    with tempfile.TemporaryDirectory(prefix="fdebench-whole-") as name:
        program = Program(options.fdebench, Path(name) / "case", Path(name) / "cache", options.slow)
        program.fresh()
        lists = Lists.read(program)
        cases = options.files or sorted(KEPT.glob("*.json"))
        for path in cases:
            case = Case.read(path)
            if fault := fault_of(program, case, lists):
                failed += 1
                print(f"\nFOUND {path.name}: {fault}\n{shell(case, fault.arguments or program.last)}", flush=True)
    print(f"{len(cases)} kept cases, {failed} do not hold")
    return failed > 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fdebench", type=Path)
    parser.add_argument("files", type=Path, nargs="*", help="with --replay: the cases")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--count", type=int, default=0, help="cases, in place of a time")
    parser.add_argument("--kinds", action="store_true", help="the properties that are compared with the oracle")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--slow", type=float, default=1.0, help="by how much this build is slower than a release build")
    parser.add_argument("--shrink", type=float, default=30, help="seconds for making a failing case shorter")
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--only", action="append", choices=sorted(PROPERTIES))
    parser.add_argument("--coverage", action="store_true")
    parser.add_argument("--replay", action="store_true")
    options = parser.parse_intermixed_args()
    if options.kinds and not importlib.util.find_spec("numpy"):
        parser.error("--kinds: this Python has no NumPy")
    if options.seed == "date":
        options.seed = datetime.date.today().isoformat()
    return int(replay(options) if options.replay else search(options))


if __name__ == "__main__":
    sys.exit(main())
