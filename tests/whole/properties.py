# SPDX-License-Identifier: MIT
"""The properties by name. Each draws its cases, and checks a case by raising Fault."""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from case import Case
from drawn_scenes import Lists
from program import Program


@dataclass(frozen=True)
class Property:
    name: str
    weight: float
    draw: Callable[[Random, Lists], Case]
    check: Callable[[Program, Case, Lists], None]
    kind: bool = False  # one of those that --kinds runs


PROPERTIES: dict[str, Property] = {}


def must_hold(draw: Callable[[Random, Lists], Case], weight: float = 1.0, kind: bool = False):
    """Registers a function as a property under its name."""
    def register(check: Callable[[Program, Case, Lists], None]):
        PROPERTIES[check.__name__] = Property(check.__name__, weight, draw, check, kind)
        return check
    return register
