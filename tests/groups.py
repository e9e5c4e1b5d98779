#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tests of GoogleTest programs as tests of ctest, in its language: groups.py ALONE BY_PARAMETER LONG SECONDS PROGRAM...

A test of ctest is a suite, in one process: processes start more slowly than most cases run. A case whose name has a match of the
regular expression ALONE is a test by itself, under its own name; a suite that matches BY_PARAMETER is a test for each value of its
parameter, SUITE/VALUE. ctest begins with the suites that match LONG. SECONDS limit a group and so each of its cases.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path


def suites(program):
    """(suite, names of its cases), as the program lists them."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "list.json")
        subprocess.run([program, "--gtest_list_tests", f"--gtest_output=json:{file}"], stdout=subprocess.DEVNULL, check=True)
        for suite in json.loads(file.read_text())["testsuites"]:
            yield suite["name"], [case["name"] for case in suite["testsuite"]]


def groups(program, alone, by_parameter):
    """(name of a group, pattern that selects its cases)."""
    for suite, cases in suites(program):
        single = [f"{suite}.{case}" for case in cases if re.search(alone, f"{suite}.{case}")]
        yield from zip(single, single)
        if len(single) == len(cases):
            continue
        if re.fullmatch(by_parameter, suite):
            for value in dict.fromkeys(case.partition("/")[2] for case in cases):
                yield f"{suite}/{value}", f"{suite}.*/{value}"
        else:
            yield suite, f"{suite}.*" + ("-" + ":".join(single) if single else "")


def main(alone, by_parameter, long, seconds, *programs):
    for program in programs:
        if not Path(program).exists():
            print(f"add_test({Path(program).name}_NOT_BUILT {program})")
            continue
        for name, pattern in groups(program, alone, by_parameter):
            print(f"add_test([==[{name}]==] [==[{program}]==] [==[--gtest_filter={pattern}]==])")
            skipped = r" SKIP_REGULAR_EXPRESSION [==[\[  SKIPPED \]]==]" if name == pattern else ""
            cost = " COST 30" if re.search(long, name) else ""
            print(f"set_tests_properties([==[{name}]==] PROPERTIES TIMEOUT {seconds}{skipped}{cost})")


main(*sys.argv[1:])
