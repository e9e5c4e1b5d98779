# SPDX-License-Identifier: MIT
"""Studies: plan, run, the shards of a plan, and wrong files."""

import json
import re
from random import Random

from case import FILE, Case
from drawn_scenes import Lists
from drawn_studies import damaged, drawn_study
from program import Fault, Program
from properties import must_hold
from results import require_same_runs


def drawn_whole_study(random: Random, lists: Lists) -> Case:
    return Case("the_shards_of_a_plan_are_the_study", file=drawn_study(random, lists), options={"--shards": str(random.randint(1, 4))})


@must_hold(drawn_whole_study, 0.4)
def the_shards_of_a_plan_are_the_study(program: Program, case: Case, lists: Lists) -> None:
    """A plan counts the runs; its shards, run and merged, have the rows of the study; a second run of a file adds none."""
    planned = program.run("study", "plan", FILE, *case.given(), "--out", "parts", seconds=60)
    whole = program.run("run", "--study", FILE, "--out", "whole.jsonl", seconds=120)
    if planned.code != whole.code:
        raise Fault("plan", f"plan ends with {planned.code}, run with {whole.code}: {planned.err or whole.err}", planned.arguments)
    if not whole.done:
        return
    plan = json.loads((program.folder / "parts/plan.json").read_text())
    runs = (program.folder / "whole.jsonl").read_text().count('"ending":')
    if not planned.out.startswith(f"{runs} runs of ") or runs != sum(shard["runs"] for shard in plan["shards"]):
        raise Fault("count", f"{runs} runs are made, the plan says {planned.out.splitlines()[0]}", planned.arguments)
    before = (program.folder / "whole.jsonl").read_bytes()
    program.run("run", "--study", FILE, "--out", "whole.jsonl", seconds=120)
    if (program.folder / "whole.jsonl").read_bytes() != before:
        raise Fault("again", "a second run of a study adds to its file")
    names = [f"{shard['file']}.jsonl" for shard in plan["shards"]]
    for shard, name in zip(plan["shards"], names):
        if not program.run("run", "--study", f"parts/{shard['file']}", "--out", name, seconds=120).done:
            raise Fault("shard", f"{shard['file']} fails where the study does not")
    require_same_runs(program, "whole.jsonl", names)


def drawn_wrong_study(random: Random, lists: Lists) -> Case:
    return Case("a_wrong_study_is_refused_in_a_line", file=damaged(random, drawn_study(random, lists)))


@must_hold(drawn_wrong_study, 0.6)
def a_wrong_study_is_refused_in_a_line(program: Program, case: Case, lists: Lists) -> None:
    """A refusal names file, line and column; what `run` takes, it takes before anything runs, and so does `study plan`."""
    ran = program.run("run", "--study", FILE, "--dry-run", seconds=60)
    planned = program.run("study", "plan", FILE, "--out", "parts", seconds=60)
    if ran.code != planned.code:
        raise Fault("agree", f"run ends with {ran.code}, plan with {planned.code}: {ran.err or planned.err}", planned.arguments)
    if ran.code == 2 and not re.match(rf"fdebench: {FILE}: line \d+, column \d+: ", ran.err):
        raise Fault("place", f"says no place: {ran.err!r}", ran.arguments)
    if planned.code != 0 and (program.folder / "parts").exists():
        raise Fault("half", "a refused study leaves files", planned.arguments)
