# SPDX-License-Identifier: MIT
"""Results files: run, judge, merge, export, compare, choose and plot are consistent with each other."""

import csv
import json
import re
import shutil
import sqlite3
import sys
from dataclasses import replace
from pathlib import Path
from random import Random

from case import Case
from drawn_numbers import spread, typed
from drawn_scenes import Lists, drawn_scene
from drawn_solves import accuracy, drawn_problem
from program import Fault, Program
from properties import must_hold

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks" / "programs" / "records"))
from recorded_runs import runs_in  # noqa: E402

def records(program: Program, name: str) -> list[dict]:
    return runs_in(program.folder / name)


def untimed_facts(program: Program, name: str) -> set[str]:
    """The runs without what depends on the load of the machine."""
    runs = records(program, name)
    for run in runs:
        run["values"].pop("rounding", None)
        run["time"] = bool(run["time"])
    return {json.dumps(run, sort_keys=True) for run in runs}


def drawn_run(random: Random, lists: Lists) -> Case:
    scheme = random.choice([name for name, one in lists.schemes.items() if one["takes_grid"]])
    options = {"--steps": str(random.choice([random.randint(1, 60), random.randint(60, 3000)]))}
    if random.random() < 0.3:
        options["--grid"] = random.choice(["graded:2", "graded:auto"])
    return Case("judge_agrees_with_run", scheme=scheme, options=options, **drawn_problem(random, lists, files=0.3, wild=0.1))


@must_hold(drawn_run, 1.5)
def judge_agrees_with_run(program: Program, case: Case, lists: Lists) -> None:
    """The errors that judge measures in the output of solve equal the errors that run records."""
    ran = program.run("run", "--scene", case.problem()[0], *case.problem()[1:], "--scheme", case.scheme, *case.given(), "--repeat", "1", "--budget", "2",
                      "--out", "run.jsonl", seconds=90)
    solved = program.run("solve", *case.problem(), "--scheme", case.scheme, *case.given(), "--budget", "2")
    if not (ran.done and solved.done):
        return
    (program.folder / "own.csv").write_text(solved.out)
    judged = program.run("judge", *case.problem(), "own.csv", seconds=90)
    if not judged.done:
        raise Fault("judge", f"judge refuses what solve printed: {judged.err.strip()}")
    ours = {name: value for run in records(program, "run.jsonl") for name, value in run["values"].items() if name.startswith("error_")}
    for line in judged.out.splitlines():
        name, value = line.split()[:2]
        if name in ours and abs(float(value) - ours[name]) > 1e-9 * abs(ours[name]) + 1e-15:
            raise Fault("differs", f"judge says {line}, run {ours[name]}")


def require_same_runs(program: Program, whole: str, shards: list[str]) -> None:
    """Merges the shards: they have the runs of the whole, except the times, unless one was out of its budget."""
    if not program.run("merge", *shards, "--out", "merged.jsonl").done:
        raise Fault("merge", "the shards cannot be merged")
    if any('"out_of_budget"' in (program.folder / name).read_text() for name in (whole, "merged.jsonl")):
        return
    ours, theirs = (untimed_facts(program, name) for name in (whole, "merged.jsonl"))
    if ours != theirs:
        raise Fault("runs", f"the shards and the whole differ in {sorted(ours ^ theirs)[0][:300]}")


def drawn_sweep(random: Random, lists: Lists) -> Case:
    scenes = []
    for _ in range(random.randint(2, 4)):
        case = Case("", *drawn_scene(random, lists, 0.1)[:1])
        scenes.append(case.scene)
    words = [word for scene in dict.fromkeys(scenes) for word in ("--scene", scene)]
    schemes = random.sample(list(lists.schemes), 2)
    return Case("shards_are_the_whole", words=tuple(words + [w for s in schemes for w in ("--scheme", s)]),
                options={"--steps": f"{random.randint(4, 30)},{random.randint(31, 90)}"} | ({"--accuracy": "1e-3"} if random.random() < 0.5 else {}))


