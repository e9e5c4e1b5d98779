# SPDX-License-Identifier: MIT
"""Scenes and problems of one's own."""

from __future__ import annotations

import math
import numbers
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _core

Value = Union[float, str, Sequence[float]]


def _real(name: str, value: Any) -> float:
    """A real number, of Python, of NumPy or in an array of one; complex numbers, None and others are a TypeError."""
    array = numpy.asarray(value)
    if array.size != 1 or array.dtype.kind not in "iuf" and not isinstance(value, numbers.Real):
        raise TypeError(f"{name} = {value!r}: must be a real number")
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{name} = {value}: must be a number in the range of double") from None


def _reals(name: str, values: Any) -> NDArray[numpy.float64]:
    """Real numbers, as an array of any shape."""
    array = numpy.asarray(values)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} = {values!r}: must be real numbers")
    return array.astype(float)


def _integer(name: str, value: Any) -> int:
    """A whole number that an int of the compiled half holds."""
    if isinstance(value, numpy.ndarray) and value.ndim == 0:
        value = value.item()
    if not isinstance(value, numbers.Integral):
        raise TypeError(f"{name} = {value!r}: must be a {'whole' if isinstance(value, numbers.Real) else 'real'} number")
    if abs(value) >= 2**31:
        raise ValueError(f"{name} = {value}: must be below 2^31 in size")
    return int(value)


