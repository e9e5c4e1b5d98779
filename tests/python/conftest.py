# SPDX-License-Identifier: MIT
"""The command beside the module under test, and no references kept from one run to the next."""

import os

FDEBENCH = os.environ["FDEBENCH"]
os.environ["FDEBENCH_CACHE"] = ""
