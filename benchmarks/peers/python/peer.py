# SPDX-License-Identifier: MIT
"""Solves the equation of a task (docs/external_solvers.md) with a stepper of pycaputo: peer.py STEPPER [OPTION=VALUE]... TASK

pycaputo is found by PYTHONPATH. Options: corrector_iterations, theta, r (the grading of the grid; "auto" chooses it by the order), chi.
With chi Jannelli's controller chooses the steps, the only one that works with these steppers. It keeps its measure of the change of the
solution in a step between chi/(10 N) and chi/N, where N is the number of steps of the task.
"""

import importlib.metadata
import json
import math
import pathlib
import platform
import re
import sys
import time

import numpy as np

WITHOUT_JACOBIAN = ("ForwardEuler", "ExplicitTrapezoidal", "PECE", "PEC", "ModifiedPECE")


def refuse(reason):
    print(reason, file=sys.stderr)
    sys.exit(77)


def function_of(rows):
    """The function of t and y whose value is the array of these formulas."""
    names = {name: getattr(np, name) for name in
             ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs", "sign", "floor", "power")}
    names |= {"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "min": min, "max": max,
              "gamma": math.gamma, "erf": math.erf, "erfc": math.erfc, "step": lambda x: (np.sign(x) + 1) / 2, "np": np}
    text = re.sub(r"\by(\d+)\b", lambda found: f"y[{int(found[1]) - 1}]", str(rows).replace("'", ""))
    return eval(f"lambda t, y: np.array({text}, dtype=float)", names)


def solver_of(stepper, task, options):
    """A function that solves once and returns the times, and the values with a row for each time."""
    from pycaputo.controller import make_fixed_controller, make_graded_controller
    from pycaputo.derivatives import CaputoDerivative
    from pycaputo.events import StepAccepted
    from pycaputo.fode import caputo
    from pycaputo.stepping import evolve

    rows, end, steps = task["rows"], task["end_time"], task["steps"]
    if any(row["order"] == 0 or row["side"] == "right" for row in rows):
        refuse("takes initial-value problems without algebraic equations")
    if any(not 0 < row["order"] < 1 for row in rows):
        refuse("takes orders in (0, 1)")
    arguments = {"ds": tuple(CaputoDerivative(row["order"]) for row in rows), "source": function_of(task["system"]["rhs"]),
                 "y0": (np.array([row["initial"][0] for row in rows]),)}
    if stepper not in WITHOUT_JACOBIAN:
        jacobian = task["system"]["jacobian"]
        # The derivative of a scalar equation has the shape of y: root_scalar gives its iterates the shape of the quotient.
        arguments["source_jac"] = function_of(jacobian if len(rows) > 1 else jacobian[0])
    for name in ("corrector_iterations", "theta"):
        if name in options:
            arguments[name] = type(1 if name == "corrector_iterations" else 0.5)(options[name])

    def solve():
        if "chi" in options:
            control, first = adaptive_controller(end, float(options["chi"]) / steps), None
        elif "r" in options:
            grading = {"alpha": rows[0]["order"]} if options["r"] == "auto" else {"r": float(options["r"])}
            control = make_graded_controller(tstart=0.0, tfinal=end, nsteps=steps, **grading)
            first = control.timesteps[0]
        else:
            # Without dtinit the first step is estimated, and as many steps end before `end`.
            control, first = make_fixed_controller(end / steps, tstart=0.0, tfinal=end, nsteps=steps), end / steps
        events = [event for event in evolve(getattr(caputo, stepper)(control=control, **arguments), dtinit=first) if isinstance(event, StepAccepted)]
        return [event.t for event in events], [np.ravel(event.y) for event in events]

    return solve


def adaptive_controller(end, largest):
    """Jannelli's controller with the defaults of make_jannelli_controller. That one bounds each step by the time left before the last, and ends
    beyond the end."""
    from pycaputo.controller import JannelliIntegralController, evaluate_timestep_accept

    class EndsThere(JannelliIntegralController):
        pass

    @evaluate_timestep_accept.register(EndsThere)
    def _(controller, method, factor, step, state):
        chosen = evaluate_timestep_accept.dispatch(JannelliIntegralController)(controller, method, factor, step, state)
        return min(chosen, end - state["t"] - step + 1e-15 * end)

    defaults = {"nsteps": None, "dtmin": 1e-6, "qmin": 0.5, "qmax": 1.5, "abstol": 1e-8, "reltol": 1.0}
    return EndsThere(tstart=0.0, tfinal=end, chimin=largest / 10, chimax=largest, **defaults)


def main(stepper, *words):
    task = json.loads(pathlib.Path(words[-1]).read_text())
    print(f"# code: pycaputo {version()}\n# language: Python {platform.python_version()}, NumPy {np.__version__}", flush=True)
    if "mittag_leffler" in json.dumps(task.get("system")):
        refuse("the adapter has no Mittag-Leffler function")
    if "system" not in task:
        refuse("the adapter needs the right-hand sides as formulas, which this scene does not have")
    solve = solver_of(stepper, task, dict(word.split("=") for word in words[:-1]))
    start = time.perf_counter()
    times, values = solve()
    first = time.perf_counter() - start
    seconds = []
    while task["timed"] and (not seconds or (len(seconds) < 5 and sum(seconds) < 0.5)):
        start = time.perf_counter()
        solve()
        seconds.append(time.perf_counter() - start)
    if task["timed"]:
        print(f"# first: {first:.9g}\n# seconds: {' '.join(f'{each:.9g}' for each in seconds)}")
    print("# times: own")
    end, columns = task["end_time"], task["system"]["columns"]
    shown = [i for i, name in enumerate(columns) if name]
    print(",".join(["t", *(columns[i] for i in shown)]))
    for t, y in zip(times, values, strict=True):
        # A sum of rounded steps ends beside the end by more than a rounding error.
        t = end if abs(t - end) < 1e-9 * end else t
        print(",".join(f"{number:.17g}" for number in (t, *(y[i] for i in shown))))


def version():
    """That of the installed package; empty where pycaputo is a folder."""
    try:
        return importlib.metadata.version("pycaputo")
    except importlib.metadata.PackageNotFoundError:
        return ""


if __name__ == "__main__":
    main(*sys.argv[1:])
