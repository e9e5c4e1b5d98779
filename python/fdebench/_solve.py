# SPDX-License-Identifier: MIT
"""Solutions by a scheme, and which scheme to take."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._failure import DoubtfulResult
from ._scene import Problem, Scene, _integer, _known, _listed, _real, _reals, _text


class Solution(Mapping[str, NDArray[numpy.float64]]):
    """Columns at times: ``solution.times``, and ``solution["y"]`` for each name of ``solution.names``.

    ``values`` has a row for each time and a column for each name. ``cost`` has what the solve used: seconds, calls of the
    right-hand side, memory, the rate that theory expects. ``warning`` says what speaks against the numbers, "" if nothing does.
    ``events``: the name of the event at each time, where events were requested; otherwise None.

    >>> from fdebench import solve
    >>> solution = solve("relaxation", "l1", 64)
    >>> solution.names, solution.times[-1], solution.values.shape
    (['y'], 1.0, (65, 1))
    >>> solution.cost["rhs"]
    64
    """

    def __init__(self, names: list[str], times: NDArray[numpy.float64], values: NDArray[numpy.float64], warning: str, cost: dict[str, Any],
                 events: list[str] | None = None):
        self.names, self.times, self.values, self.warning = names, times, values, warning
        self.cost, self.events = cost, events

    def __getitem__(self, name: str) -> NDArray[numpy.float64]:
        if name not in self.names:
            raise KeyError(f"{name}: there are {', '.join(self.names)}")
        return self.values[:, self.names.index(name)]

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return f"Solution({', '.join(self.names)} at {len(self.times)} times)"


def solve(
    scene: str | os.PathLike[str] | Scene | Problem,
    scheme: str,
    steps: int | None = None,
    *,
    grid: str = "uniform",
    at: ArrayLike | None = None,
    every: int | None = None,
    points: int | None = None,
    accuracy: float | None = None,
    history: str = "auto",
    tolerance: float | None = None,
    budget: float = 3600.0,
    check: bool = False,
    events: bool = False,
) -> Solution:
    """Solve a scene or a problem with a scheme in so many steps.

    ``grid``: "uniform", "graded:R" with the times end (n / steps)^R, or "graded:auto" with the R that the orders ask for. ``at``:
    the grid times to return, or ``every`` K-th, or so many ``points`` from 0 to the end; default all. ``accuracy`` in place of
    steps: for schemes that choose their own. ``history``: "auto", "direct" or "exponentials". ``tolerance``: relative, of
    Newton's method and of the history weights. ``budget``: seconds after which the solve ends. ``check``: also solve with half
    the steps, and warn where that gives another result. ``events``: return the events of an equation file in place of times, with
    ``accuracy``; ``solution.events`` has their names.

    Other threads run meanwhile, and Ctrl-C ends it. Raises ValueError for what cannot be solved, NumericalFailure for a
    solve that did not come to its end; warns with DoubtfulResult.

    >>> solve("relaxation", "product_trapezoidal", 4096, grid="graded:2", at=1.0)["y"].round(7)
    array([0.4275836])
    >>> solve("pendulum", "spectral_collocation", accuracy=1e-6, points=3).times
    array([ 0., 10., 20.])
    >>> riccati = Problem(orders=[0.9], initial=[0.0], rhs=lambda t, y: 1 - y**2, end=1.0)
    >>> round(float(solve(riccati, "bdf4", 256)["y"][-1]), 6)
    0.754589
    """
    if not isinstance(scheme, str):
        raise TypeError(f"scheme = {scheme!r}: must be the id of a scheme")
    counts = {"steps": steps, "every": every, "points": points}
    numbers = {"accuracy": accuracy, "tolerance": tolerance, "budget": budget}
    given: dict[str, Any] = {name: _integer(name, value) for name, value in counts.items() if value is not None}
    given |= {name: _real(name, value) for name, value in numbers.items() if value is not None}
    given |= {"grid": _text("grid", grid), "history": _text("history", history), "check": bool(check), "events": bool(events)}
    if at is not None:
        given["at"] = _reals("at", at).ravel().tolist()
    solution = Solution(*_core.solve(*_known(scene)._posed, scheme, given))
    if solution.warning:
        warnings.warn(solution.warning, DoubtfulResult, stacklevel=2)
    return solution


def choose(
    scene: str | os.PathLike[str] | Scene | Problem,
    error: float,
    *,
    norm: str = "maximum",
    scale: str = "mixed",
    columns: str | Sequence[str] | None = None,
    seconds: float | None = None,
    runs: str | int = "many",
    schemes: Mapping[str, _core.States] | None = None,
    measures: Mapping[str, _core.Value] | None = None,
) -> dict[str, Any]:
    """The scheme, grid and number of steps to take for an accuracy, found by making runs.

    ``norm``: "maximum" over all steps, or "end". ``scale``: "absolute", "relative", "mixed", |e| / (1 + |y|), or "peak",
    |e| / max |y|. ``columns``: those that count; default all. ``seconds``: for the search; default 60. ``runs``: "1" ranks by the first run of a process, which
    computes start weights and tables, "many" by later runs. ``schemes``: schemes of one's own by their names, functions
    ``states(problem, times)`` that return y at all these times, an array of shape (len(times), unknowns); they are tried beside
    all others, on the grids that suit them. ``problem`` has ``orders``, ``initial``, ``end`` and ``rhs(t, y)``.
    ``measures``: measures of one's own by their names, functions ``value(times, values, reference)`` of arrays with a row a time and a
    column for each of the scene that return a number, or None where they do not apply; ``reference`` is None where there is none. Their
    values stand under ``measures``. Returns the fields that ``fdebench choose --json`` has: scheme,
    grid, steps, error, seconds, runner_up, ...; of a problem or a scheme of one's own ``command`` is None. Raises NumericalFailure where no
    run is within the accuracy. Solve what was found with ``solve(..., steps, grid=grid)``, or with ``accuracy=asked`` where
    ``asked`` is not None: a scheme that chooses its own steps.

    >>> answer = choose("relaxation", error=1e-4, seconds=5)
    >>> answer["error"] < 1e-4, sorted(answer)[:4]
    (True, ['accuracy', 'asked', 'command', 'error'])
    >>> def closed_form(problem, times):
    ...     return [[exp(t) * erfc(sqrt(t))] for t in times]
    >>> from math import erfc, exp, sqrt
    >>> choose("relaxation", error=1e-10, seconds=5, schemes={"closed_form": closed_form})["scheme"]
    'closed_form'
    """
    counted = None if columns is None else _text("columns", columns)
    return _core.choose(*_known(scene)._posed, _real("error", error), _text("norm", norm), _text("scale", scale),
                        counted, 60.0 if seconds is None else _real("seconds", seconds), _text("runs", runs), _functions("schemes", schemes),
                        _functions("measures", measures))


def sweep(
    scenes: Sequence[str | os.PathLike[str] | Scene],
    *,
    schemes: Sequence[str] | Mapping[str, _core.States | None] = (),
    steps: Sequence[int] = (),
    accuracies: Sequence[float] = (),
    grid: str = "uniform",
    history: str = "auto",
    tolerance: float | None = None,
    budget: float | None = None,
    repeat: int = 3,
    measures: Mapping[str, _core.Value] | None = None,
    results: str | os.PathLike[str] | None = None,
) -> list[dict[str, Any]]:
    """Measure schemes on scenes, as ``fdebench run`` does: errors of all kinds, costs and times.

    ``schemes``: ids, default all; or a mapping of names, to None for a scheme of fdebench and to a function ``states(problem, times)``
    for one of one's own, as in ``choose``. ``steps`` are taken by schemes over grids, ``accuracies`` by those that choose their steps;
    without both the cheapest runs within the errors 1e-2, ..., 1e-12 are searched. ``repeat``: how often each run is timed.
    ``measures``: as in ``choose``; their values stand beside ours, under ``values``. ``results``: a results file that the runs are added
    to; one that it has is not made again, and gets no new measure. ``fdebench report`` makes a page of the file. Returns a dictionary for
    each run, as its line of a results file: scene, scheme, steps, ending, values, time. Functions of one's own may be called from several threads.

    >>> runs = sweep(["relaxation"], schemes=["l1", "bdf2"], steps=[64, 128], measures={"last": lambda times, values, reference: values[-1, 0]})
    >>> [(run["scheme"], run["steps"], run["values"]["error_end"] < 1e-2, round(run["values"]["last"], 2)) for run in runs[:2]]
    [('l1', 64, True, 0.43), ('bdf2', 64, True, 0.43)]
    """
    named = dict(schemes) if isinstance(schemes, Mapping) else dict.fromkeys(_listed("schemes", schemes))
    _functions("schemes", {name: states for name, states in named.items() if states is not None or not isinstance(name, str)})
    given: dict[str, Any] = {"grid": _text("grid", grid), "history": _text("history", history), "repeat": _integer("repeat", repeat)}
    given |= {name: _real(name, value) for name, value in {"tolerance": tolerance, "budget": budget}.items() if value is not None}
    posed = [_known(scene)._posed for scene in _listed("scenes", scenes)]
    if not posed:
        raise ValueError("scenes = []: must be at least one scene")
    if any(problem is not None for _, _, problem in posed):
        raise TypeError("scenes: must be scenes; a problem of one's own has no line in a results file")
    runs, warning = _core.sweep([(name, settings) for name, settings, _ in posed], named, _functions("measures", measures),
                                [_integer("steps", one) for one in _listed("steps", steps)],
                                [_real("accuracies", one) for one in _listed("accuracies", accuracies)], given,
                                None if results is None else os.fspath(results))
    if warning:
        warnings.warn(warning, stacklevel=2)
    return runs


def _functions(name: str, functions: Mapping[str, Any] | None) -> dict[str, Any]:
    for key, one in (functions or {}).items():
        if not isinstance(key, str) or not callable(one):
            raise TypeError(f"{name} = {{{key!r}: {one!r}}}: must be functions by the names of the {name}")
    return dict(functions or {})
