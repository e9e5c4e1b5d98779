# SPDX-License-Identifier: MIT
"""Solves from Python, held against formulas and against the command."""

import csv
import fractions
import io
import math
import pathlib
import random
import subprocess
import warnings

import numpy
import pytest
from conftest import FDEBENCH

import fdebench


def relaxation(**more):
    return fdebench.Problem(orders=[0.5], initial=[1.0], rhs=lambda t, y: -y, end=1.0, **more)


def test_a_scene_has_the_columns_of_the_command_to_the_last_bit():
    solution = fdebench.solve(fdebench.Scene("pendulum", until=5), "decoupled_multi_order", 512)
    printed = subprocess.run(
        [FDEBENCH, "solve", "pendulum", "--until", "5", "--scheme", "decoupled_multi_order", "--steps", "512"],
        capture_output=True, text=True, check=True,
    )
    names, *rows = csv.reader(io.StringIO(printed.stdout))
    assert ["t", *solution.names] == names
    assert numpy.array_equal(numpy.column_stack([solution.times, solution.values]), numpy.array(rows, dtype=float))


def test_a_file_is_a_scene(tmp_path):
    """D^0.5 y = -a y from 1 is e^(a^2 t) erfc(a sqrt(t)); the file may change between two calls."""
    file = tmp_path / "mine.toml"
    text = 'end = 1\n[parameters]\na = {}\n[unknown.y]\norder = 0.5\nrhs = "-a*y"\ninitial = [1]\n'
    for a in (1.0, 2.0):
        file.write_text(text.format(a))
        solution = fdebench.solve(str(file), "product_trapezoidal", 1024, grid="graded:2")
        exact = math.exp(a * a) * math.erfc(a)
        assert abs(solution["y"][-1] - exact) < 1e-6
        assert abs(fdebench.exact(fdebench.Scene(str(file), a=a), [1.0])["y"][0] - exact) < 1e-15
    with pytest.raises(ValueError, match=r"mine.toml: line 3, column 5: a: "):
        file.write_text(text.format('"b"'))
        fdebench.solve(str(file), "l1", 8)


def test_initial_velocities_are_projected_onto_a_constraint(tmp_path):
    """Of masses 1 and 3 under x' + 2 y' = 0: v - M^-1 a (a.v)/(a M^-1 a) with a = (1, 2), a M^-1 a = 7/3."""
    file = tmp_path / "masses.toml"
    file.write_text(
        'end = 1\n[coordinate.x]\ninitial = [0, 0.333333]\n[coordinate.y]\ninitial = [0, -0.166667]\n[mechanics]\n'
        'lagrangian = "(D(x,1)^2 + 3*D(y,1)^2)/2 - x^2"\nconstraints = ["D(x,1) + 2*D(y,1)"]\n'
    )
    with pytest.raises(ValueError, match="set initial_velocity=projected takes it"):
        fdebench.solve(fdebench.Scene(file), "l1", 8)
    scene = fdebench.Scene(file, initial_velocity="projected")
    assert scene.note.endswith("D(x,1) by 4.29e-07, D(y,1) by 2.86e-07")
    defect = (0.333333 - 2 * 0.166667) * 3 / 7
    start = fdebench.solve(scene, "l1", 64, at=0)
    assert start["D(x,1)"][0] == pytest.approx(0.333333 - defect, abs=1e-16)
    assert start["D(y,1)"][0] == pytest.approx(-0.166667 - 2 / 3 * defect, abs=1e-16)
    assert fdebench.Scene("pendulum").note == ""


def test_a_problem_of_ones_own_has_its_solution():
    """D^0.5 y = -y from 1 is e^t erfc(sqrt(t))."""
    solution = fdebench.solve(relaxation(), "product_trapezoidal", 2048, grid="graded:2")
    exact = [math.exp(t) * math.erfc(math.sqrt(t)) for t in solution.times]
    assert numpy.max(numpy.abs(solution["y"] - exact)) < 1e-6


def test_a_jacobian_of_python_saves_calls_and_changes_no_result():
    given = relaxation(jacobian=lambda t, y: [[-1.0]])
    with_jacobian, without = (fdebench.solve(problem, "l1", 64) for problem in (given, relaxation()))
    assert with_jacobian.cost["rhs"] < without.cost["rhs"]
    assert with_jacobian["y"] == pytest.approx(without["y"], rel=1e-13)


