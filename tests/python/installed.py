#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The component `python`, installed in a prefix, is all that `import fdebench` needs: installed.py CMAKE BUILD WORK."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ENVIRONMENT = os.environ | {"PYTHONDONTWRITEBYTECODE": "1"}


def run(*command):
    return subprocess.run([str(word) for word in command], env=ENVIRONMENT, capture_output=True, text=True, check=True).stdout


def check_package(packages):
    program = "import fdebench; print(fdebench.__file__, *fdebench.solve('relaxation', 'l1', 4)['y'][:1])"
    printed = run(sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {str(packages)!r}); {program}")
    assert printed == f"{packages}/fdebench/__init__.py 1.0\n", printed
    missing = {"py.typed", "_core.pyi"} - {file.name for file in packages.glob("fdebench/*")}
    assert not missing, f"not installed: {missing}"


cmake, build, work = sys.argv[1:]
shutil.rmtree(work, ignore_errors=True)
run(cmake, "--install", build, "--component", "python", "--prefix", work)
check_package(Path(work) / f"lib/python3.{sys.version_info.minor}/site-packages")
