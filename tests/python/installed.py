#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is installed is all that `import fdebench` needs.

    installed.py prefix CMAKE BUILD WORK     the component `python`, in a prefix
    installed.py package CPACK BUILD WORK    the Debian package, unpacked: its program runs, too
"""

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


def prefix(cmake, build, work):
    run(cmake, "--install", build, "--component", "python", "--prefix", work)
    check_package(work / f"lib/python3.{sys.version_info.minor}/site-packages")


def package(cpack, build, work):
    run(cpack, "--config", f"{build}/CPackConfig.cmake", "-B", work, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=none")
    (made,) = work.glob("*.deb")
    run("dpkg-deb", "--extract", made, work / "root")
    check_package(work / "root/usr/lib/python3/dist-packages")
    assert "pendulum" in run(work / "root/usr/bin/fdebench", "scenes")
    assert (work / "root/usr/share/doc/fdebench/LICENSE").is_file()
    assert (work / "root/usr/lib/cmake/fdebench/fdebench-config.cmake").is_file()


kind, tool, build, work = sys.argv[1:]
shutil.rmtree(work, ignore_errors=True)
{"prefix": prefix, "package": package}[kind](tool, build, Path(work))