def test_a_jacobian_has_the_derivatives_of_an_equation_in_its_row():
    """u' = v, v' = -u from (1, 0) is a circle. A transposed matrix would not let Newton's method converge."""
    circle = fdebench.Problem(
        [1, 1], [1, 0], lambda t, y: [y[1], -y[0] + 2 * y[1] * 0], 1.0, jacobian=lambda t, y: [[0, 1], [-1, 0]], names=["u", "v"]
    )
    solution = fdebench.solve(circle, "product_trapezoidal", 1024, at=[0.5, 1.0])
    assert solution["u"] == pytest.approx(numpy.cos([0.5, 1.0]), abs=1e-6)
    assert solution["v"] == pytest.approx(-numpy.sin([0.5, 1.0]), abs=1e-6)


def test_times_are_those_asked_for():
    assert list(fdebench.solve("relaxation", "l1", 8, at=[1.0, 0.5]).times) == [0.5, 1.0]
    assert list(fdebench.solve("relaxation", "l1", 8, points=3).times) == [0.0, 0.5, 1.0]
    assert len(fdebench.solve("relaxation", "l1", 8).times) == 9


def test_numbers_of_numpy_are_numbers():
    scene = fdebench.Scene("multi_term", alpha=numpy.array([1.2, 1.6]), c=numpy.float64(0.5))
    assert scene.label == "multi_term:alpha=1.2,1.6,c=0.5"
    assert len(fdebench.solve(scene, "l1", numpy.int64(512)).times) == 513


def test_a_label_with_its_parameters_names_the_same_scene(tmp_path):
    folder = tmp_path / "a:b"
    folder.mkdir()
    file = folder / "growth.toml"
    file.write_text("end = 1.0\n[unknown.y]\nterms = [[1.0, 0.5]]\nrhs = \"-y\"\ninitial = [1.0]\n")
    for name in [str(file), "relaxation", "relaxation:gamma=0.3"]:
        scene = fdebench.Scene(name, until=2)
        assert fdebench.Scene(scene.label).label == scene.label
        assert fdebench.Scene(scene.label).end == 2


def test_the_cost_is_that_of_the_run():
    assert fdebench.solve("relaxation", "grunwald_letnikov", 100).cost["rhs"] >= 100


def test_a_doubtful_result_is_warned_of():
    """A step of the explicit scheme is far outside its region of stability."""
    with pytest.warns(fdebench.DoubtfulResult):
        solution = fdebench.solve("relaxation:lambda=-200", "adams_pc", 64)
    assert solution.warning
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fdebench.solve("relaxation", "l1", 64)


@pytest.mark.parametrize(
    "wrong, message",
    [
        (lambda: fdebench.solve("pendulun", "l1", 8), "scene pendulun: no such scene, did you mean 'pendulum'"),
        (lambda: fdebench.solve("pendulum", "l2", 8), "scheme l2: no such scheme"),
        (lambda: fdebench.solve("pendulum", "l1", 0), r"^steps = 0: must be"),
        (lambda: fdebench.solve("pendulum", "l1"), "^steps is required"),
        (lambda: fdebench.solve("pendulum", "l1", 8, grid="square"), "^grid = square: must be"),
        (lambda: fdebench.solve("pendulum", "l1", 8, at=[0.1234567]), "^at = 0.1234567: must be a time of the grid"),
        (lambda: fdebench.Scene("pendulum", alpha=3), "alpha = 3: must be"),
        (lambda: fdebench.Scene("fractional_extremum", until=0.5), "until = 0.5: must be 1: scene fractional_extremum is posed at both ends"),
        (lambda: fdebench.Scene("pendulum", omega=3), "omega"),
        (lambda: fdebench.Problem([2.5], [1.0], lambda t, y: y, 1.0), r"orders = 2.5: must be a number in \[0, 2\]"),
        (lambda: fdebench.Problem([1.5], [1.0], lambda t, y: y, 1.0), r"initial\[0\] = 1.0: must be 2 finite numbers"),
        (lambda: fdebench.Problem([0.5], [1.0], None, 1.0), "rhs = None: must be a function"),
        (lambda: fdebench.Problem([0.5], [1.0], lambda t, y: y, -1.0), "end = -1.0: must be a number above 0"),
        (lambda: fdebench.solve(relaxation(names=["t"]), "l1", 8, every=2, points=3), "one of them at most"),
    ],
)
def test_bad_input_is_a_value_error_that_says_what_is_allowed(wrong, message):
    with pytest.raises(ValueError, match=message):
        wrong()


