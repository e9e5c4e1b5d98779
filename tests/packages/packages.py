#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The packages of a build, used in an empty root: glibc, what the package brings, and what it says it needs.

    packages.py make CPACK BUILD MADE               all packages, not compressed where that is a choice
    packages.py archive|debian|wheel FDEBENCH MADE WORK
                                                    in the root WORK: what the program prints is what FDEBENCH of the build prints

Exit code 77 (skipped) where a user may not make a root.
"""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
VERSION = re.search(r"^project\(fdebench VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE).group(1)
GLIBC = ["ld-linux-x86-64.so.2", "libc.so.6", "libm.so.6"]
EQUATION = ROOT / "docs/examples/duffing.toml"
# Lines of these do not depend on the time that something took.
COMMANDS = [["--version"], ["scenes"], ["solve", "relaxation", "--scheme", "bdf2", "--steps", "64", "--points", "5"],
            ["solve", "equation.toml", "--scheme", "spectral_collocation", "--accuracy", "1e-8", "--points", "5"],
            ["exact", "pendulum", "--at", "0.5,2"], ["mittag-leffler", "0.5", "1", "-2.5"]]
# auditwheel's policy manylinux_2_36_x86_64: the libraries of every Linux, and the newest versions of their symbols.
EVERYWHERE = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "ld-linux-x86-64.so.2", "libdl.so.2", "libpthread.so.0", "librt.so.1"}
NEWEST = {"GLIBC": (2, 36), "GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13), "GCC": (12, 0, 0)}


def run(*command, **more):
    """What a command prints; the end of this test where it fails."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def require(condition, what):
    if not condition:
        sys.exit(what)


class EmptyRoot:
    """A folder that is the root of the processes in it."""

    def __init__(self, folder):
        if subprocess.run(["unshare", "--map-root-user", "--mount", "true"], capture_output=True).returncode != 0:
            print("skipped: user namespaces are not allowed here")
            sys.exit(77)
        shutil.rmtree(folder, ignore_errors=True)
        self.folder, self.variables = folder, {}
        for name in ["usr/lib/x86_64-linux-gnu", "usr/lib64", "usr/bin", "tmp", "home", "proc"]:
            (folder / name).mkdir(parents=True)
        for name in ["lib", "lib64", "bin"]:
            (folder / name).symlink_to(f"usr/{name}")
        for name in GLIBC:
            shutil.copy(f"/lib/x86_64-linux-gnu/{name}", folder / "lib/x86_64-linux-gnu")
        shutil.copy("/lib64/ld-linux-x86-64.so.2", folder / "lib64")
        shutil.copy(EQUATION, folder / "home/equation.toml")

    def add(self, packages):
        """Libraries and Python's files of these packages and of those that they depend on, hard links where possible."""
        seen, wanted = set(), list(packages)
        while wanted:
            package = wanted.pop()
            if package in seen or subprocess.run(["dpkg-query", "--status", package], capture_output=True).returncode != 0:
                continue
            seen.add(package)
            wanted += depends(run("dpkg-query", "--show", "--showformat=${Depends}, ${Pre-Depends}", package))
        for name in run("dpkg-query", "--listfiles", *seen).splitlines():
            if re.match(r"(/usr)?/lib(/.*\.so\b|/python3)|/usr/bin/python3", name) and "/debug/" not in name:
                self.copy(Path(name))

    def copy(self, source):
        target = self.folder / str(source).lstrip("/")
        if source.is_dir() or target.is_symlink() or target.exists():
            return
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_symlink():
            target.symlink_to(os.readlink(source))
            return
        try:
            os.link(source, target)
        except OSError:
            shutil.copy2(source, target)

    def run(self, *command):
        # Where a program lies, which $ORIGIN stands for, is read from /proc.
        enter = 'mount --rbind /proc "$0/proc" && exec chroot "$0" "$@"'
        return run("unshare", "--map-root-user", "--mount", "sh", "-c", enter, self.folder, *command,
                   env={"PATH": "/usr/bin:/usr/sbin", "LC_ALL": "C.UTF-8", "PYTHONDONTWRITEBYTECODE": "1", **self.variables})


def depends(text):
    """The names in a field Depends, of alternatives the first."""
    return [re.split(r"[ (:]", entry.split("|")[0].strip())[0] for entry in text.split(",") if entry.strip()]


def check_program(root, *program):
    """The program in the root prints what that of the build prints, chooses a scheme, and makes a report."""
    for command in COMMANDS:
        here = ["/home/equation.toml" if word == "equation.toml" else word for word in command]
        there = [str(EQUATION) if word == "equation.toml" else word for word in command]
        printed, wanted = root.run(*program, *here), run(FDEBENCH, *there)
        require(printed == wanted, f"{' '.join(command)} prints\n{printed}where that of the build prints\n{wanted}")
    chosen = root.run(*program, "choose", "relaxation", "--error", "1e-4", "--max-time", "2")
    require(re.match(r"run: fdebench solve relaxation --scheme \w+", chosen), f"choose prints {chosen}")
    root.run(*program, "run", "--scene", "relaxation", "--scheme", "l1", "--steps", "16,32", "--out", "/tmp/runs.jsonl")
    root.run(*program, "report", "/tmp/runs.jsonl", "--out", "/tmp/report")
    require((root.folder / "tmp/report/index.html").stat().st_size > 300_000, "the report is too small to have charts")


