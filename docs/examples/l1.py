"""D^gamma y = lambda y by the L1 rule with NumPy: fdebench run --external "numpy=python3 l1.py" --scene relaxation ..."""

import json
import math
import sys
import time

import numpy

with open(sys.argv[1]) as file:
    task = json.load(file)
parameters = task["parameters"]
if task["scene"] != "relaxation" or parameters["gamma"] >= 1 or task["grid"] != "uniform":
    print("solves relaxation with gamma < 1 on the uniform grid", file=sys.stderr)
    sys.exit(77)
order, rate, steps, end = parameters["gamma"], parameters["lambda"], task["steps"], task["end_time"]
start = time.perf_counter()
n = numpy.arange(steps, dtype=float)
weights = (n + 1) ** (1 - order) - n ** (1 - order)
scale = (end / steps) ** order * math.gamma(2 - order) * rate
y = numpy.full(steps + 1, float(parameters["y0"]))
for k in range(1, steps + 1):
    differences = numpy.diff(y[:k])[::-1]  # y_{k-1} - y_{k-2}, ..., y_1 - y_0
    y[k] = (y[k - 1] - weights[1:k] @ differences) / (1 - scale)
seconds = time.perf_counter() - start
rows = numpy.rint(numpy.array(task["times"]) / end * steps).astype(int)
print(f"# seconds: {seconds:.9g}")
print("t,y")
for t, value in zip(task["times"], y[rows]):
    print(f"{t:.17g},{value:.17g}")
