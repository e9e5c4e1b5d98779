# SPDX-License-Identifier: MIT
"""The wheel, packed by setuptools: what CMake installs as its component `wheel`, from a build for this Python.

The environment variable FDEBENCH_BUILD names the folder of a build; without it one is made in build/wheel.
"""

import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parents[1]
GIVEN = os.environ.get("FDEBENCH_BUILD")
BUILD = Path(GIVEN) if GIVEN else ROOT / "build/wheel"
PACKED = BUILD / "wheel"


class BuildByCMake(build_ext):
    """The module with the rest of the package and the libraries, in setuptools' folder."""

    def run(self):
        if not GIVEN:
            self.spawn(["cmake", "-S", str(ROOT), "-B", str(BUILD), "-D", "CMAKE_BUILD_TYPE=Release", "-D", "CMAKE_UNITY_BUILD=ON",
                        "-D", f"Python_EXECUTABLE={sys.executable}"])
            self.spawn(["cmake", "--build", str(BUILD), "--parallel", str(os.cpu_count()), "--target", "fde_python"])
        module = BUILD / "python/fdebench" / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
        if not module.is_file():
            sys.exit(f"FDEBENCH_BUILD = {BUILD}: must have a module for this Python, {module.name}")
        prefix = Path(self.build_lib).resolve()
        shutil.rmtree(prefix, ignore_errors=True)  # of earlier builds
        subprocess.run(["cmake", "--install", BUILD, "--component", "wheel", "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)


# PEP 600: the wheel runs where glibc is as new as that of the machine it is made on.
GLIBC = platform.libc_ver()[1].replace(".", "_")
PACKED.mkdir(parents=True, exist_ok=True)
setup(
    version=re.search(r"^project\(fdebench VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE).group(1),
    packages=[],
    ext_modules=[Extension("fdebench._core", [])],
    cmdclass={"build_ext": BuildByCMake},
    options={
        "bdist_wheel": {"plat_name": f"manylinux_{GLIBC}_{platform.machine()}"},
        "build": {"build_base": str(PACKED)},
        "egg_info": {"egg_base": str(PACKED)},
    },
)
