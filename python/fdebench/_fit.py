# SPDX-License-Identifier: MIT
"""Parameters of scenes from measurements."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Optional

import numpy
from numpy.typing import ArrayLike

from . import _core
from ._scene import Problem, Scene, _known, _real, _reals, _text

Limits = Optional[tuple[Optional[float], Optional[float]]]


def fit(
    scene: str | os.PathLike[str] | Scene,
    data: Mapping[str, ArrayLike],
    vary: Iterable[str] | Mapping[str, Limits],
    *,
    scheme: str | None = None,
    confidence: float = 0.95,
    budget: float = 600.0,
) -> dict[str, Any]:
    """Parameters and orders of a scene that fit measurements best, by least squares: the object of ``fdebench fit --json``.

    ``data`` has the times ``"t"``, which may repeat but not decrease, columns of the scene, and their standard deviations
    ``"sd_y"`` if they are known; nan is a missing value. A table of pandas will do. ``vary`` names parameters, or gives for each its
    limits: ``{"gamma": (0, 1), "lambda": None}``. The fit starts from the values that the scene has. ``solver_error`` says by how much
    exact solutions would move an estimate. Raises NumericalFailure where the measurements do not determine the parameters,
    and where the fit is out of its budget of seconds.

    >>> from fdebench import exact, fit
    >>> times = numpy.linspace(0.1, 2.0, 20)
    >>> data = {"t": times, "y": exact("relaxation:gamma=0.7,until=2", times)["y"] + 0.01 * numpy.cos(40 * times)}
    >>> estimate = fit("relaxation:until=2", data, ["gamma"])["parameters"][0]
    >>> estimate["low"] < 0.7 < estimate["high"]
    True
    """
    posed = _known(scene)
    if isinstance(posed, Problem):
        raise TypeError("scene: a Problem has no parameters; write the equation in a file, or fit it with scipy.optimize.least_squares")
    name, settings, _ = posed._posed
    if not hasattr(data, "keys"):
        raise TypeError(f"data = {data!r}: must be a mapping of columns, as in {{'t': times, 'y': values}}")
    if not all(isinstance(key, str) for key in data.keys()):
        raise TypeError(f"data: has the columns {list(data.keys())}, whose names must be texts")
    columns = {key: numpy.atleast_1d(_reals(f"data[{key!r}]", data[key])) for key in data.keys()}
    times = columns.pop("t", None)
    if times is None:
        raise ValueError("data: must have the times 't'")
    for key, column in columns.items():
        if column.shape != times.shape or times.ndim != 1:
            raise ValueError(f"data[{key!r}]: must be a list of numbers, as many as there are times, not of shape {column.shape}")
    rows = numpy.column_stack([times, *columns.values()]).tolist()
    chosen = None if scheme is None else _text("scheme", scheme)
    return _core.fit(name, settings, list(columns), rows, _varied(vary), chosen, _real("confidence", confidence), _real("budget", budget))


def _varied(vary: Iterable[str] | Mapping[str, Limits]) -> list[tuple[str, float | None, float | None]]:
    if isinstance(vary, str) or not hasattr(vary, "__iter__"):
        raise TypeError(f"vary = {vary!r}: must be a list of names, or a mapping of names to limits")
    limits = vary if isinstance(vary, Mapping) else dict.fromkeys(vary)
    return [(_named(name), *_limits(name, ends)) for name, ends in limits.items()]


def _named(name: Any) -> str:
    if not isinstance(name, str):
        raise TypeError(f"vary: {name!r}: must be the name of a parameter")
    return name


def _limits(name: str, ends: Limits) -> tuple[float | None, float | None]:
    if ends is None:
        return None, None
    if not isinstance(ends, Sequence) or len(ends) != 2:
        raise TypeError(f"vary[{name!r}] = {ends!r}: must be None or two limits, each a number or None")
    low, high = (None if end is None else _real(f"vary[{name!r}]", end) for end in ends)
    return low, high