@must_hold(drawn_sweep, 0.6)
def shards_are_the_whole(program: Program, case: Case, lists: Lists) -> None:
    """Merged shards have the runs of the whole sweep, except the times; a file compared with itself has no changes."""
    words = (*case.words, *case.given(), "--repeat", "1", "--budget", "2")
    whole = program.run("run", *words, "--out", "whole.jsonl", seconds=120)
    if not whole.done:
        return
    for k in ("1", "2"):
        if not program.run("run", *words, "--shard", f"{k}/2", "--out", f"shard{k}.jsonl", seconds=120).done:
            raise Fault("shard", f"shard {k}/2 fails where the whole does not")
    require_same_runs(program, "whole.jsonl", [name for name in ("shard1.jsonl", "shard2.jsonl") if (program.folder / name).exists()])
    compared = program.run("compare", "whole.jsonl", "whole.jsonl", "--require-all", "--max-slowdown", "1.5")
    if not compared.done or "0 grew, 0 fell" not in compared.out:
        raise Fault("compare", f"a file beside itself: exit code {compared.code}, {compared.out[-300:]!r}")


def drawn_damage(random: Random, lists: Lists) -> Case:
    damage = random.choice(["none", "none", "a byte", "a line", "the end"])
    return replace(drawn_sweep(random, lists), holds="tables_hold_the_runs", chosen={"damage": damage, "place": f"{random.random():.6f}"})


def damaged(data: bytes, damage: str, place: float) -> bytes:
    at = int(place * len(data))
    if damage == "a byte":
        return data[:at] + b"\x7f" + data[at + 1 :]
    if damage == "a line":
        lines = data.splitlines(keepends=True)
        return b"".join(lines[: int(place * len(lines))] + lines[int(place * len(lines)) + 1 :])
    return data[:at] if damage == "the end" else data


@must_hold(drawn_damage, 0.6)
def tables_hold_the_runs(program: Program, case: Case, lists: Lists) -> None:
    """The tables of merged shards hold their runs, in SQLite as in CSV; what compare refuses export refuses, in the same words."""
    words = (*case.words, *case.given(), "--repeat", "1", "--budget", "2")
    for k in ("1", "2"):
        if not program.run("run", *words, "--shard", f"{k}/2", "--out", f"shard{k}.jsonl", seconds=120).done:
            return
    present = [name for name in ("shard1.jsonl", "shard2.jsonl") if (program.folder / name).exists()]
    if not program.run("merge", *present, "--out", "merged.jsonl").done:
        raise Fault("merge", "the shards cannot be merged")
    file = program.folder / "merged.jsonl"
    file.write_bytes(damaged(file.read_bytes(), case.chosen.get("damage", "none"), float(case.chosen.get("place", "0"))))
    compared = program.run("compare", "merged.jsonl", "merged.jsonl")
    made = {kind: program.run("export", "merged.jsonl", "--to", kind, "--out", kind) for kind in ("sqlite", "csv")}
    for kind, ended in made.items():
        unread = not compared.done and "no run" not in compared.err
        if ended.done == unread or (unread and ended.err != compared.err):
            raise Fault("refused", f"export to {kind}: {ended.err.strip()!r}, compare: {compared.err.strip()!r}")
        if (program.folder / kind).exists() != ended.done or list(program.folder.glob("*.tmp")):
            raise Fault("half", f"export to {kind} leaves {sorted(path.name for path in program.folder.iterdir())}")
    if not all(ended.done for ended in made.values()):
        return
    for table in ("results", "runs"):
        with (program.folder / "csv" / f"{table}.csv").open(newline="") as text:
            count = sum(1 for _ in csv.reader(text)) - 1
        with sqlite3.connect(program.folder / "sqlite") as database:
            if (count,) != database.execute(f"SELECT count(*) FROM {table}").fetchone():
                raise Fault("csv", f"{table}.csv has {count} rows")
        database.close()
    shutil.rmtree(program.folder / "csv")
    if case.chosen.get("damage") == "a byte":  # which lines are left out is another question
        return
    with sqlite3.connect(program.folder / "sqlite") as database:
        query = "SELECT scene, scheme, steps, quantity, value FROM results JOIN runs USING (run_id) JOIN scenes USING (scene_id)"
        ends = "SELECT scene, scheme, steps, 'ending', ended_at FROM runs JOIN scenes USING (scene_id) WHERE ending IS NOT NULL"
        stored = sorted(database.execute(f"{query} UNION ALL {ends}"))
    database.close()
    file.write_bytes(file.read_bytes().rpartition(b"\n")[0] + b"\n")  # without a torn last line
    written = sorted((run["scene"], run["scheme"], run["steps"], name, value) for run in records(program, "merged.jsonl")
                     for name, value in ({**run["values"], **run["time"], "ending": run.get("ended_at", run["end"])}).items())  # fmt: skip
    if stored != written:
        raise Fault("rows", f"the tables hold {len(stored)} rows, the file {len(written)}")