def test_a_solve_that_leaves_double_says_scheme_step_and_time():
    """D y = y^2 from 1 is 1/(1 - t), infinite at 1; the explicit scheme steps over that, and is beyond double soon."""
    square = fdebench.Problem([1.0], [1.0], lambda t, y: y * y, 3.0)
    with numpy.errstate(over="ignore"), pytest.raises(fdebench.NumericalFailure, match="adams_pc: not finite at step") as raised:
        fdebench.solve(square, "adams_pc", 300)
    assert raised.value.scheme == "adams_pc"
    assert raised.value.time == pytest.approx(raised.value.step * 0.01)
    assert 1.0 < raised.value.time < 1.5


def test_what_a_right_hand_side_raises_comes_out_as_it_is():
    class Mine(Exception):
        pass

    def rhs(t, y):
        if t > 0.5:
            raise Mine("beyond the middle")
        return -y

    problem = fdebench.Problem([0.5], [1.0], rhs, 1.0)
    for solve in (lambda: fdebench.solve(problem, "l1", 8), lambda: fdebench.exact(problem, 1.0)):
        with pytest.raises(Mine, match="beyond the middle"):
            solve()


def test_a_right_hand_side_returns_as_many_numbers_as_there_are_unknowns():
    problem = fdebench.Problem([0.5, 0.5], [1.0, 1.0], lambda t, y: [0.0], 1.0)
    with pytest.raises(ValueError, match=r"rhs: returned an array of shape \(1\), must be \(2\)"):
        fdebench.solve(problem, "l1", 8)


