"""D^0.5 y = -y, y(0) = 1 by the L1 rule with NumPy: python3 relaxation.py STEPS OUT.csv; prints the seconds it took."""

import math
import sys
import time

import numpy

steps, out = int(sys.argv[1]), sys.argv[2]
order, end = 0.5, 1.0
start = time.perf_counter()
n = numpy.arange(steps, dtype=float)
weights = (n + 1) ** (1 - order) - n ** (1 - order)
scale = (end / steps) ** order * math.gamma(2 - order)
y = numpy.ones(steps + 1)
for k in range(1, steps + 1):
    differences = numpy.diff(y[:k])[::-1]  # y_{k-1} - y_{k-2}, ..., y_1 - y_0
    y[k] = (y[k - 1] - weights[1:k] @ differences) / (1 + scale)
seconds = time.perf_counter() - start
times = numpy.linspace(0, end, steps + 1)
numpy.savetxt(out, numpy.column_stack([times, y]), fmt="%.17g", delimiter=",", header="t,y")
print(seconds)
