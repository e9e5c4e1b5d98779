# SPDX-License-Identifier: MIT
"""--quiet, --help and completion beside any other options."""

from dataclasses import replace
from random import Random

from case import Case
from drawn_scenes import Lists
from drawn_solves import drawn_solve
from program import Fault, Outcome, Program
from properties import must_hold

NOTES = ("fdebench: event",)


def drawn_beside(random: Random, lists: Lists) -> Case:
    case = drawn_solve(random, lists)
    options = {name: value for name, value in case.options.items() if not name.startswith(("--checkpoint", "--strict"))}
    return replace(case, holds="help_and_quiet_go_with_all_options", options=options, words=(str(random.randint(0, 30)),))


def results(ended: Outcome) -> tuple[int, str, str]:
    """Exit code, output and error. Whether there is a warning depends on the time of a run."""
    return ended.code, ended.out, "" if ended.done else ended.err


@must_hold(drawn_beside)
def help_and_quiet_go_with_all_options(program: Program, case: Case, lists: Lists) -> None:
    """--quiet changes no result and no error; --help anywhere prints the help; a completion begins as the word does."""
    words = [*case.problem(), "--scheme", case.scheme, *case.given()]
    place = int(case.words[0]) % (len(words) + 1)
    loud = program.run("solve", *words)
    quiet = program.run("solve", *words, "--quiet")
    if any(line.startswith(NOTES) for line in quiet.err.splitlines()):
        raise Fault("note", f"--quiet leaves {quiet.err!r}", quiet.arguments)
    ran_out = any("budget" in ended.err or "seconds" in ended.err for ended in (loud, quiet))
    if not ran_out and results(loud) != results(quiet):
        raise Fault("quiet", f"ends with {quiet.code}, {quiet.err!r}; without --quiet with {loud.code}, {loud.err!r}", quiet.arguments)
    before = words[place - 1] if place > 0 else ""
    if not before.startswith("--") or before in ("--check", "--strict", "--cost", "--all", "--events"):
        helped = program.run("solve", *words[:place], "--help", *words[place:])
        if helped.out != program.run("help", "solve").out:
            raise Fault("help", f"--help prints {helped.out[:200]!r}", helped.arguments)
    begun = [*words[:place], words[place][: (len(words[place]) + 1) // 2] if place < len(words) else ""]
    offered = program.run("__complete", "solve", *begun)
    for line in offered.out.splitlines():
        if not line.startswith("\t") and not line.startswith(begun[-1]):
            raise Fault("completion", f"offers {line!r} for {begun[-1]!r}", offered.arguments)
