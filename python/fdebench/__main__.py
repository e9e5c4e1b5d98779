# SPDX-License-Identifier: MIT
"""The command `fdebench`, in this process: python -m fdebench."""

import signal
import sys

from . import _core


def main() -> int:
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C ends a computation at once
    return _core.program(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