@pytest.mark.parametrize(
    "returned, called",
    [(lambda y: None, "None"), (lambda y: [None, 1.0], "None"), (lambda y: [1j, 1.0], "complex numbers"), (lambda y: y * (1 + 0j), "complex numbers"),
     (lambda y: ["1", "2"], "text"), (lambda y: "12", "text"), (lambda y: numpy.array([1.0, 2j], dtype=object), "complex numbers"),
     (lambda y: numpy.array([1.0, "2"], dtype=object), "text")],
)  # fmt: skip
def test_a_right_hand_side_that_returns_no_real_numbers_is_named(returned, called):
    """NumPy makes nan of None, drops imaginary parts with a warning, and reads numbers from text."""
    problem = fdebench.Problem([0.5, 0.5], [1.0, 1.0], lambda t, y: returned(y), 1.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for solve in (lambda: fdebench.solve(problem, "l1", 8), lambda: fdebench.exact(problem, 1.0)):
            with pytest.raises(ValueError, match=f"^rhs: returned {called} at t = .*, must be real numbers$"):
                solve()


@pytest.mark.parametrize("kind", [float, int, bool, numpy.float32, fractions.Fraction])
def test_a_right_hand_side_may_return_any_real_numbers(kind):
    problem = fdebench.Problem([1.0], [0.0], lambda t, y: [kind(1)], 1.0)
    assert fdebench.solve(problem, "l1", 8).values[-1, 0] == pytest.approx(1.0)


FALLING = pathlib.Path(__file__).parents[2] / "docs/examples/falling.toml"


def test_events_are_those_of_the_command_and_a_path_names_a_file():
    """Until the sphere meets the ground; without memory it would at sqrt(2), half way at 1."""
    solution = fdebench.solve(FALLING, "spectral_collocation", accuracy=1e-8, events=True)
    printed = subprocess.run(
        [FDEBENCH, "solve", str(FALLING), "--scheme", "spectral_collocation", "--accuracy", "1e-8", "--events"],
        capture_output=True, text=True, check=True,
    )
    names, *rows = csv.reader(io.StringIO(printed.stdout))
    assert names == ["event", "t", *solution.names]
    assert solution.events == [row[0] for row in rows] == ["halfway", "ground"]
    assert numpy.array_equal(numpy.column_stack([solution.times, solution.values]), numpy.array(rows)[:, 1:].astype(float))
    fallen = fdebench.solve(fdebench.Scene(FALLING, basset=0), "spectral_collocation", accuracy=1e-8, events=True)
    assert fallen.times == pytest.approx([1, math.sqrt(2)], abs=1e-6)
    assert fdebench.solve(FALLING, "l1", 16).events is None
    with pytest.raises(ValueError, match="^events: "):
        fdebench.solve(FALLING, "l1", 16, events=True)


def rectangle_rule(problem, times):
    """y_n = y_0 + sum_{j < n} ((t_n - t_j)^a - (t_n - t_{j+1})^a) / Gamma(a + 1) f(t_j, y_j), of orders up to 1."""
    orders = numpy.array(problem.orders)
    y, f = (numpy.zeros((len(times), len(orders))) for _ in range(2))
    y[0] = [initial[0] for initial in problem.initial]
    for n, t in enumerate(times):
        if n > 0:
            before, after = (t - times[:n, None]) ** orders, (t - times[1 : n + 1, None]) ** orders
            y[n] = y[0] + ((before - after) * f[:n]).sum(axis=0) / numpy.array([math.gamma(order + 1) for order in orders])
        f[n] = problem.rhs(t, y[n])
    return y


def test_a_scheme_of_ones_own_is_tried_beside_the_others():
    answer = fdebench.choose("relaxation", error=1e-2, seconds=5, schemes={"rectangle_rule": rectangle_rule})
    mine = [run for run in answer["others"] if run["scheme"] == "rectangle_rule"]
    assert mine and min(run["error"] for run in mine if run["error"]) < 0.1
    exact = fdebench.choose(relaxation(), error=1e-9, seconds=5, schemes={"exact": lambda problem, times: numpy.exp(times)[:, None] * special_erfc(times)})
    assert exact["scheme"] == "exact" and exact["command"] is None


@pytest.mark.parametrize("seed", range(6))
def test_a_scheme_of_ones_own_meets_every_way_to_count_errors(seed):
    draw = random.Random(seed)
    scene = draw.choice(["relaxation", "linear_system", "diethelm", "loxodrome", "pendulum:until=1"])
    counted = {"norm": draw.choice(["end", "maximum"]), "scale": draw.choice(["absolute", "mixed", "peak"]), "runs": draw.choice(["1", "many"])}
    own = {"rectangle_rule": rectangle_rule, "none": lambda problem, times: numpy.full((len(times), len(problem.orders)), numpy.nan)}
    columns = draw.choice([None, fdebench.Scene(scene).columns[-1]])
    answer = fdebench.choose(scene, error=1e-2, seconds=20, columns=columns, schemes=own, **counted)
    assert answer["error"] <= 1e-2 and answer["scheme"] != "none"
    assert (answer["command"] is None) == (answer["scheme"] in own)
    assert {run["scheme"] for run in answer["others"]} | {answer["scheme"]} >= set(own)


def special_erfc(times):
    return numpy.array([[math.erfc(math.sqrt(t))] for t in times])


def test_what_a_scheme_of_ones_own_raises_comes_out_as_it_is():
    class Mine(Exception):
        pass

    def broken(problem, times):
        raise Mine("beyond the middle")

    with pytest.raises(Mine, match="beyond the middle"):
        fdebench.choose("relaxation", error=1e-3, seconds=5, schemes={"broken": broken})
    with pytest.raises(ValueError, match=r"^scheme short: returned an array of shape \(1\), must be \("):
        fdebench.choose("relaxation", error=1e-3, seconds=5, schemes={"short": lambda problem, times: [1.0]})
    with pytest.raises(ValueError, match="^schemes = l1: must be an id"):
        fdebench.choose("relaxation", error=1e-3, seconds=5, schemes={"l1": rectangle_rule})
    with pytest.raises(TypeError, match="^schemes = "):
        fdebench.choose("relaxation", error=1e-3, schemes={"none": None})


def test_the_version_is_that_of_the_command():
    printed = subprocess.run([FDEBENCH, "--version"], capture_output=True, text=True, check=True).stdout
    assert printed.split()[-1] == fdebench.__version__


def test_numbers_without_dimensions_are_numbers():
    assert fdebench.Scene("relaxation", gamma=numpy.array(0.25)).label == "relaxation:gamma=0.25"
    assert len(fdebench.solve("relaxation", "l1", numpy.array(8), at=numpy.float64(1)).times) == 1
    problem = fdebench.Problem(numpy.array([0.5]), numpy.array([1.0]), lambda t, y: -y, numpy.array(1.0))
    assert len(fdebench.solve(problem, "l1", 8).times) == 9


@pytest.mark.parametrize(
    "wrong, message",
    [
        (lambda: fdebench.solve(None, "l1", 8), "^scene = None: must be the name"),
        (lambda: fdebench.solve("relaxation", None, 8), "^scheme = None: must be the id"),
        (lambda: fdebench.solve("relaxation", "l1", 8j), "^steps = 8j: must be a real number"),
        (lambda: fdebench.solve("relaxation", "l1", 8, at=[1j]), "^at = .*1j.*: must be real numbers"),
        (lambda: fdebench.solve("relaxation", "l1", 8, at=[None]), r"^at = \[None\]: must be real numbers"),
        (lambda: fdebench.Scene("relaxation", gamma=None), "^gamma = None: must be a real number"),
        (lambda: fdebench.Scene("relaxation", gamma=0.5 + 0j), r"^gamma = \(0.5\+0j\): must be a real number"),
        (lambda: fdebench.exact("relaxation", None), "^times = None: must be real numbers"),
        (lambda: fdebench.exact("relaxation", 1j), "^times = 1j: must be real numbers"),
        (lambda: fdebench.choose("relaxation", error=None), "^error = None: must be a real number"),
        (lambda: fdebench.mittag_leffler(1j, 1, 1), "^alpha = 1j: must be real numbers"),
        (lambda: fdebench.mittag_leffler(0.5, 1, None), "^z = None: must be numbers"),
        (lambda: fdebench.Problem([None], [1.0], lambda t, y: y, 1.0), "^orders = None: must be a real number"),
        (lambda: fdebench.Problem(0.5, [1.0], lambda t, y: y, 1.0), "^orders = 0.5: must be a list"),
        (lambda: fdebench.Problem([0.5], 1.0, lambda t, y: y, 1.0), "^initial = 1.0: must be a list"),
        (lambda: fdebench.Problem([0.5], [1.0], lambda t, y: y, 1.0, names="y"), "^names = 'y': must be a list"),
        (lambda: fdebench.Problem([0.5], [1.0], lambda t, y: y, 1.0, jumps=0.5), "^jumps = 0.5: must be a list"),
        (lambda: fdebench.Scene("relaxation", "gamma=0.5"), "^parameters = 'gamma=0.5': must be a mapping"),
        (lambda: fdebench.choose("relaxation", error=1e-3, norm=2.5j), "^norm = 2.5j: must be a real number"),
        (lambda: fdebench.Problem([0.5], [None], lambda t, y: y, 1.0), r"^initial\[0\] = None: must be real numbers"),
        (lambda: fdebench.Problem([0.5], [1j], lambda t, y: y, 1.0), r"^initial\[0\] = 1j: must be real numbers"),
        (lambda: fdebench.Problem([0.5], [1.0], lambda t, y: y, None), "^end = None: must be a real number"),
        (lambda: fdebench.solve("relaxation", "l1", 8, step=3), "step"),
    ],
)
def test_what_is_no_number_is_a_type_error_that_names_the_argument(wrong, message):
    with pytest.raises(TypeError, match=message):
        wrong()


def test_integers_beyond_their_range_are_value_errors():
    for wrong, name in ((lambda: fdebench.solve("relaxation", "l1", 10**400), "steps"), (lambda: fdebench.choose("relaxation", error=10**400), "error")):
        with pytest.raises(ValueError, match=f"^{name} = "):
            wrong()


def test_columns_may_be_one_name_and_runs_a_number():
    answer = fdebench.choose("pendulum", error=1e-2, columns="phi", runs=1, seconds=10)
    assert answer["error"] < 1e-2
    with pytest.raises(KeyError, match="z: there are y"):
        fdebench.exact("relaxation", 1.0)["z"]
