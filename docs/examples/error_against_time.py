# %% [markdown]
# # Error against time
# What a scheme makes of its time: each point is one solve, its error taken at the end of a scene whose solution is known.

# %%
import sys

import matplotlib.pyplot as plt
import numpy

import fdebench

scene = fdebench.Scene("relaxation", gamma=0.7)
exact = fdebench.exact(scene, scene.end)["y"][0]

# %% Every scheme that takes the scene, with 16 to 4096 steps.
errors, seconds = {}, {}
steps = 2 ** numpy.arange(4, 13)
for scheme in fdebench.schemes():
    try:
        runs = [fdebench.solve(scene, scheme.id, n, at=scene.end) for n in steps.tolist()]
    except ValueError as refusal:
        print(refusal)
        continue
    errors[scheme.id] = [abs(run["y"][-1] - exact) for run in runs]
    seconds[scheme.id] = [run.cost["seconds"] for run in runs]

# %%
for name in errors:
    plt.loglog(seconds[name], errors[name], "o-", label=name)
plt.xlabel("seconds")
plt.ylabel("error at the end")
plt.legend()
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "error_against_time.svg")

# %% The rates at the end of the ladders.
for name, ladder in errors.items():
    print(f"{name:24} rate {numpy.log2(ladder[-2] / ladder[-1]):.2f}")
