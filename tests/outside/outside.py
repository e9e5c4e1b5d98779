#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""fdebench installed, and a project outside the tree that takes it.

    outside.py install CMAKE BUILD PREFIX            the components `library` and `runtime` of a build
    outside.py project CMAKE COMPILER PREFIX WORK FDEBENCH
                                                     docs/examples/outside with find_package, and what its programs print
    outside.py pkg-config COMPILER PREFIX WORK       some of its programs with pkg-config
    outside.py c CMAKE COMPILER PREFIX WORK           docs/examples/c and docs/examples/fortran with what is installed for C
    outside.py headers COMPILER PREFIX               each public header of docs/library.md alone
"""

import csv
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROJECT = ROOT / "docs/examples/outside"


def run(*command, **more):
    """What a command prints; the end of this test where it fails."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def near(value, wanted, error, what):
    if not abs(float(value) - wanted) <= error:
        sys.exit(f"{what}: {value} is not within {error} of {wanted}")


def install(cmake, build, prefix):
    shutil.rmtree(prefix, ignore_errors=True)
    run(cmake, "--install", build, "--component", "library", "--prefix", prefix)
    run(cmake, "--install", build, "--component", "runtime", "--prefix", prefix)
    if list(Path(prefix).glob("bin/*")) or not list(Path(prefix).glob("lib/*.a")):
        sys.exit("the component `library` is not the libraries alone")


def check_riccati(program):
    """Order 1 is tanh; other orders: within what schemes of their rates leave at 1024 steps."""
    printed = run(program, "1")
    near(re.search(r"y\(1\) = (\S+),", printed).group(1), math.tanh(1.0), 1e-14, "the reference of order 1")
    errors = dict(re.findall(r"^(\w+) +(\S+)$", run(program, "0.9"), re.MULTILINE))
    near(errors["product_trapezoidal"], 0.0, 1e-6, "product_trapezoidal, order 0.9")
    near(errors["grunwald_letnikov"], 0.0, 2e-3, "grunwald_letnikov, order 0.9")
    page = re.search(r"^\$ riccati 0.9\n(.*?)^```$", (ROOT / "docs/library.md").read_text(), re.MULTILINE | re.DOTALL).group(1)
    shown = dict(re.findall(r"^(\w+) +(\S+)$", page, re.MULTILINE))
    if list(shown) != list(errors):
        sys.exit(f"docs/library.md: riccati prints {', '.join(errors)}")
    for scheme, error in shown.items():
        near(errors[scheme], float(error), 0.06 * float(error) + 2e-15, f"{scheme} in docs/library.md")


def check_functions(program):
    """e erfc(1); its series by mpmath 1.2.1: exp(1) * erfc(1), mp.dps = 45. The derivative is checked by the program."""
    double, digits, slopes = run(program).splitlines()
    near(double.split()[0], math.e * math.erfc(1.0), 3e-16, "E_{1/2,1}(-1)")
    if not digits.startswith("0.4275835761558070044107503444905151808202"):
        sys.exit(f"E_{{1/2,1}}(-1) in digits: {digits}")
    entry, slope = slopes.split(" = ")
    near(entry, float(slope), 1e-14, "the derivative")


def last_row(text):
    names, *rows = csv.reader(text.splitlines())
    return dict(zip(names, map(float, rows[-1])))


def check_judged(program, fdebench):
    """The error at the end is that of what the command prints."""
    measured = dict(line.split()[:2] for line in run(program).splitlines())
    scene = "pendulum:alpha=1.9,until=5"
    solved = last_row(run(fdebench, "solve", scene, "--scheme", "product_trapezoidal", "--steps", "512", "--at", "5"))
    exact = last_row(run(fdebench, "exact", "pendulum:alpha=1.9", "--at", "5"))
    columns = ("phi", "Dbeta_phi", "dphi", "Dalpha_phi")
    error = max(abs(solved[name] - exact[name]) for name in columns)
    near(measured["error_end"], error, 1e-5 * error, "error_end of the pendulum")


def check_cheapest(program):
    """The chosen run is within 1e-5 of the exact value, and the errors of the trapezoidal rule fall with the rate 1.7 = 1 + gamma."""
    chosen, *swept = run(program).splitlines()
    value, exact = (float(word) for word in re.fullmatch(r"\w+ with N = \d+: (\S+), exactly (\S+)", chosen).groups())
    near(value, exact, 1e-5 * (1.0 + exact), "the chosen run")
    errors = [float(line.split()[-1]) for line in swept]
    for coarse, fine in zip(errors, errors[1:]):
        near(math.log2(coarse / fine), 1.7, 0.2, "the rate of the trapezoidal rule")
    if len(errors) != 3:
        sys.exit(f"cheapest: {swept} must be three runs")


def check_own_scheme(program):
    """On each of ten scenes the best scheme is within 1 %, and the rule has a run, with its error and time beside the best one's."""
    printed = run(program)
    runs = re.findall(r"^(\S+) +(\w+) +N = \d+ +error (\S+), \S+ times as long: (.+)$", printed, re.MULTILINE)
    best = [float(error) for _, _, error, place in runs if place == "the best"]
    mine = {scene for scene, scheme, _, _ in runs if scheme == "rectangle_rule"}
    if len(best) != 10 or max(best) > 1e-2 or len(mine) != 10:
        sys.exit(f"own_scheme:\n{printed}")


