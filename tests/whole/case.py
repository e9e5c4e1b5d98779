# SPDX-License-Identifier: MIT
"""A test case: a problem (a scene or an equation file), the options of a command and the property to check. `kept/` stores one a file."""

import json
import re
import shlex
from dataclasses import asdict, dataclass, field
from pathlib import Path

FILE = "case.toml"


def magnitude(text: str) -> str:
    """The order of magnitude of a number, "e-03"."""
    return f"{float(text):.0e}"[1:]


@dataclass(frozen=True)
class Case:
    holds: str  # name of the property to check
    scene: str = ""  # empty: the problem is `file`
    file: tuple[str, ...] = ()  # lines of the equation file
    chosen: dict[str, str] = field(default_factory=dict)  # parameters, and `until`
    scheme: str = ""
    options: dict[str, str] = field(default_factory=dict)  # of the command; an empty value is a flag
    words: tuple[str, ...] = ()  # further data of the property

    def problem(self) -> list[str]:
        """The problem as command-line arguments, with --set and the end in the scene's name where necessary."""
        name = self.scene or FILE
        until = [f"until={self.chosen['until']}"] if "until" in self.chosen else []
        chosen = [f"{key}={value}" for key, value in self.chosen.items() if key != "until"]
        if any("," in value or ":" in value for value in self.chosen.values()):
            return [":".join([name, *until]), *(word for one in chosen for word in ("--set", one))]
        return [name + (":" if until or chosen else "") + ",".join(until + chosen)]

    def given(self, *names: str) -> list[str]:
        """The options with these names as arguments; all options if no names are given."""
        chosen = {key: value for key, value in self.options.items() if not names or key in names}
        return [word for key, value in chosen.items() for word in ([key, value] if value else [key])]

    def write(self, folder: Path) -> None:
        if self.file:
            (folder / FILE).write_text("\n".join(self.file) + "\n")

    def features(self) -> set[tuple[str, str]]:
        """The features of the case as (group, value), for the coverage of pairs."""
        found = {("property", self.holds), ("problem", self.scene or ("file" if self.file else "none")), ("scheme", self.scheme or "none")}
        found |= {("option", key) for key in self.options}
        for key in ("--grid", "--history"):
            found.add((key, self.options.get(key, "default").split(":")[0]))
        for key in ("--steps", "--accuracy", "--tolerance"):
            if key in self.options:
                found |= {(key, magnitude(one)) for one in self.options[key].split(",")}
        if "formulation" in self.chosen:
            found.add(("formulation", self.chosen["formulation"]))
        text = "\n".join(self.file)
        found |= set(re.findall(r'^(formulation|principle) = "(\w+)"', text, re.MULTILINE))
        found |= {("formula", name) for name in re.findall(r"\b([a-z_0-9]+)\(", text)}
        found |= {("section", name) for name in re.findall(r"^\[+([a-z]+)", text, re.MULTILINE)}
        return found

    def json(self) -> str:
        return json.dumps(asdict(self), indent=1) + "\n"

    @staticmethod
    def read(path: Path) -> "Case":
        fields = json.loads(path.read_text())
        return Case(**{**fields, "file": tuple(fields["file"]), "words": tuple(fields["words"])})


def shell(case: Case, arguments: tuple[str, ...]) -> str:
    """The command as typed in a shell, after a command that writes its equation file."""
    file = f"cat >{FILE} <<'END'\n" + "\n".join(case.file) + "\nEND\n" if case.file else ""
    return file + "fdebench " + shlex.join(arguments)
