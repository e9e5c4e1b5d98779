# SPDX-License-Identifier: MIT
"""Every public name has a docstring, and what its examples print is what it says; "..." stands for any text."""

import doctest
import sys

import pytest

import fdebench

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
MODULES = ["fdebench", "fdebench._exact", "fdebench._failure", "fdebench._fit", "fdebench._scene", "fdebench._solve"]


@pytest.mark.parametrize("module", MODULES)
def test_examples(module):
    assert doctest.testmod(sys.modules[module], optionflags=OPTIONS).failed == 0


def test_what_is_called_has_an_example():
    names = [name for name in fdebench.__all__ if callable(getattr(fdebench, name)) and "Error" not in name]
    found = {name: getattr(fdebench, name).__doc__ or "" for name in names}
    without = [name for name, text in found.items() if ">>>" not in text]
    assert without == ["DoubtfulResult", "NumericalFailure"]
    assert all(found.values())