def make(cpack, build, made):
    shutil.rmtree(made, ignore_errors=True)
    run(cpack, "--config", f"{build}/CPackConfig.cmake", "-B", made, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=none")
    run(sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--no-index", "--no-cache-dir",
        "--config-settings=--build-option=--compression=stored", "--wheel-dir", made, ROOT / "python", env=os.environ | {"FDEBENCH_BUILD": build})
    names = {file.name for file in Path(made).iterdir() if file.is_file()}
    for wanted in [f"fdebench-{VERSION}-linux-x86_64.tar.gz", f"fdebench_{VERSION}_amd64.deb", f"fdebench-data_{VERSION}_all.deb",
                   f"libfdebench-dev_{VERSION}_amd64.deb", f"python3-fdebench_{VERSION}_amd64.deb"]:
        require(wanted in names, f"there is no {wanted} among {', '.join(sorted(names))}")


def archive(made, work):
    root = EmptyRoot(work)
    unusual = work / "home/an unusual place, with spaces"
    with tarfile.open(next(made.glob("*.tar.gz"))) as packed:
        packed.extractall(unusual)
    (top,) = unusual.iterdir()
    require((top / "share/fdebench/reference/SHA256SUMS").is_file(), "the archive has no reference data")
    libraries = {file.name for file in (top / "lib/fdebench").iterdir()}
    listed = (top / "share/doc/fdebench/licences/README").read_text()
    for library in libraries:
        stem = library.split(".so")[0]
        require(f"{stem}.so" in listed, f"licences/README does not say where {library} is from")
    require(not libraries & set(GLIBC), "the archive has libraries of glibc")
    check_program(root, f"/home/{unusual.name}/{top.name}/bin/fdebench")


def debian(made, work):
    root = EmptyRoot(work)
    debs = {file.name.split("_")[0]: file for file in made.glob("*.deb")}
    for deb in debs.values():
        run("dpkg-deb", "--extract", deb, work / "deb")
    shutil.copytree(work / "deb/usr", work / "usr", symlinks=True, dirs_exist_ok=True)
    root.add(name for package in ["fdebench", "python3-fdebench"] for name in depends(run("dpkg-deb", "--field", debs[package], "Depends")))
    for package in debs:
        for file in ["copyright", "changelog.gz"]:
            require((work / "usr/share/doc" / package / file).is_file(), f"{package} has no {file}")
    require((work / "usr/lib/cmake/fdebench/fdebench-config.cmake").is_file(), "libfdebench-dev has no fdebench-config.cmake")
    require((work / "usr/share/fdebench/reference/SHA256SUMS").is_file(), "fdebench-data has no SHA256SUMS")
    check_program(root, "/usr/bin/fdebench")
    check_module(root)


def check_module(root):
    root.variables |= {"LD_LIBRARY_PATH": ":".join(f"/usr/lib/x86_64-linux-gnu/{name}" for name in ["blas", "lapack"])}
    program = "import fdebench; print(fdebench.__version__, fdebench.solve('relaxation', 'l1', 4)['y'][0], fdebench.exact('relaxation', [1.0])['y'][0])"
    printed = root.run("/usr/bin/python3", "-c", program)
    require(re.fullmatch(rf"{re.escape(VERSION)} 1\.0 0\.4275835761558\d*\n", printed), f"the module prints {printed}")
    missing = {"py.typed", "_core.pyi"} - {file.name for file in root.folder.glob("**/fdebench/*")}
    require(not missing, f"not installed: {missing}")


def check_binary(file, bundled):
    """auditwheel's rules for one program or library."""
    facts = run("readelf", "--dynamic", "--version-info", "--wide", file)
    for needed in re.findall(r"\(NEEDED\).*\[(.*)\]", facts):
        require(needed in EVERYWHERE | bundled, f"{file.name} needs {needed}, which is neither in the wheel nor everywhere")
    for name, version in re.findall(r"Name: ([A-Z]+)_([\d.]+)  Flags", facts):
        if name in NEWEST and file.name not in bundled or name == "GLIBC":
            require(tuple(map(int, version.split("."))) <= NEWEST[name], f"{file.name} needs {name}_{version}")
    for path in re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", facts):
        require(path in {"$ORIGIN", "$ORIGIN/../fdebench.libs"}, f"{file.name} searches {path}")
    return re.findall(r"\(SONAME\).*\[(.*)\]", facts)


def wheel(made, work):
    (packed,) = made.glob("*.whl")
    tag = f"cp3{sys.version_info.minor}-cp3{sys.version_info.minor}-manylinux_2_36_x86_64"
    require(packed.name == f"fdebench-{VERSION}-{tag}.whl", f"the wheel is {packed.name}")
    root = EmptyRoot(work)
    root.add(["python3", "python3-numpy", "libstdc++6"])  # the last is in EVERYWHERE
    site = work / "opt/site"
    run(sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--no-cache-dir", "--target", site, packed)
    libraries = {file.name: file for file in (site / "fdebench.libs").iterdir()}
    for name, file in libraries.items():
        require(re.fullmatch(r"lib\w+-[0-9a-f]{8}\.so[.\d]*", name), f"{name} has no checksum in its name")
        require(check_binary(file, set(libraries)) == [name], f"{name} has another soname")
    check_binary(next((site / "fdebench").glob("_core*.so")), set(libraries))
    with zipfile.ZipFile(packed) as content:
        metadata = content.read(f"fdebench-{VERSION}.dist-info/METADATA").decode()
    for line in [f"Version: {VERSION}", "License: MIT", "Requires-Dist: numpy"]:
        require(line in metadata.splitlines(), f"METADATA does not say {line}")
    root.variables["PYTHONPATH"] = "/opt/site"
    check_module(root)
    check_program(root, "/usr/bin/python3", "-m", "fdebench")


kind, tool, *rest = sys.argv[1:]
if kind == "make":
    make(tool, *rest)
else:
    FDEBENCH = tool
    {"archive": archive, "debian": debian, "wheel": wheel}[kind](*map(Path, rest))
