# SPDX-License-Identifier: MIT
"""Random numbers as decimal texts."""

import re
from random import Random


def typed(value: float, digits: int = 4) -> str:
    return f"{value:.{digits}g}"


def spread(random: Random, low: float, high: float) -> float:
    """Log-uniform between two positive numbers."""
    from math import exp, log
    return exp(random.uniform(log(low), log(high)))


def in_interval(random: Random, low: float, high: float, open_low: bool, open_high: bool, whole: bool) -> str:
    """A value inside the interval, at an end, or close to an end."""
    if whole:
        return str(int(min(high, low + spread(random, 1, 40) - 1)))
    width = high - low
    if random.random() < 0.75:
        return typed(random.uniform(low + 0.02 * width, high - 0.02 * width) if width < 1e3 else low + spread(random, 1e-2, 1e3))
    if random.random() < 0.4:
        return typed(random.choice([edge for edge, is_open in ((low, open_low), (high, open_high)) if not is_open] or [low + width / 2]), 17)
    near = width * random.choice([0.01, 0.03, 1e-3, 1e-6]) if width < 1e3 else spread(random, 1e-6, 1)
    return typed(random.choice([low + near, high - near]) if width < 1e3 else low + near, 8)


def finite(random: Random, default: float, least: float | None, wild: bool) -> str:
    """A value near the default; of any magnitude if `wild`."""
    if random.random() < 0.1:
        return random.choice(["0", "1"]) if least is None else typed(least + 1)
    size = spread(random, 1e-6, 1e6) if wild else spread(random, 0.05, 5) * max(abs(default), 0.3)
    return typed((least or 0) + size if least is not None else size * random.choice([-1, 1, 1 if default >= 0 else -1]))


def drawn(random: Random, name: str, default: object, allowed: str, wild: bool) -> str:
    """A value of a parameter, by the sentence that describes the allowed values."""
    if allowed.startswith("a list, each "):
        one = allowed.removeprefix("a list, each ")
        return ",".join(drawn(random, name, 1.0, one, wild) for _ in default)  # type: ignore[union-attr]
    if allowed.startswith("one of "):
        return random.choice(allowed.removeprefix("one of ").split(", "))
    if interval := re.match(r"a number in ([\[(])([^,]+), ([^\])]+)([\])])", allowed):
        opening, low, high, closing = interval.groups()
        return in_interval(random, float(low), float(high), opening == "(", closing == ")", name in ("components", "n", "modes"))
    least = re.match(r"a finite number (?:above|of at least) (-?[\d.e+-]+)", allowed)
    return finite(random, default if isinstance(default, float) else 1.0, float(least.group(1)) if least else None, wild)
