# SPDX-License-Identifier: MIT
"""What is known of solutions and functions, held against mpmath and formulas."""

import json
import math
import subprocess
from pathlib import Path

import mpmath
import numpy
import pytest
from conftest import FDEBENCH

import fdebench


def series(alpha, beta, z, digits=40):
    """sum_k z^k / Gamma(alpha k + beta) by mpmath."""
    with mpmath.workdps(2 * digits + 20):
        return mpmath.nsum(lambda k: mpmath.mpmathify(z) ** int(k) * mpmath.rgamma(alpha * k + beta), [0, mpmath.inf], method="d")


@pytest.mark.parametrize("alpha, beta, z", [(0.5, 1, -1), (0.75, 0.5, 1.5 + 0.5j), (1.5, 2, -3.25), (2, 1, 4)])
def test_mittag_leffler_is_its_series(alpha, beta, z):
    value, bound = fdebench.mittag_leffler(alpha, beta, z, bounds=True)
    error = abs(mpmath.mpmathify(value.item()) - series(alpha, beta, z))
    assert error <= bound
    assert bound <= 7 * 2**-52 * abs(value)


def test_mittag_leffler_takes_arrays_as_numpy_does():
    """E_1 is the exponential function, E_2(-z^2) the cosine."""
    z = numpy.linspace(-2, 2, 12).reshape(3, 4)
    assert fdebench.mittag_leffler(1, 1, z) == pytest.approx(numpy.exp(z), rel=1e-15)
    both = fdebench.mittag_leffler([[1.0], [2.0]], 1, [-1.0, -4.0])
    assert both == pytest.approx(numpy.array([[math.exp(-1), math.exp(-4)], [math.cos(1), math.cos(2)]]), rel=1e-14)
    assert both.dtype == float
    on_circle = numpy.exp(1j * z)
    assert fdebench.mittag_leffler(1, 1, on_circle) == pytest.approx(numpy.exp(on_circle), rel=1e-15)


def test_digits_are_what_mpmath_reads():
    x = fdebench.mittag_leffler_digits("0.5", 1, "-1", 40)
    with mpmath.workdps(60):
        error = abs(mpmath.mpc(x.re, x.im) - mpmath.e * mpmath.erfc(1))
        assert error <= mpmath.mpf(x.bound) < mpmath.mpf("1e-39")


def test_arguments_of_digits_are_taken_at_their_word():
    """E_1(0.1) of one tenth and of the double next to it, which differ in the 17th digit."""
    assert fdebench.mittag_leffler_digits(1, 1, "0.1", 25).re == fdebench.mittag_leffler_digits(1, 1, 0.1, 25).re
    with mpmath.workdps(40):
        value = fdebench.mittag_leffler_digits(1, 1, "0.1", 25)
        assert abs(mpmath.mpf(value.re) - mpmath.exp(mpmath.mpf(1) / 10)) < 1e-24


def test_an_exact_solution_has_bounds_that_hold():
    """E_0.5(-sqrt(t)) = e^t erfc(sqrt(t)), at times in any order."""
    times = [1.0, 0.25, 4.0, 1.0]
    known = fdebench.exact("relaxation:gamma=0.5,lambda=-1,y0=1", times)
    with mpmath.workdps(30):
        for t, value, bound in zip(times, known["y"], known.bounds["y"]):
            assert abs(mpmath.exp(t) * mpmath.erfc(mpmath.sqrt(t)) - mpmath.mpf(value)) <= bound < 1e-15
    assert list(known.times) == times


def test_an_exact_solution_in_digits():
    known = fdebench.exact("relaxation:gamma=0.5,lambda=-1,y0=1", 1.0, digits=40)
    with mpmath.workdps(60):
        error = abs(mpmath.mpf(known["y"][0]) - mpmath.e * mpmath.erfc(1))
        assert error <= mpmath.mpf(known.bounds["y"][0])


def test_two_methods_know_a_problem_of_ones_own():
    """D^0.5 y = Gamma(3)/Gamma(2.5) t^1.5 + t^4 - y^2 from 0 is t^2."""
    problem = fdebench.Problem([0.5], [0.0], lambda t, y: 2 / math.gamma(2.5) * t**1.5 + t**4 - y**2, 1.0)
    known = fdebench.exact(problem, [0.5, 1.0])
    assert numpy.all(numpy.abs(known["y"] - numpy.array([0.25, 1.0])) <= known.bounds["y"])
    assert numpy.all(known.bounds["y"] < 1e-12)
    with pytest.raises(ValueError):
        fdebench.exact(problem, 2.0)


def test_choose_returns_what_the_command_prints():
    chosen = fdebench.choose("relaxation", 1e-3, norm="end", seconds=10)
    printed = subprocess.run(
        [FDEBENCH, "choose", "relaxation", "--error", "1e-3", "--norm", "end", "--max-time", "10", "--json"],
        capture_output=True, text=True, check=True,
    )
    # A winner with start weights has once_seconds; close schemes take turns at winning.
    assert chosen.keys() ^ json.loads(printed.stdout).keys() <= {"once_seconds"}
    assert chosen["error"] <= 1e-3


