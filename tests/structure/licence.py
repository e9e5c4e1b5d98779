#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every source, but for the examples in docs that pages show, names its licence in its first lines. One line for each fault."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = [f"*.{suffix}" for suffix in "c h h.in map cpp hpp def S py pyi js mjs css cmake sh jl m".split()] + ["CMakeLists.txt", "benchmarks/*.toml", ".ci/*", ":!docs"]
LINE = "SPDX-License-Identifier: MIT"


def main():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "--", *SOURCES], cwd=ROOT, capture_output=True,
                            text=True, check=True)
    missing = [name for name in listed.stdout.splitlines() if (ROOT / name).is_file()
               and not any(LINE in line for line in (ROOT / name).read_text().splitlines()[:2])]
    print(*([f"{name}: does not say {LINE}" for name in missing] or ["every source names its licence"]), sep="\n")
    return bool(missing)


sys.exit(main())
