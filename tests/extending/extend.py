#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Follows docs/extending.md to the letter.

    extend.py write FOLDER      writes the files of the page there, laid out as in the repository, and beside them the
                                lists with the page's lines and the sources that include them; prints all sources
    extend.py check PROGRAM     runs the commands of the page with this fdebench and compares what they print
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "extending.md").read_text()


def parts():
    """{path: text} of the files and lines of the page; the lines of one list together."""
    texts = {}
    for path, text in re.findall(r"^```cpp (\S+)\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL):
        texts[path] = texts.get(path, "") + text
    return texts


def includers(path):
    """The sources that include this list."""
    top = ROOT / path.split("/", 1)[0]
    return [p.relative_to(ROOT).as_posix() for p in top.rglob("*.cpp") if f'#include "fdebench/{path}"' in p.read_text()]


def write(folder):
    sources = []
    for path, text in parts().items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        is_list = path.endswith(".def")
        new = (ROOT / path).read_text() + text if is_list else text
        if not target.exists() or target.read_text() != new:
            target.write_text(new)
        for source in includers(path) if is_list else []:
            (folder / source).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / source, folder / source)
            sources.append(source)
        if not is_list:
            sources.append(path)
    print(";".join(str(folder / source) for source in sources))


def check(program):
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "fdebench").symlink_to(Path(program).resolve())
        environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
        for block in re.findall(r"^```console\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL):
            for command, expected in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.MULTILINE):
                run = subprocess.run(command, shell=True, cwd=folder, env=environment, capture_output=True, text=True)
                if run.stdout != expected or run.returncode != 0:
                    failures += 1
                    print(f"$ {command}\nprints\n{run.stdout}{run.stderr}and not\n{expected}")
    return failures


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in {"write", "check"}:
        sys.exit(__doc__)
    if sys.argv[1] == "write":
        write(Path(sys.argv[2]))
    else:
        sys.exit(check(sys.argv[2]))
