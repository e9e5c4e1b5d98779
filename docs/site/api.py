# SPDX-License-Identifier: MIT
"""Pages of the interfaces: of C++ and C from the installed headers and their comments, of Python from docstrings and annotations.

A paragraph of a header that declares something becomes an entry: the names as its heading, its comment as text, its declarations
as they stand. Doxygen says which lines declare which names.
"""

import dataclasses
import importlib
import inspect
import re
import subprocess
import sys
import xml.etree.ElementTree
from collections import Counter, defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# page: its title, the folder of its headers; the first that fits
LIBRARIES = {
    "special_functions": ("C++: special functions", "reference/special_functions/"),
    "reference": ("C++: reference", "reference/"),
    "schemes": ("C++: schemes", "schemes/"),
    "benchmarks": ("C++: benchmarks", "benchmarks/"),
    "c": ("C", ""),
}
INTRODUCTION = {
    False: "The headers of `fdebench::{page}`. Names are in the namespace `fde`. How to link it: [from C++](../docs/library.md).",
    True: "How to use it: [from C](../docs/c.md).",
}
COMMENT = re.compile(r"//|/\*| \*")
LINE = 80  # characters that a signature may have in one line
ANNOTATION = re.compile(r"(: |-> )(?:ForwardRef\()?'([^']*)'\)?")  # inspect quotes those that are not evaluated
EXAMPLE = re.compile(r"^>>> .*\n?(?:.+\n?)*", re.MULTILINE)
WORD = re.compile(r"\w+")
DECLARED_ABOUT = re.compile(r"^\| `fdebench/(\S+)` \| [^|]* \| (.*) \|$", re.MULTILINE)  # in docs/library.md
DOXYFILE = """INPUT = {headers}
OUTPUT_DIRECTORY = {folder}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
ENABLE_PREPROCESSING = NO
QUIET = YES
WARN_AS_ERROR = YES
"""


def anchor(name):
    return name.lower()


# C++ and C


def declared(headers, folder):
    """{header: {(first line, last line): name}} of what is declared in a namespace, or at the top of a C header."""
    folder.mkdir(parents=True)
    (folder / "Doxyfile").write_text(DOXYFILE.format(headers=" ".join(str(ROOT / header) for header in headers), folder=folder))
    subprocess.run(["doxygen", "Doxyfile"], cwd=folder, check=True)
    found = defaultdict(dict)

    def note(element, name):
        at = element.find("location").attrib
        lines = [int(at[key]) for key in ("line", "bodystart", "bodyend") if int(at.get(key, 0)) > 0]
        found[Path(at["file"]).relative_to(ROOT).as_posix()][min(lines), max(lines)] = name

    for file in (folder / "xml").glob("*.xml"):
        for compound in xml.etree.ElementTree.parse(file).iter("compounddef"):
            kind, name = compound.get("kind"), compound.findtext("compoundname")
            if kind in {"class", "struct", "concept"}:
                note(compound, name.removeprefix("fde::"))
            elif kind in {"namespace", "file"}:
                within = "" if kind == "file" or name == "fde" else name.removeprefix("fde::") + "::"
                for member in compound.iter("memberdef"):
                    note(member, within + member.findtext("name"))
    return found


def paragraphs(lines, declarations):
    """(first line, lines) of the paragraphs of a header. They begin at blank lines and comments outside of declarations."""
    within = {line for first, last in declarations for line in range(first, last + 1)}
    first = 1
    for number, line in enumerate([*lines, ""], 1):
        is_blank = not line.strip()
        is_new = is_blank or (COMMENT.match(line) and number > first and not COMMENT.match(lines[number - 2]))
        if is_new and number not in within:
            yield first, lines[first - 1 : number - 1]
            first = number + is_blank


def escaped(line):
    """Markdown that shows the characters of a line; what stands in backticks is code there, too."""
    parts = line.split("`")
    parts[::2] = [re.sub(r"([*_\[])", r"\\\1", part).replace("<", "&lt;") for part in parts[::2]]
    return "`".join(parts)


def prose(comment):
    """Markdown of the text of a comment; its indented lines are formulas."""
    text = []
    for line in comment:
        is_formula = line.startswith("  ") and not line.lstrip().startswith("- ") and not (text and text[-1].startswith("- "))
        if text and is_formula != text[-1].startswith("    "):
            text.append("")
        text.append(f"    {line.strip()}" if is_formula else escaped(line))
    return "\n".join(text)


def public(code):
    """The lines of a class without those that only its members see."""
    is_private = False
    for line in code:
        is_private = line == " private:" or (is_private and line[:1] in {" ", ""})
        if not is_private:
            yield line


