# SPDX-License-Identifier: MIT
"""What is known of solutions, and the functions that it is made of."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._scene import Problem, Scene, _integer, _known, _reals


class Exact(Mapping[str, NDArray]):
    """Known columns at times, ``exact["y"]``, each with a bound of its absolute error, ``exact.bounds["y"]``.

    Energies, constraints and reactions have none. With digits, columns and bounds hold decimal texts, which mpmath reads.

    >>> known = exact("relaxation", [0.5, 1.0])
    >>> list(known), known.times, known["y"]
    (['y'], array([0.5, 1. ]), array([0.52315658, 0.42758358]))
    >>> bool((known.bounds["y"] < 1e-15).all())
    True
    """

    def __init__(self, times: NDArray[numpy.float64], columns: dict[str, NDArray], bounds: dict[str, NDArray]):
        self.times, self.bounds, self._columns = times, bounds, columns

    def __getitem__(self, name: str) -> NDArray:
        if name not in self._columns:
            raise KeyError(f"{name}: there are {', '.join(self._columns)}")
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        return f"Exact({', '.join(self)} at {len(self.times)} times)"


def exact(scene: str | os.PathLike[str] | Scene | Problem, times: ArrayLike, *, digits: int | None = None) -> Exact:
    """What is known of a scene at these times, whatever solves it.

    Linear scenes have formulas with proved bounds, to any number of digits; for others, and for a problem of one's own, two methods
    that share nothing are compared, and the bound is an estimate. Raises NumericalFailure where there is nothing to be known,
    ValueError for times before 0 or beyond a problem.

    >>> exact("relaxation", 1.0)["y"]
    array([0.42758358])
    >>> exact("relaxation", 1.0, digits=30)["y"][0]
    '0.427583576155807004410750344491'
    """
    requested = numpy.atleast_1d(_reals("times", times))
    if requested.ndim != 1 or requested.size == 0:
        raise ValueError(f"times: must be a list of numbers, not of shape {requested.shape}")
    posed = _known(scene)._posed
    if digits is None:
        names, values, bounds = _core.exact(*posed, requested.tolist())
    else:
        names, *texts = _core.exact_in_digits(*posed, requested.tolist(), _integer("digits", digits))
        values, bounds = (numpy.array(rows, dtype=object) for rows in texts)
    columns = {name: values[:, i] for i, name in enumerate(names)}
    return Exact(requested, columns, {name: bounds[:, i] for i, name in enumerate(names[: bounds.shape[1]])})


def mittag_leffler(
    alpha: ArrayLike, beta: ArrayLike, z: ArrayLike, *, bounds: bool = False
) -> NDArray | tuple[NDArray, NDArray[numpy.float64]]:
    """E_{alpha,beta}(z) = sum_k z^k / Gamma(alpha k + beta), with NumPy's broadcasting.

    ``alpha`` in (0, 5], ``beta`` real, ``z`` real or complex; real z give real values. Each argument is the double that it is: 0.1
    is not one tenth. With ``bounds`` also bounds of the absolute errors, at most 7 ulp and nearly always half an ulp. Values
    beyond double are inf. Raises ValueError for parameters outside these ranges, TypeError for what are no numbers.

    >>> mittag_leffler(0.5, 1, [0.0, -1.0])
    array([1.        , 0.42758358])
    """
    points = numpy.asarray(z)
    if points.dtype.kind not in "iufc":
        raise TypeError(f"z = {z!r}: must be numbers")
    a, b, x = numpy.broadcast_arrays(_reals("alpha", alpha), _reals("beta", beta), points)
    value, bound = _core.mittag_leffler(a.ravel(), b.ravel(), x.astype(complex).ravel())
    value = (value if numpy.iscomplexobj(points) else value.real).reshape(x.shape)[()]
    return (value, bound.reshape(x.shape)[()]) if bounds else value


class Digits(NamedTuple):
    """A complex number and a bound of its error as decimal texts: ``mpmath.mpc(x.re, x.im)``.

    >>> x = mittag_leffler_digits("0.5", "1", 1j, 20)
    >>> x.re, x.im
    ('0.36787944117144232160', '0.60715770584139372912')
    """

    re: str
    im: str
    bound: str


def mittag_leffler_digits(alpha: float | str, beta: float | str, z: complex | str, digits: int) -> Digits:
    """E_{alpha,beta}(z) to a number of decimal digits.

    Arguments are texts, taken at their word ("0.1" is one tenth), or numbers, taken for the shortest decimals that name them.
    Raises ValueError for a parameter outside its range.

    >>> mittag_leffler_digits("0.5", "1", "-1", 30).re
    '0.427583576155807004410750344491'
    """
    if isinstance(z, str):
        re, im = z, "0"
    else:
        re, im = repr(float(numpy.real(z))), repr(float(numpy.imag(z)))
    return Digits(*_core.mittag_leffler_in_digits(_decimal(alpha), _decimal(beta), re, im, digits))


def _decimal(number: float | str) -> str:
    return number if isinstance(number, str) else repr(float(number))