def drawn_choice(random: Random, lists: Lists) -> Case:
    return Case("what_is_chosen_is_within_the_error", options={"--error": accuracy(random, 1e-8)} | random.choice([{}, {"--norm": "end"}]) | random.choice([{}, {"--runs": "1"}]),
                **drawn_problem(random, lists, files=0.5, wild=0.1))


@must_hold(drawn_choice, 0.8)
def what_is_chosen_is_within_the_error(program: Program, case: Case, lists: Lists) -> None:
    """The run recommended by choose has an error, as measured by judge, within the requested accuracy."""
    chosen = program.run("choose", *case.problem(), *case.given(), "--max-time", "2", "--json", seconds=120)
    if not chosen.done:
        return
    answer = json.loads(chosen.out)
    if answer.get("estimated") or answer["grid"] is None:
        return
    ended = program.run("solve", *case.problem(), "--scheme", answer["scheme"], "--steps", str(answer["steps"]), "--grid", answer["grid"])
    if not ended.done:
        raise Fault("fails", f"what was chosen ends: {ended.err.strip()}")
    (program.folder / "own.csv").write_text(ended.out)
    judged = program.run("judge", *case.problem(), "own.csv", seconds=90)
    name = "error_end_mixed" if "--norm" in case.options else "error_maximum_mixed"
    values = [float(line.split()[1]) for line in judged.out.splitlines() if line.startswith(name + " ")]
    if values and values[0] > 1.01 * float(case.options["--error"]):
        raise Fault("error", f"{answer['scheme']} with N = {answer['steps']} has {name} {values[0]:.3g}")


def drawn_choice_beside_others(random: Random, lists: Lists) -> Case:
    kinds = [{}, {"--norm": "end"}, {"--scale": "relative"}, {"--scale": "absolute", "--norm": "end"}]
    return Case("a_slower_scheme_has_a_slower_run", options={"--error": accuracy(random, 1e-10)} | random.choice(kinds),
                **drawn_problem(random, lists, files=0.4, wild=0.2))


@must_hold(drawn_choice_beside_others, 0.5)
def a_slower_scheme_has_a_slower_run(program: Program, case: Case, lists: Lists) -> None:
    """Each scheme that choose calls slower has a run outside the accuracy that takes longer than the answer."""
    chosen = program.run("choose", *case.problem(), *case.given(), "--max-time", "4", "--json", seconds=120)
    if not chosen.done:
        return
    answer, noise = json.loads(chosen.out), 0.7  # the machine may be busy while the answer is timed
    for other in answer["others"]:
        if other["outcome"].startswith("slower") and not (other["seconds"] or 0.0) > noise * answer["seconds"]:
            raise Fault("unsupported", f"{other} is called slower than {answer['seconds']:.3g} s")
        if other["outcome"] == "within" and other["seconds"] < noise * answer["seconds"] and other["error"] <= answer["error"]:
            raise Fault("not the quickest", f"{other} is quicker than {answer['seconds']:.3g} s")


FIGURES_OF_RUNS = ("work-precision", "memory", "rate", "accuracy")
FIGURE_SCHEMES = ("l1", "bdf4", "adams_pc", "spectral_collocation", "adaptive_pc")