def project(cmake, compiler, prefix, work, fdebench):
    shutil.rmtree(work, ignore_errors=True)
    settings = f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={compiler}"
    run(cmake, "-G", "Ninja", "-S", PROJECT, "-B", work, *settings)
    run(cmake, "--build", work)
    run(cmake, "-G", "Ninja", "-S", ROOT / "tests/outside/schemes", "-B", f"{work}/schemes", *settings)
    run(cmake, "--build", f"{work}/schemes")
    run(Path(work, "schemes/relaxes"))
    check_riccati(Path(work, "riccati"))
    check_functions(Path(work, "functions"))
    check_judged(Path(work, "judged"), fdebench)
    check_cheapest(Path(work, "cheapest"))
    check_own_scheme(Path(work, "own_scheme"))


def pkg_config(compiler, prefix, work):
    Path(work).mkdir(exist_ok=True)
    environment = os.environ | {"PKG_CONFIG_PATH": f"{prefix}/lib/pkgconfig"}
    packages = {
        PROJECT / "riccati.cpp": "fdebench-schemes fdebench-reference",
        PROJECT / "functions.cpp": "fdebench-special_functions",
        PROJECT / "cheapest.cpp": "fdebench-benchmarks",
        ROOT / "tests/embedding/relaxes.cpp": "fdebench-schemes",
    }
    for source, package in packages.items():
        flags = run("pkg-config", "--cflags", "--libs", *package.split(), env=environment).split()
        if "-DEIGEN_MAX_ALIGN_BYTES=64" not in flags:
            sys.exit(f"{package}: the alignment is not among {flags}")
        run(compiler, "-std=c++20", source, "-o", f"{work}/{source.stem}", *flags)
    run(Path(work, "relaxes"))
    check_riccati(Path(work, "riccati"))
    check_functions(Path(work, "functions"))
    check_cheapest(Path(work, "cheapest"))


def for_c(cmake, compiler, prefix, work):
    """The programs of docs/c.md by its build lines, and by find_package; the header alone; what the library exports."""
    shutil.rmtree(work, ignore_errors=True)
    Path(work).mkdir()
    page, examples, libraries = (ROOT / "docs/c.md").read_text(), ROOT / "docs/examples", f"{prefix}/lib"
    environment = os.environ | {"PKG_CONFIG_PATH": f"{libraries}/pkgconfig", "LD_LIBRARY_PATH": libraries}
    flags = run("pkg-config", "--cflags", "--libs", "fdebench", env=environment).split()
    strict = "-Wall", "-Wextra", "-Wpedantic", "-Werror"
    run(compiler, "-std=c99", *strict, examples / "c/riccati.c", "-o", f"{work}/riccati", *flags, "-lm")
    printed = run(Path(work, "riccati"), env=environment)
    if printed not in page:
        sys.exit(f"docs/c.md: riccati prints {printed}")
    run(cmake, "-G", "Ninja", "-S", examples / "c", "-B", f"{work}/build", f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_C_COMPILER={compiler}")
    run(cmake, "--build", f"{work}/build")
    if run(Path(work, "build/riccati")) != printed:
        sys.exit("riccati of find_package prints something else")
    for language, standard in ("c", "c99"), ("c", "c17"), ("c++", "c++20"):
        run(compiler, "-x", language, f"-std={standard}", *strict, f"-I{prefix}/include", "-fsyntax-only", "-", input="#include <fdebench.h>\n")
    header = Path(prefix, "include/fdebench.h").read_text()
    declared = set(re.findall(r"\b(fdebench_\w+)\(", header.split("extern")[1])) - {"fdebench_function"}
    listed = run("nm", "-D", "--defined-only", f"{libraries}/libfdebench.so")
    exported = {line.split()[2].split("@")[0] for line in listed.splitlines() if line.split()[1] != "A"}
    if declared ^ exported:
        sys.exit(f"fdebench.h and libfdebench.so differ in {declared ^ exported}")
    if missing := [name for name in declared if f"`{name}`" not in page]:
        sys.exit(f"docs/c.md: does not name {missing}")
    if shutil.which("gfortran"):
        run("gfortran", "-std=f2008", "-Wall", "-J", work, examples / "fortran/relaxation.f90", "-o", f"{work}/relaxation", *flags)
        near(run(Path(work, "relaxation"), env=environment).split()[-1], 0.0, 1e-8, "the relaxation in Fortran")


def public_headers():
    """Path in include/fdebench of each that docs/library.md names."""
    page = (ROOT / "docs/library.md").read_text()
    return re.findall(r"^\| `fdebench/([\w/]+\.hpp)` \|", page, re.MULTILINE)


def headers(compiler, prefix):
    """What a header includes is installed, and it says what it needs: alone it compiles. A header with a source of its name is compiled
    alone where clang reads that source, which begins with it."""
    flags = run("pkg-config", "--cflags", "eigen3").split() + ["-std=c++20", "-fsyntax-only", "-x", "c++", "-"]
    flags.append("-DEIGEN_DONT_VECTORIZE")  # a quarter of the time, and nothing of what is declared
    named = public_headers()
    if len(named) < 10:
        sys.exit(f"docs/library.md: names {named} only")
    if Path(prefix, "include/fdebench/schemes/rules").exists():
        sys.exit("headers that no public one includes are installed")
    alone = [[header] for header in named if not (ROOT / header).with_suffix(".cpp").exists()]
    for together in [named, *alone]:
        run(compiler, f"-I{prefix}/include", *flags, input="".join(f"#include <fdebench/{header}>\n" for header in together))


COMMANDS = {"install": install, "project": project, "pkg-config": pkg_config, "c": for_c, "headers": headers}
COMMANDS[sys.argv[1]](*sys.argv[2:])
print(f"{sys.argv[1]}: as it should be")
