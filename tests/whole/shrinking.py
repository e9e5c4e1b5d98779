# SPDX-License-Identifier: MIT
"""Shrinks a failing case: leaves out options, parameters, lines and terms and simplifies numbers while it fails alike."""

import re
import time
from collections.abc import Callable, Iterator
from dataclasses import replace

from case import Case

NEEDED = {"--accuracy", "--steps", "--at", "--error", "--gamma", "--kind", "--tolerance", "--budget"}
NUMBER = re.compile(r"(?<![\w.])\d+\.?\d*(?:e[+-]?\d+)?(?![\w.])")


def without(mapping: dict[str, str], key: str) -> dict[str, str]:
    return {k: v for k, v in mapping.items() if k != key}


def plainer(text: str) -> Iterator[str]:
    """Simpler numbers, the simplest first."""
    try:
        value = float(text)
    except ValueError:
        if "," in text:
            parts = text.split(",")
            yield from (",".join(parts[:k] + parts[k + 1:]) for k in range(len(parts)))
        return
    simpler = ["0", "1", "2", "0.5", *(f"{value:.{d}g}" for d in (1, 2, 3))]
    yield from (other for other in simpler if len(other) < len(text))
    if text.isdigit() and value > 1:
        yield str(int(value) // 2)


def shorter_formulas(line: str) -> Iterator[str]:
    """Variants of a formula with one term less in a sum, or a simpler number."""
    match = re.match(r'(rhs|zero|\w+) = "(.*)"$', line)
    if match:
        terms = match.group(2).split(" + ")
        if len(terms) > 1:
            yield from (f'{match.group(1)} = "{" + ".join(terms[:k] + terms[k + 1:])}"' for k in range(len(terms)))
    for number in NUMBER.finditer(line):
        for other in plainer(number.group()):
            yield line[:number.start()] + other + line[number.end():]


def shorter_files(file: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    sections = [k for k, line in enumerate(file) if line.startswith("[")]
    for begin, end in zip(sections, [*sections[1:], len(file)]):
        yield file[:begin] + file[end:]
    for k, line in enumerate(file):
        if not line.startswith("["):
            yield file[:k] + file[k + 1:]
        yield from (file[:k] + (other,) + file[k + 1:] for other in shorter_formulas(line))


def shorter(case: Case) -> Iterator[Case]:
    for key in case.chosen:
        if not (key == "until" and case.holds.startswith("exact")):
            yield replace(case, chosen=without(case.chosen, key))
    for key in case.options:
        if key not in NEEDED:
            yield replace(case, options=without(case.options, key))
    yield from (replace(case, file=file) for file in shorter_files(case.file))
    for name in ("chosen", "options"):
        mapping = getattr(case, name)
        for key, value in mapping.items():
            simpler = [] if key == "--budget" else [f"{float(value):.0e}"] if key in ("--accuracy", "--error", "--tolerance") else plainer(value)
            yield from (replace(case, **{name: {**mapping, key: other}}) for other in simpler if other != value)


def shrunk(case: Case, fails: Callable[[Case], bool], seconds: float) -> Case:
    end = time.monotonic() + seconds
    again = True
    while again:
        again = False
        for other in shorter(case):
            if time.monotonic() > end:
                return case
            if fails(other):
                case, again = other, True
                break
    return case
