# SPDX-License-Identifier: MIT
"""Other programs in a sweep: the task that they get is the scene, and what they print of themselves is recorded."""

import ast
import json
import statistics
import sys
from random import Random

from case import Case
from drawn_scenes import Lists
from drawn_solves import drawn_problem
from program import Fault, Program
from properties import must_hold
from results import records
from table import Table

OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
COPY = "import shutil, sys\nshutil.copy(sys.argv[-1], 'task.json')\nsys.exit(77)\n"


def formula(node: ast.expr) -> str:
    """An expression of a task as a formula of an equation file, with every operation in parentheses."""
    match node:
        case ast.BinOp(left, operator, right):
            return f"({formula(left)} {OPERATORS[type(operator)]} {formula(right)})"
        case ast.UnaryOp(ast.USub(), operand):
            return f"(-{formula(operand)})"
        case ast.Call(ast.Name("power"), [base, exponent]):
            return f"({formula(base)}^{formula(exponent)})"
        case ast.Call(ast.Name(name), arguments):
            return f"{name}({', '.join(map(formula, arguments))})"
        case ast.Constant(value):
            return repr(value)
        case ast.Name(name):
            return name
    raise ValueError(ast.dump(node))


def file_of(task: dict) -> str:
    """An equation file with a row for each row of the task."""
    lines = [f"end = {task['end_time']!r}"]
    for i, (row, rhs) in enumerate(zip(task["rows"], task["system"]["rhs"], strict=True), 1):
        lines += [f"[unknown.y{i}]", f"order = {row['order']!r}", f'rhs = "{formula(ast.parse(rhs, mode="eval").body)}"',
                  f"initial = {row['initial']!r}"] + (["chain = false"] if row["order"] > 1 else [])
    return "\n".join(lines + [f"[[jump]]\nat = {t!r}" for t in task.get("jumps", [])])


def drawn_task(random: Random, lists: Lists) -> Case:
    # These rules depend on the rows only, not on what is known of the solution.
    scheme = random.choice(["product_trapezoidal", "adams_pc", "grunwald_letnikov"])
    return Case("the_task_of_a_program_is_the_scene", scheme=scheme, options={"--steps": str(random.randint(2, 60))},
                **drawn_problem(random, lists, files=0.4, wild=0.0, events=False))


@must_hold(drawn_task, 1.5)
def the_task_of_a_program_is_the_scene(program: Program, case: Case, lists: Lists) -> None:
    """A file with the formulas of the task as its rows has the solution of the scene, by the same rule with the same steps."""
    (program.folder / "copy.py").write_text(COPY)
    words = ("run", "--scene", case.problem()[0], *case.problem()[1:], "--steps", case.options["--steps"], "--repeat", "1", "--budget", "10",
             "--external", f"copy={sys.executable} copy.py", "--out", "copy.jsonl")
    if not program.run(*words, seconds=90).done:
        return
    task = json.loads((program.folder / "task.json").read_text())
    at_both_ends = any(row["side"] == "right" for row in task["rows"]) or any("final" in one for one in task.get("equations", []))
    if "system" not in task or at_both_ends:
        return
    (program.folder / "rows.toml").write_text(file_of(task))
    solve = ("--scheme", case.scheme, *case.given(), "--budget", "5")
    scene, rows = (program.run("solve", *problem, *solve) for problem in (case.problem(), ["rows.toml"]))
    if not (scene.done and rows.done):
        if scene.done:
            raise Fault("rows", f"the rows of the task cannot be solved: {rows.err.strip()}")
        return
    ours, theirs = Table.read(scene.out), Table.read(rows.out)
    for i, name in enumerate(task["system"]["columns"], 1):
        if name not in ours.names:
            continue
        values, others = ours.column(name), theirs.column(f"y{i}")
        largest = max(1.0, *(max(abs(value) for value in theirs.column(f"y{j}")) for j in range(1, len(task["rows"]) + 1)))
        for value, other in zip(values, others, strict=True):
            if abs(value - other) > 1e-6 * largest:
                raise Fault("differs", f"{name} of the scene is {value}, y{i} of the rows {other}")


