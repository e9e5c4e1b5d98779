# SPDX-License-Identifier: MIT
"""The compiled half. Raises ValueError and NumericalFailure."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

States = Callable[["PosedProblem", NDArray[numpy.float64]], ArrayLike]

Value = Callable[[NDArray[numpy.float64], NDArray[numpy.float64], NDArray[numpy.float64] | None], float | None]

class PosedProblem:
    orders: list[float]
    initial: list[list[float]]
    end: float
    def rhs(self, t: float, y: ArrayLike) -> NDArray[numpy.float64]: ...

class Problem:
    def __init__(
        self,
        orders: Sequence[float],
        initial: Sequence[Sequence[float]],
        rhs: Callable[..., ArrayLike],
        end: float,
        jacobian: Callable[..., ArrayLike] | None,
        names: Sequence[str],
        jumps: Sequence[float],
        delays: Sequence[float],
        before: Callable[[float], ArrayLike] | None,
    ) -> None: ...

def version() -> str: ...
def scenes() -> list[dict[str, Any]]: ...
def schemes() -> list[dict[str, Any]]: ...
def program(arguments: Sequence[str]) -> int: ...
def facts(name: str, settings: Sequence[str]) -> tuple[str, list[str], list[float], float, str]: ...
def solve(
    name: str, settings: Sequence[str], problem: Problem | None, scheme: str, given: dict[str, Any]
) -> tuple[list[str], NDArray[numpy.float64], NDArray[numpy.float64], str, dict[str, Any], list[str] | None]: ...
def choose(
    name: str, settings: Sequence[str], problem: Problem | None, error: float, norm: str, scale: str, columns: str | None, seconds: float, runs: str,
    schemes: dict[str, States], measures: dict[str, Value],
) -> dict[str, Any]: ...
def fit(
    name: str, settings: Sequence[str], names: Sequence[str], rows: Sequence[Sequence[float]],
    vary: Sequence[tuple[str, float | None, float | None]], scheme: str | None, confidence: float, budget: float
) -> dict[str, Any]: ...
def sweep(
    scenes: Sequence[tuple[str, Sequence[str]]], schemes: dict[str, States | None], measures: dict[str, Value], steps: Sequence[int],
    accuracies: Sequence[float], given: dict[str, Any], results: str | None
) -> tuple[list[dict[str, Any]], str]: ...
def exact(
    name: str, settings: Sequence[str], problem: Problem | None, times: Sequence[float]
) -> tuple[list[str], NDArray[numpy.float64], NDArray[numpy.float64]]: ...
def exact_in_digits(
    name: str, settings: Sequence[str], problem: Problem | None, times: Sequence[float], digits: int
) -> tuple[list[str], list[list[str]], list[list[str]]]: ...
def mittag_leffler(
    alpha: NDArray[numpy.float64], beta: NDArray[numpy.float64], z: NDArray[numpy.complex128]
) -> tuple[NDArray[numpy.complex128], NDArray[numpy.float64]]: ...
def mittag_leffler_in_digits(alpha: str, beta: str, re: str, im: str, digits: int) -> tuple[str, str, str]: ...
