# SPDX-License-Identifier: MIT
"""Which numerical scheme to use for a fractional differential equation, with proof.

>>> import fdebench
>>> solution = fdebench.solve("pendulum", "product_trapezoidal", 1024)
>>> solution
Solution(phi, Dbeta_phi, dphi, Dalpha_phi, energy at 1025 times)
>>> fdebench.exact("relaxation", [0.5, 1.0])["y"]
array([0.52315658, 0.42758358])
>>> fdebench.choose("relaxation", error=1e-6)["command"]
'fdebench solve relaxation --scheme ...'

``scenes()`` and ``schemes()`` list what there is; ``Problem`` is an equation of one's own.
"""

try:
    import numpy  # noqa: F401
except ModuleNotFoundError as missing:
    raise ImportError(f"fdebench needs NumPy (Debian's python3-numpy, or pip install numpy): {missing}") from None

from . import _core
from ._exact import Digits, Exact, exact, mittag_leffler, mittag_leffler_digits
from ._failure import DoubtfulResult, NumericalFailure
from ._fit import fit
from ._scene import Problem, Scene, Scheme, scene_facts, scenes, schemes
from ._solve import Solution, choose, solve, sweep

__version__ = _core.version()

__all__ = [
    "Digits",
    "DoubtfulResult",
    "Exact",
    "NumericalFailure",
    "Problem",
    "Scene",
    "Scheme",
    "Solution",
    "__version__",
    "choose",
    "exact",
    "fit",
    "mittag_leffler",
    "mittag_leffler_digits",
    "scene_facts",
    "scenes",
    "schemes",
    "solve",
    "sweep",
]
