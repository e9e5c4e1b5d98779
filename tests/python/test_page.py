# SPDX-License-Identifier: MIT
"""What docs/python.md shows runs, and _core.pyi declares what there is."""

import ast
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import fdebench

PAGE = Path(__file__).parents[2] / "docs/python.md"
PROGRAMS = re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("program", PROGRAMS, ids=range(len(PROGRAMS)))
def test_a_program_of_the_page_runs(program):
    exec(program, {})


def test_the_page_names_every_function():
    named = PAGE.read_text()
    assert [name for name in fdebench.__all__ if inspect.isfunction(getattr(fdebench, name)) and name not in named] == []


def test_every_name_of_the_compiled_half_is_declared():
    declarations = ast.parse(Path(fdebench.__file__).with_name("_core.pyi").read_text())
    declared = {node.name for node in declarations.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    assert declared == {name for name in dir(fdebench._core) if not name.startswith("_")}


def test_everything_says_what_it_is():
    public = [getattr(fdebench, name) for name in fdebench.__all__]
    assert [thing.__name__ for thing in public if not thing.__doc__] == []


def test_without_numpy_the_last_line_says_what_is_missing():
    program = "import sys; sys.modules['numpy'] = None; import fdebench"
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert ended.returncode == 1
    assert ended.stderr.splitlines()[-1].startswith("ImportError: fdebench needs NumPy (Debian's python3-numpy, or pip install numpy): ")
    assert "During handling" not in ended.stderr
