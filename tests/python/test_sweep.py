# SPDX-License-Identifier: MIT
"""Sweeps with schemes and measures of one's own: values against formulas, and the words for what is wrong."""

import json
import math

import fdebench
import pytest


def closed_form(problem, times):
    """E_{1/2}(-t^{1/2}) = e^t erfc(t^{1/2}), which solves the relaxation."""
    return [[math.exp(t) * math.erfc(math.sqrt(t))] for t in times]


def distance(times, values, reference):
    """error_end."""
    return abs(values[-1, 0] - reference[-1, 0])


def test_measures_schemes_of_ones_own_beside_ours(tmp_path):
    file = tmp_path / "runs.jsonl"
    asked = {"schemes": {"mine": closed_form, "l1": None}, "steps": [16, 32], "measures": {"distance": distance}, "repeat": 1, "results": file}
    runs = fdebench.sweep(["relaxation"], **asked)
    assert len(runs) == 4
    for run in runs:
        assert run["values"]["distance"] == run["values"]["error_end"]
        assert run["time"]["time_minimum"] > 0
        assert (run["values"]["error_maximum"] < 1e-15) == (run["scheme"] == "mine")
    lines = [json.loads(line) for line in file.read_text().splitlines()]
    assert sum("values" in line for line in lines) == 4
    assert fdebench.sweep([fdebench.Scene("relaxation")], **asked) == runs


def test_returns_scenes_in_their_order(tmp_path):
    """A run that the file has comes as it was."""
    scenes = ["pendulum", "relaxation", "linear_system"]
    asked = {"schemes": ["l1", "bdf2"], "steps": [16], "repeat": 1, "results": tmp_path / "runs.jsonl"}
    first, second = fdebench.sweep(scenes, **asked), fdebench.sweep(scenes, **asked)
    assert [(run["scene"], run["scheme"]) for run in first] == [(scene, scheme) for scene in scenes for scheme in ("l1", "bdf2")]
    assert first == second


def test_takes_all_schemes_by_default():
    runs = fdebench.sweep(["power"], steps=[4], accuracies=[1e-2], repeat=1)
    assert {run["scheme"] for run in runs} == {scheme.id for scheme in fdebench.schemes()}


def test_passes_exceptions_of_functions_on():
    with pytest.raises(ZeroDivisionError):
        fdebench.sweep(["relaxation"], schemes={"bad": lambda problem, times: 1 / 0}, steps=[4])
    with pytest.raises(ZeroDivisionError):
        fdebench.sweep(["relaxation"], schemes=["l1"], steps=[4], measures={"bad": lambda *_: 1 / 0})


def test_chooses_with_measures():
    last = {"last": lambda times, values, reference: values[-1, 0]}
    answer = fdebench.choose("relaxation", error=1e-6, seconds=5, measures=last)
    assert answer["measures"]["last"] == pytest.approx(math.e * math.erfc(1), abs=2e-6)


@pytest.mark.parametrize(
    "given, message",
    [
        ({"steps": [0]}, "steps = 0: must be a whole number from 1 to 1000000000"),
        ({"accuracies": [-1.0], "steps": []}, "accuracies = -1: must be a finite number above 0"),
        ({"repeat": 0}, "repeat = 0: must be a whole number from 1 to 1000"),
        ({"budget": 0.0}, "budget = 0: must be a finite number above 0"),
        ({"grid": "curved"}, "grid = curved: must be uniform or graded:R"),
        ({"schemes": ["l11"]}, "scheme l11: no such scheme, did you mean 'l1'?"),
        ({"schemes": {"l1": closed_form}}, "schemes = l1: must be an id that prints and that no other scheme has"),
        ({"measures": {"error_end": distance}}, "measures = error_end: must be a word"),
    ],
)
def test_names_the_argument(given, message):
    with pytest.raises(ValueError) as refusal:
        fdebench.sweep(["relaxation"], **{"steps": [4], **given})
    assert str(refusal.value).startswith(message)


def test_refuses_what_is_no_function_or_scene():
    with pytest.raises(ValueError, match="measure size: returned .* must be real numbers"):
        fdebench.sweep(["relaxation"], schemes=["l1"], steps=[4], measures={"size": lambda *_: "large"})
    with pytest.raises(TypeError, match="schemes = "):
        fdebench.sweep(["relaxation"], schemes=[3], steps=[4])
    with pytest.raises(ValueError, match="scenes = "):
        fdebench.sweep([], steps=[4])
    with pytest.raises(TypeError, match="measures = "):
        fdebench.sweep(["relaxation"], steps=[4], measures={"size": 3})
    with pytest.raises(TypeError, match="scenes: must be scenes"):
        fdebench.sweep([fdebench.Problem(orders=[0.5], initial=[1.0], rhs=lambda t, y: -y, end=1.0)], steps=[4])
