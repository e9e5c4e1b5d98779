# SPDX-License-Identifier: MIT
"""`fit` on exact solutions with known residuals."""

import math
from dataclasses import replace
from random import Random

from case import Case
from drawn_numbers import spread, typed
from drawn_scenes import Lists
from drawn_solves import drawn_problem
from errors import end_of
from program import Fault, Outcome, Program
from properties import must_hold
from table import Table


def numbers_of(case: Case, lists: Lists) -> dict[str, float]:
    """The parameters that are numbers, with the values that the case has."""
    if case.scene:
        values = {one["name"]: case.chosen.get(one["name"], one["default"]) for one in lists.scenes[case.scene]["parameters"]}
    else:
        lines = [line.split("#")[0] for line in case.file]
        start = lines.index("[parameters]") + 1 if "[parameters]" in lines else len(lines)
        section = lines[start:next((k for k in range(start, len(lines)) if lines[k].startswith("[")), len(lines))]
        values = {name.strip(): value.split("value =")[-1].split(",")[0].strip(" }") for name, _, value in (line.partition("=") for line in section)}
    found = {}
    for name, value in values.items():
        try:
            found[name] = float(value)
        except (TypeError, ValueError):
            continue
    return found


def drawn_fit(random: Random, lists: Lists) -> Case:
    case = Case("a_fit_leaves_less_than_its_start", **drawn_problem(random, lists, files=0.5, wild=0))
    names = list(numbers_of(case, lists))
    varied = random.sample(names, min(len(names), random.randint(1, 3)))
    options = {"--vary": ",".join(varied), "--budget": "5"} | random.choice([{}, {}, {"--confidence": "0.9"}, {"--scheme": "radau_exponentials"}, {"--residuals": "left.csv"}])
    options |= random.choice([{}, {"--json": ""}])
    end = typed(end_of(case, lists) * spread(random, 0.1, 1), 3)
    return replace(case, options=options, chosen={**case.chosen, "until": end}, words=(typed(random.uniform(0.97, 1.03)), str(random.randint(6, 30))))


def measurements(program: Program, case: Case) -> Table | None:
    """The first columns of the exact solution, with noise of a sine and its size as standard deviation: exit code 0, or None."""
    end, count = float(case.chosen["until"]), int(case.words[1])
    times = ",".join(repr(end * (k + 1) / count) for k in range(count - 1)) + "," + case.chosen["until"]
    known = program.run("exact", *case.problem(), "--at", times, "--budget", "4")
    if not known.done:
        return None
    table = Table.read(known.out)
    names = table.unknowns[:2]
    sizes = {name: 0.01 * max(map(abs, table.column(name))) or 1.0 for name in names}
    if not all(1e-100 < size < 1e100 for size in sizes.values()):
        return None
    rows = [[t, *(text for name in names for text in (repr(float(row[table.names.index(name)]) + sizes[name] * math.sin(7.0 * k)), repr(sizes[name])))]
            for k, (t, row) in enumerate(zip((row[0] for row in table.rows), table.rows))]
    return Table(["t", *(f"{prefix}{name}" for name in names for prefix in ("", "sd_"))], rows)


def chi_squared(judged: Outcome) -> float | None:
    values = [float(line.split()[1]) for line in judged.out.splitlines() if line.startswith("chi_squared ")]
    return values[0] if judged.done and values else None


@must_hold(drawn_fit, 1.5)
def a_fit_leaves_less_than_its_start(program: Program, case: Case, lists: Lists) -> None:
    """chi^2 of the estimates, by the reference in judge, is what fit says, and at most that of the true parameters."""
    table = measurements(program, case)
    if table is None:
        return
    (program.folder / "data.csv").write_text("\n".join(",".join(row) for row in [table.names, *table.rows]) + "\n")
    numbers = numbers_of(case, lists)
    started = {name: typed(numbers[name] * float(case.words[0]), 6) for name in case.options["--vary"].split(",") if name in numbers}
    start = replace(case, chosen={**case.chosen, **started})
    fitted = program.run("fit", *start.problem(), "data.csv", *case.given(), seconds=120)
    if (program.folder / "left.csv").exists() and not fitted.done:
        raise Fault("half", "a fit that failed wrote its residuals")
    if not fitted.done or "--json" in case.options:
        return
    said = chi_squared(fitted)
    scene = next(line for line in fitted.out.splitlines() if line.startswith("scene ")).removeprefix("scene ")
    found = chi_squared(program.run("judge", scene, "data.csv", seconds=60))
    true = chi_squared(program.run("judge", *case.problem(), "data.csv", seconds=60))
    if found is not None and abs(said - found) > 1e-3 * (1 + found):
        raise Fault("chi squared", f"fit says {said}, judge {found}, of {scene}")
    if found is not None and true is not None and found > 1.001 * true + 0.01:
        raise Fault("minimum", f"the estimates leave {found}, the true parameters {true}")