COMMENTS = {"code": ["flmm2 1.1.0", "mine", "x" * 101, ""], "language": ["GNU Octave 7.3.0", "Rust", ""],
            "first": ["0.5", "1e-3", "0", "-1", "nan", "0.1 0.2"], "seconds": ["0.25", "0.1 0.3 0.2", "1e-9\t2e-9", "0.1 0", "soon", ""],
            "times": ["own", "mine", ""]}
VALID = {"code": {"flmm2 1.1.0", "mine"}, "language": {"GNU Octave 7.3.0", "Rust"}, "first": {"0.5", "1e-3"},
         "seconds": {"0.25", "0.1 0.3 0.2", "1e-9\t2e-9"}, "times": {"own"}}
PRINT = """import json, pathlib, sys
task = json.loads(pathlib.Path(sys.argv[-1]).read_text())
print(pathlib.Path('comments.txt').read_text(), end='')
print('t,y')
for t in task['times'][::2] if OWN else task['times']:
    print(f'{t!r},{1 - t / 2}')
"""


def drawn_comments(random: Random, lists: Lists) -> Case:
    keys = random.sample(list(COMMENTS), random.randint(0, len(COMMENTS)))
    lines = [f"# {key}: {random.choice(COMMENTS[key] if random.random() < 0.2 else sorted(VALID[key]))}" for key in keys]
    if lines and random.random() < 0.1:
        lines.append(random.choice(lines))
    return Case("comments_of_a_program_are_recorded", words=tuple(lines), options={"--steps": str(2 * random.randint(1, 30))})


@must_hold(drawn_comments, 0.7)
def comments_of_a_program_are_recorded(program: Program, case: Case, lists: Lists) -> None:
    """Valid comments before the header are recorded; of others the run says which is wrong."""
    given = [(line[2 : line.index(":")], line[line.index(":") + 1 :].strip()) for line in case.words]
    facts = dict(given)
    (program.folder / "comments.txt").write_text("".join(f"{line}\n" for line in case.words))
    (program.folder / "print.py").write_text(PRINT.replace("OWN", str("times" in facts)))
    ran = program.run("run", "--scene", "relaxation", *case.given(), "--repeat", "2", "--external", f"printed={sys.executable} print.py", "--out", "out.jsonl")
    if not ran.done:
        raise Fault("code", f"exit code {ran.code}: {ran.err.strip()}")
    (ending,) = records(program, "out.jsonl")
    wrong = {key for key, text in given if text not in VALID[key]} | {key for key, _ in given if [name for name, _ in given].count(key) > 1}
    if wrong:
        if ending["ending"] != "program_failed" or not any(key in ending["detail"] for key in wrong):
            raise Fault("wrong", f"{case.words}: {ending['ending']}, {ending.get('detail')}")
        return
    if ending["ending"] not in ("finished", "accuracy_lost"):
        raise Fault("ending", f"{case.words}: {ending['ending']}, {ending.get('detail')}")
    code, _, version = facts.get("code", "").partition(" ")
    expected = {"code": code, "version": version, "language": facts.get("language", "")}
    if ending.get("program", dict.fromkeys(expected, "")) != expected:
        raise Fault("program", f"{case.words}: {ending.get('program')}")
    times = ending["time"]
    if "seconds" not in facts:
        if not ending.get("wall_clock") or "time_start" in times:
            raise Fault("times", f"{case.words}: {sorted(times)}")
        return
    median = statistics.median(2 * [float(text) for text in facts["seconds"].split()])
    setup = max(0.0, float(facts.get("first", "0")) - median)
    if (abs(times["time_median"] - median) > 1e-12 or abs(times.get("time_setup", 0.0) - setup) > 1e-12
            or ("time_start" in times) != ("first" in facts)):
        raise Fault("times", f"{case.words}: {times}")
