# SPDX-License-Identifier: MIT
"""Fits from Python, held against the normal equation, and what is said of wrong arguments."""

import numpy
import pytest

import fdebench

TIMES = numpy.linspace(0.1, 1.0, 10)
DATA = {"t": TIMES, "y": fdebench.exact("relaxation", TIMES)["y"]}


def test_a_linear_parameter_solves_the_normal_equation():
    noise = 0.01 * numpy.cos(30 * TIMES)
    model, y = DATA["y"], 2.0 * DATA["y"] + noise
    made = fdebench.fit("relaxation", {"t": TIMES, "y": y, "sd_y": numpy.full(10, 0.01)}, ["y0"])
    estimate = made["parameters"][0]
    assert estimate["value"] == pytest.approx(model @ y / (model @ model), rel=1e-8)
    assert estimate["standard_error"] == pytest.approx(0.01 / numpy.sqrt(model @ model), rel=1e-4)
    assert made["chi_squared"] == pytest.approx((((y - estimate["value"] * model) / 0.01) ** 2).sum(), rel=1e-6)
    assert made["degrees_of_freedom"] == 9


def test_the_scene_of_a_fit_is_one():
    made = fdebench.fit(fdebench.Scene("relaxation", gamma=0.7), {**DATA, "y": [*DATA["y"][:-1], numpy.nan]}, {"gamma": (0.1, None), "lambda": None})
    assert made["columns"][0]["measurements"] == 9
    assert fdebench.exact(made["scene"], TIMES)["y"] == pytest.approx(DATA["y"], abs=1e-9)


@pytest.mark.parametrize("data, vary, error, text", [
    ({"y": [1.0]}, ["gamma"], ValueError, "data: must have the times 't'"),
    ({"t": [1.0, 2.0], "y": [1.0]}, ["gamma"], ValueError, "as many as there are times"),
    ({"t": [numpy.nan, 1.0], "y": [1.0, 1.0]}, ["gamma"], ValueError, "row 1: t = nan"),
    ({"t": [-1.0, 1.0], "y": [1.0, 1.0]}, ["gamma"], ValueError, "row 1: t = -1"),
    ({"t": [0.5, 0.4], "y": [1.0, 1.0]}, ["gamma"], ValueError, "row 2: t = 0.4: must be at least 0.5"),
    ([1.0], ["gamma"], TypeError, "data = "),
    (DATA, "gamma", TypeError, "vary = 'gamma'"),
    (DATA, [3], TypeError, "vary: 3: must be the name"),
    (DATA, {"gamma": 5}, TypeError, "must be None or two limits"),
    (DATA, {"gamma": (0,)}, TypeError, "must be None or two limits"),
    (DATA, [], ValueError, "vary = : must be one parameter at least"),
    (DATA, ["gama"], ValueError, "did you mean 'gamma'"),
])  # fmt: skip
def test_wrong_arguments_are_named(data, vary, error, text):
    with pytest.raises(error, match=None) as raised:
        fdebench.fit("relaxation", data, vary)
    assert text in str(raised.value)


def test_what_is_not_determined_is_a_numerical_failure():
    with pytest.raises(fdebench.NumericalFailure, match="do not determine beta"):
        fdebench.fit("pendulum:nu=0", {"t": TIMES, "phi": fdebench.exact("pendulum:nu=0", TIMES)["phi"]}, ["lambda", "beta"])
