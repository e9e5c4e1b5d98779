"""Any scene of one order in (0, 1) by the implicit L1 rule: fdebench run --external "l1=python3 l1_system.py" --scene brusselator ..."""

import json
import math
import platform
import sys
import time

import numpy

FUNCTIONS = {name: getattr(math, name) for name in "sin cos tan asin acos atan sinh cosh tanh exp log sqrt gamma atan2".split()}
FUNCTIONS |= {"power": math.pow, "abs": abs, "min": min, "max": max, "sign": lambda x: (x > 0) - (x < 0), "step": lambda x: ((x > 0) - (x < 0) + 1) / 2}


def refuse(why):
    print(why, file=sys.stderr)
    sys.exit(77)


def function_of(texts, unknowns):
    """The list of these expressions as a function of t and y."""
    code = compile(f"[{','.join(texts)}]", "system", "eval")
    return lambda t, y: numpy.array(eval(code, FUNCTIONS, {"t": t, **dict(zip(unknowns, map(float, y)))}))


with open(sys.argv[1]) as file:
    task = json.load(file)
orders = {row["order"] for row in task["rows"]}
if "system" not in task or "mittag_leffler" in json.dumps(task["system"]):
    refuse("takes expressions without mittag_leffler only")
if len(orders) > 1 or not 0 < min(orders) < 1 or task["grid"] != "uniform" or any(row["side"] == "right" for row in task["rows"]):
    refuse("takes one order in (0, 1) on the uniform grid")
if None in task["system"]["columns"]:
    refuse("takes equations whose columns are the unknowns")
order, steps, system = orders.pop(), task["steps"], task["system"]
initial = numpy.array([row["initial"][0] for row in task["rows"]])
size, h = len(initial), task["end_time"] / steps
unknowns = [f"y{i}" for i in range(1, size + 1)]
rhs = function_of(system["rhs"], unknowns)
entries = function_of(sum(system["jacobian"], []), unknowns)


def solve():
    n = numpy.arange(steps, dtype=float)
    weights = (n + 1) ** (1 - order) - n ** (1 - order)
    scale = h**order * math.gamma(2 - order)
    y, differences = initial.copy(), numpy.zeros((steps, size))
    for k in range(1, steps + 1):
        known = y - weights[k - 1 : 0 : -1] @ differences[: k - 1]
        last, t = y, k * h
        for _ in range(50):  # Newton's method for y = known + scale f(t, y)
            change = numpy.linalg.solve(numpy.eye(size) - scale * entries(t, y).reshape(size, size), known + scale * rhs(t, y) - y)
            y = y + change
            if numpy.max(numpy.abs(change)) <= 1e-13 * (1 + numpy.max(numpy.abs(y))):
                break
        else:
            sys.exit(f"Newton's method does not converge at t = {t}")
        differences[k - 1] = y - last
    return initial + numpy.vstack([numpy.zeros(size), numpy.cumsum(differences, axis=0)])


seconds = []
while not seconds or (task["timed"] and len(seconds) < 6 and sum(seconds) < 0.5):
    start = time.perf_counter()
    values = solve()
    seconds.append(time.perf_counter() - start)
print(f"# code: l1_system 1.0\n# language: {platform.python_implementation()} {platform.python_version()}, NumPy {numpy.__version__}")
print(f"# first: {seconds[0]:.9g}\n# seconds:", *(f"{one:.9g}" for one in seconds[1:] or seconds))
print("t", *(f'"{name}"' for name in system["columns"]), sep=",")
for t in task["times"]:
    print(f"{t:.17g}", *(f"{value:.17g}" for value in values[round(t / h)]), sep=",")