def entries(header, declarations):
    """Of each paragraph that declares something its names, its comment and its code."""
    for first, lines in paragraphs((ROOT / header).read_text().splitlines(), declarations):
        names = [name for (line, _), name in sorted(declarations.items()) if first <= line < first + len(lines)]
        lines = [line for line in lines if not re.match(r"#|namespace|}  // namespace|extern \"C\"", line)]
        comment = []
        while lines and COMMENT.match(lines[0]):
            comment.append(re.sub(r"^(// ?|/\* ?| \*(?!/) ?)|\*/$", "", lines.pop(0)))
        if names and lines:
            yield list(dict.fromkeys(names)), comment, list(public(lines))


def page_of_headers(page, headers, declarations, about, places):
    text = [f"# {LIBRARIES[page][0]}", "", INTRODUCTION[page == "c"].format(page=page), ""]
    anchors = Counter()
    for header in headers:
        included = Path(header).name if page == "c" else f"fdebench/{header}"
        text += [f"## {Path(header).name}", "", f"`#include <{included}>`" + (f": {about[header]}" if header in about else ""), ""]
        for names, comment, code in entries(header, declarations[header]):
            anchors[names[0]] += 1
            own = anchor(names[0]) + (f"-{anchors[names[0]]}" if anchors[names[0]] > 1 else "")
            text += ["### " + ", ".join(f"`{name}`" for name in names) + f" {{#{own}}}", "", prose(comment), ""]
            text += ["```cpp", *code, "```", ""]
            used = [word for word in dict.fromkeys(WORD.findall("\n".join(code))) if word[0].isupper() and word in places]
            links = [f"[`{word}`]({places[word]})" for word in used if not places[word].endswith(f"#{own}")]
            text += ["Uses " + ", ".join(links) + ".", ""] if links else []
    return "\n".join(text)


def write_headers(pages, headers, folder):
    headers = [header for header in headers if not header.endswith(".def")]
    declarations = declared(headers, folder)
    about = dict(DECLARED_ABOUT.findall((ROOT / "docs/library.md").read_text()))
    of_page = defaultdict(list)
    for header in headers:
        of_page[next(page for page, (_, start) in LIBRARIES.items() if header.startswith(start))].append(header)
    places = {}
    for page, its_headers in of_page.items():
        for header in its_headers:
            for names, _, _ in entries(header, declarations[header]):
                places |= {name.split("::")[-1]: f"{page}.md#{anchor(names[0])}" for name in names}
    for page, its_headers in of_page.items():
        (pages / f"{page}.md").write_text(page_of_headers(page, its_headers, declarations, about, places))


# Python


def docstring(thing):
    """Its docstring as Markdown: double backticks are code there, too; an example stands by itself."""
    text = inspect.getdoc(thing) or sys.exit(f"{thing}: has no docstring")
    return EXAMPLE.sub(lambda example: f"```pycon\n{example[0].rstrip()}\n```\n", text)


def signature(name, thing):
    if inspect.isclass(thing) and issubclass(thing, BaseException):
        return f"{name}({thing.__base__.__name__})"
    written = ANNOTATION.sub(r"\1\2", str(inspect.signature(thing))).removesuffix(" -> None")
    if len(name) + len(written) <= LINE:
        return name + written
    lines, before = [], None
    for parameter in inspect.signature(thing).parameters.values():
        if before is parameter.POSITIONAL_ONLY is not parameter.kind:
            lines.append("/")
        if before is not parameter.KEYWORD_ONLY is parameter.kind:
            lines.append("*")
        lines.append(ANNOTATION.sub(r"\1\2", str(parameter)))
        before = parameter.kind
    result = written[written.rindex(") ->") :] if ") ->" in written else ")"
    return f"{name}(\n" + "".join(f"    {line},\n" for line in lines) + result


def members(cls):
    """What a class gives beside its constructor: properties, fields of a record."""
    fields = [field.name for field in dataclasses.fields(cls)] if dataclasses.is_dataclass(cls) else getattr(cls, "_fields", [])
    yield from ((name, None) for name in fields)
    for base in reversed([base for base in cls.__mro__ if base.__module__.startswith("fdebench")]):
        yield from ((name, value) for name, value in vars(base).items() if isinstance(value, property))


def write_python(pages, folder):
    sys.path.insert(0, str(folder))
    package = importlib.import_module("fdebench")
    text = ["# Python", "", docstring(package), "", "How to use it: [from Python](../docs/python.md).", ""]
    for name in sorted(package.__all__, key=lambda name: (name[0].isupper(), name)):
        thing = getattr(package, name)
        if not callable(thing):
            continue
        kind = "class " if inspect.isclass(thing) else ""
        text += [f"## `{name}` {{#{anchor(name)}}}", "", "```python", kind + signature(name, thing), "```", ""]
        text += [docstring(thing), ""]
        rows = [f"| `{member}` | {inspect.getdoc(value) if value else ''} |" for member, value in members(thing)] if kind else []
        text += ["| attribute | |", "|---|---|", *rows, ""] if rows else []
    (pages / "python.md").write_text("\n".join(text))


def write(pages, headers, doxygen, python):
    write_headers(pages, headers, doxygen)
    write_python(pages, python)