def _text(name: str, value: Value) -> str:
    """As the command takes it: numbers in the fewest digits that tell them from all others, lists with commas."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, numpy.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (Sequence, numpy.ndarray)):
        return ",".join(_text(name, one) for one in value)
    return str(int(value)) if isinstance(value, numbers.Integral) else repr(_real(name, value))


def _listed(name: str, values: Any) -> list[Any]:
    """The entries of a list, tuple or array; a number or a text alone is a TypeError."""
    if isinstance(values, (str, bytes, Mapping)) or not hasattr(values, "__len__") or getattr(values, "ndim", 1) == 0:
        raise TypeError(f"{name} = {values!r}: must be a list")
    return list(values)


class _Posed:
    """What is known of a scene and of a problem alike."""

    _columns: Sequence[str]
    _orders: Sequence[float]
    _end: float
    _posed: tuple[str, list[str], _core.Problem | None]  # name and settings of a scene, or a problem: as _core takes them

    @property
    def columns(self) -> list[str]:
        """The names of what a solve gives at each time; energies, constraints and reactions come behind them."""
        return list(self._columns)

    @property
    def orders(self) -> list[float]:
        """The order of the derivative in each row of its problem; 0 of an algebraic row."""
        return list(self._orders)

    @property
    def end(self) -> float:
        """The last time."""
        return self._end


class Scene(_Posed):
    """A scene that fdebench knows, with some of its parameters replaced.

    >>> Scene("pendulum", alpha=1.9, until=5)
    Scene('pendulum:alpha=1.9,until=5')
    >>> Scene("relaxation", {"lambda": -2}).columns
    ['y']

    ``until`` is the end of the time interval. Names are those of the command; parameters that are no Python names stand
    in a mapping, or in the text: ``Scene("relaxation:lambda=-2")``. Raises ValueError naming what is wrong and what is allowed.
    """

    def __init__(self, name: str | os.PathLike[str], parameters: Mapping[str, Value] | None = None, /, **more: Value):
        if not isinstance(name, (str, os.PathLike)):
            raise TypeError(f"scene = {name!r}: must be the name of a scene or a file")
        if not isinstance(parameters, (Mapping, type(None))):
            raise TypeError(f"parameters = {parameters!r}: must be a mapping, as in Scene('relaxation', {{'gamma': 0.5}})")
        self._name = os.fspath(name)
        self._settings = [f"{key}={_text(key, value)}" for key, value in {**(parameters or {}), **more}.items()]
        self._posed = (self._name, self._settings, None)
        self._id, self._columns, self._orders, self._end, self._note = _core.facts(self._name, self._settings)

    @property
    def id(self) -> str:
        """Its name without parameters."""
        return self._id

    @property
    def note(self) -> str:
        """What the scene changes of its file: how far ``initial_velocity="projected"`` moves each velocity. "" if nothing."""
        return self._note

    @property
    def label(self) -> str:
        """Its name with the parameters that were replaced."""
        if not self._settings:
            return self._name
        return self._name + (":" if self._name == self._id else ",") + ",".join(self._settings)

    def __repr__(self) -> str:
        return f"Scene({self.label!r})"


Rhs = Callable[[float, NDArray[numpy.float64]], ArrayLike]
DelayedRhs = Callable[[float, NDArray[numpy.float64], NDArray[numpy.float64]], ArrayLike]


class Problem(_Posed):
    """A problem of one's own: D^orders[i] y_i = rhs(t, y)[i] for 0 < t <= end, with Caputo derivatives.

    >>> Problem(orders=[0.5], initial=[1.0], rhs=lambda t, y: -y, end=1.0)
    Problem(orders=[0.5], end=1.0)

    ``initial[i]`` are y_i(0), y_i'(0), ...: as many numbers as the order rounded up, or one number where that is 1. Order 0 is an
    algebraic row, 0 = rhs(t, y)[i], whose initial value is a guess. ``rhs`` gets a float and an array and returns as many numbers;
    ``jacobian``, if given, returns the matrix of their derivatives, row i those of rhs[i]: without it implicit schemes take
    differences. ``jumps`` are times at which rhs jumps.

    ``delays``, increasing, give rhs and jacobian a third argument ``past``, an array whose row k is y(t - delays[k]); ``before`` is a
    function of t with y(t) for t < 0.

    >>> Problem(orders=[0.8], initial=[1.0], rhs=lambda t, y, past: -past[0], end=3.0, delays=[1.0], before=lambda t: [1.0])
    Problem(orders=[0.8], end=3.0)

    ``exact`` and ``choose`` compute a reference by two methods that share nothing; it is kept with the problem. Raises ValueError
    and TypeError naming the argument, its value and what is allowed; exceptions of ``rhs`` pass through a solve.
    """

    def __init__(
        self,
        orders: Sequence[float],
        initial: Sequence[float | Sequence[float]],
        rhs: Rhs | DelayedRhs,
        end: float,
        *,
        jacobian: Rhs | DelayedRhs | None = None,
        names: Sequence[str] | None = None,
        jumps: Sequence[float] = (),
        delays: Sequence[float] = (),
        before: Callable[[float], ArrayLike] | None = None,
    ):
        self._orders = [_order(order) for order in _listed("orders", orders)]
        initial = _listed("initial", initial)
        if not self._orders or len(initial) != len(self._orders):
            raise ValueError(f"initial: has {len(initial)} entries for {len(self._orders)} orders, must have one for each")
        values = [_initial(i, order, initial[i]) for i, order in enumerate(self._orders)]
        self._end = _positive("end", end)
        self._columns = _listed("names", names) if names is not None else _usual_names(len(self._orders))
        if len(set(self._columns)) != len(self._orders) or not all(isinstance(name, str) for name in self._columns):
            raise ValueError(f"names = {self._columns}: must be {len(self._orders)} different names")
        times, lags = _increasing("jumps", jumps), _increasing("delays", delays)
        arguments = "t, y and past" if lags else "t and y"
        for name, function in {"rhs": rhs, "jacobian": jacobian}.items():
            if not callable(function) and (name == "rhs" or function is not None):
                raise ValueError(f"{name} = {function!r}: must be a function of {arguments}")
        if callable(before) != bool(lags):
            raise ValueError(f"before = {before!r}: must be {'a function of t' if lags else 'None without delays'}")
        self._posed = ("", [], _core.Problem(self._orders, values, rhs, self._end, jacobian, self._columns, times, lags, before))

    def __repr__(self) -> str:
        return f"Problem(orders={self._orders}, end={self._end})"


def _order(order: float) -> float:
    if not 0.0 <= _real("orders", order) <= 2.0:
        raise ValueError(f"orders = {order}: must be a number in [0, 2]")
    return float(order)


def _initial(row: int, order: float, given: float | Sequence[float]) -> list[float]:
    values = _reals(f"initial[{row}]", given).ravel().tolist()
    wanted = max(1, math.ceil(order))
    if len(values) != wanted or not all(map(math.isfinite, values)):
        raise ValueError(f"initial[{row}] = {given}: must be {wanted} finite number{'s' * (wanted > 1)} for order {order}")
    return values


def _positive(name: str, value: float) -> float:
    if not (_real(name, value) > 0.0 and math.isfinite(value)):
        raise ValueError(f"{name} = {value}: must be a number above 0")
    return float(value)


def _increasing(name: str, given: Sequence[float]) -> list[float]:
    times = [_positive(name, time) for time in _listed(name, given)]
    if times != sorted(set(times)):
        raise ValueError(f"{name} = {times}: must increase")
    return times


def _usual_names(count: int) -> list[str]:
    return ["y"] if count == 1 else [f"y{i + 1}" for i in range(count)]


@dataclass(frozen=True)
class Scheme:
    """A scheme, and what it takes; ``needs`` are the facts that ``fdebench schemes --needs`` shows.

    >>> schemes()[0].title
    'Fractional Adams predictor-corrector'
    >>> schemes()[0].needs["implicit"]
    False
    """

    id: str
    title: str
    source: str
    needs: dict[str, Any]


def scenes() -> list[Scene]:
    """All scenes, with their default parameters.

    >>> scenes()[0]
    Scene('relaxation')
    """
    return [Scene(facts["id"]) for facts in scene_facts()]


def scene_facts() -> list[dict[str, Any]]:
    """Title, source, parameters with what is allowed, end and columns of all scenes, as ``fdebench scenes --json`` has them.

    >>> scene_facts()[0]["title"]
    'Fractional relaxation'
    """
    return _core.scenes()


def schemes() -> list[Scheme]:
    """All schemes.

    >>> [scheme.id for scheme in schemes() if not scheme.needs["takes_grid"]]
    ['spectral_collocation', ...]
    """
    return [Scheme(facts.pop("id"), facts.pop("title"), facts.pop("source"), facts) for facts in _core.schemes()]


def _known(scene: str | os.PathLike[str] | Scene | Problem) -> Scene | Problem:
    return scene if isinstance(scene, (Scene, Problem)) else Scene(scene)