def drawn_figure(random: Random, lists: Lists) -> Case:
    kind = random.choice([*FIGURES_OF_RUNS, "solution", "phase", "motion", "stability"])
    problem = drawn_problem(random, lists, files=0.3, wild=0.1)
    others = tuple(drawn_scene(random, lists, 0.1)[0] for _ in range(random.choice([0, 0, 1, 2])))
    wanted = {
        "--width": random.choice(["3.4", "7", str(round(random.uniform(1, 9), 2))]), "--x-label": "t = 1 (s)", "--y-label": random.choice(["error", "a \"b\" <c> & π"]),
        "--x-axis": random.choice(["log", "linear"]), "--y-axis": random.choice(["log", "linear"]), "--legend": random.choice(["labels", "bottom", "right", "none"]),
        "--name": f"{random.choice([*lists.schemes])}=constructor",
    }
    style = {name: value for name, value in wanted.items() if random.random() < 0.3}
    return Case("figures_are_drawn", words=others, options={"--kind": kind, **style}, **problem)


def drawn_page(random: Random, lists: Lists) -> Case:
    schemes = random.sample(list(lists.schemes), 3)
    listed = {"--steps": f"{random.randint(4, 60)},{random.randint(61, 300)}", "--accuracy": "1e-3"}
    return Case("a_page_is_a_function_of_its_file", words=tuple(word for scheme in schemes for word in ("--scheme", scheme)),
                options=random.choice([listed, {}]) | {"--budget": "1"}, **drawn_problem(random, lists, files=0.5, wild=0.1))


@must_hold(drawn_page, 0.5)
def a_page_is_a_function_of_its_file(program: Program, case: Case, lists: Lists) -> None:
    """The page of a results file is the same without the equation file, without a cache and in another time zone and language."""
    words = [*case.problem()]
    ran = program.run("run", "--scene", words[0], *words[1:], *case.words, *case.given(), "--repeat", "1", "--out", "run.jsonl", seconds=120)
    if not ran.done:
        return
    usual = program.environment
    first = program.run("report", "run.jsonl", "--out", "first", seconds=60)
    try:
        for file in program.folder.glob("*.toml"):
            file.unlink()
        program.environment = {**usual, "FDEBENCH_CACHE": str(program.folder / "empty"), "TZ": "Asia/Tokyo", "LC_ALL": "de_DE.UTF-8",
                               "HOME": str(program.folder)}
        second = program.run("report", "run.jsonl", "--out", "second", seconds=60)
    finally:
        program.environment = usual
    if first.done != second.done:
        raise Fault("page", f"one report ends with {first.err or second.err}")
    if first.done and (program.folder / "first/index.html").read_bytes() != (program.folder / "second/index.html").read_bytes():
        raise Fault("page", "two pages of one file differ")
    if (program.folder / "empty").exists():
        raise Fault("cache", "report computes a reference")


@must_hold(drawn_figure, 0.5)
def figures_are_drawn(program: Program, case: Case, lists: Lists) -> None:
    """A figure has the width and the panels that are asked for and no NaN, or the refusal says why in our words."""
    scene, *settings = case.problem()
    scenes, results = [scene, *case.words], []
    if case.options["--kind"] in FIGURES_OF_RUNS:
        asked = [word for name in scenes for word in ("--scene", name)] + [word for name in FIGURE_SCHEMES for word in ("--scheme", name)]
        resolution = ["--accuracy", "1e-2,1e-4"] if case.options["--kind"] == "accuracy" else ["--steps", "8,16,32"]
        program.run("run", *asked, *settings, *resolution, "--repeat", "1", "--budget", "0.2", "--out", "run.jsonl", seconds=120)
        results = ["--results", "run.jsonl"]
    for out in ("figure.vl.json", "figure.svg"):
        ended = program.run("plot", *scenes, *settings, *results, *case.given(), "--out", out, seconds=120)
        if re.search(r"\.cjs|not defined|undefined|not a function|Cannot read|is not iterable|Invalid|Unexpected", ended.err):
            raise Fault("script", ended.err)
        if not ended.done:
            return
        text = (program.folder / out).read_text()
        if out.endswith(".json"):
            spec = json.loads(text)
            if len(spec.get("hconcat", [spec])) != len(scenes):
                raise Fault("panels", f"{len(scenes)} scenes, {len(spec['hconcat'])} panels")
        elif "NaN" in text:
            raise Fault("nan", "a figure has a NaN")
        elif abs(float(re.search(r'width="([\d.]+)"', text)[1]) - 96 * float(case.options.get("--width", "7" if case.words else "3.4"))) > 0.06:
            raise Fault("width", re.search(r"<svg[^>]*>", text)[0])