def test_choose_answers_for_a_problem_of_ones_own():
    problem = fdebench.Problem([0.5], [1.0], lambda t, y: -y, 1.0)
    chosen = fdebench.choose(problem, 1e-3, norm="end", scale="absolute", seconds=10)
    if chosen["asked"] is None:
        solution = fdebench.solve(problem, chosen["scheme"], chosen["steps"], grid=chosen["grid"])
    else:
        solution = fdebench.solve(problem, chosen["scheme"], accuracy=chosen["asked"])
    assert abs(solution["y"][-1] - math.e * math.erfc(1)) <= 1e-3
    assert chosen["command"] is None


@pytest.mark.parametrize("file", sorted((Path(__file__).parents[2] / "docs/examples/kinds").glob("*.toml")), ids=lambda file: file.stem)
def test_every_kind_of_equation_is_solved_and_known(file):
    scene = fdebench.Scene(file)
    known = fdebench.exact(scene, scene.end)
    solution = fdebench.solve(scene, "radau_exponentials", accuracy=1e-6, at=[scene.end])
    assert abs(solution[scene.columns[0]][-1] - known[scene.columns[0]][-1]) <= 1e-5


def test_a_problem_of_ones_own_may_have_delays():
    """D^0.8 y(t) = -1.5 y(t - 1), y = 1 up to 0: sum over k < t + 1 of (-1.5)^k (t - k + 1)^(0.8 k) / Gamma(0.8 k + 1)."""
    problem = fdebench.Problem(
        [0.8], [1.0], lambda t, y, past: -1.5 * past[0], 3.0, delays=[1.0], before=lambda t: [1.0],
        jacobian=lambda t, y, past: [[0.0 * past[0, 0]]],
    )
    right = sum((-1.5) ** k * (4 - k) ** (0.8 * k) / math.gamma(0.8 * k + 1) for k in range(4))
    known = fdebench.exact(problem, 3.0)
    assert abs(known["y"][0] - right) <= known.bounds["y"][0] + 1e-15 < 1e-11
    assert abs(fdebench.solve(problem, "bdf2", 512)["y"][-1] - right) < 1e-4
    assert fdebench.choose(problem, 1e-3, norm="end", seconds=10)["error"] <= 1e-3


def test_what_cannot_be_known_is_a_numerical_failure():
    """D y = y^2 from 1 is infinite at 1."""
    square = fdebench.Problem([1.0], [1.0], lambda t, y: y**2, 3.0)
    with pytest.raises(fdebench.NumericalFailure):
        fdebench.exact(square, 2.0)


@pytest.mark.parametrize(
    "wrong, message",
    [
        (lambda: fdebench.mittag_leffler(6, 1, 1), "alpha = 6"),
        (lambda: fdebench.mittag_leffler_digits("one", "1", "1", 20), "alpha"),
        (lambda: fdebench.exact("relaxation", -1.0), "^times = -1: must be a finite number of at least 0$"),
        (lambda: fdebench.exact("fractional_extremum", 2.0), r"^times = 2: must be in \[0, 1\]"),
        (lambda: fdebench.exact("relaxation", 1.0, digits=0), "^digits = 0: must be a whole number"),
        (lambda: fdebench.exact("pendulum", 1.0, digits=20), "^digits = 20: scene pendulum has no exact solution in digits"),
        (lambda: fdebench.choose("relaxation", 2.0), "^error = 2: must be"),
        (lambda: fdebench.choose("relaxation", 1e-3, norm="sum"), "^norm = sum: must be"),
        (lambda: fdebench.choose("relaxation", 1e-3, columns=["z"]), "^columns = z: must be of y$"),
        (lambda: fdebench.choose("relaxation", 1e-3, columns=[]), "^columns = : must be of y$"),
        (lambda: fdebench.choose("relaxation", 1e-3, seconds=-1), "^seconds = -1: must be"),
        (lambda: fdebench.choose("relaxation", 1e-3, runs=2), "^runs = 2: must be 1 or many$"),
    ],
)
def test_bad_input_is_a_value_error(wrong, message):
    with pytest.raises(ValueError, match=message):
        wrong()


def test_lists_are_those_of_the_command():
    assert {scene.id for scene in fdebench.scenes()} == {facts["id"] for facts in fdebench.scene_facts()}
    assert "pendulum" in {scene.id for scene in fdebench.scenes()}
    needs = {scheme.id: scheme.needs for scheme in fdebench.schemes()}
    assert needs["l1"]["implicit"] and not needs["adams_pc"]["implicit"]
    assert fdebench.Scene("pendulum").columns == ["phi", "Dbeta_phi", "dphi", "Dalpha_phi"]
