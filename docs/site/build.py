#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""build.py BUILD SITE HEADERS RESULTS [--quick]: writes the documentation as a site to the folder SITE.

BUILD is the build folder of cmake, with the program, the Python module and the figures. HEADERS is a file that lists the
installed headers. RESULTS are those of the map. The pages are copied into one folder, which has the paths of the repository,
so that their links hold; MkDocs makes the site from it. Each `console` block is run, and the site shows what it printed; the
build ends where that differs from what the page shows. --quick copies the blocks as they are and leaves out the notebooks.
Needs mkdocs-material and doxygen: ./setup.sh --tests.
"""

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import api

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/structure"))
import outputs  # noqa: E402

FRONT = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md"]
LINK = re.compile(r"(?<=\]\()(?!https?:|#)([^)\s#]+)(?=[)#])")
CODE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
NAMED_FENCE = re.compile(r"^(```\w+) (\S+)$", re.MULTILINE)
NAMED_LINK = re.compile(r"\[([\w./]+\.md)\](\(\1[)#])")  # named by its file, which has another name on the site
FIGURE = re.compile(r"^```sh\n((?:(?!```).*\n)+)```\n\n!\[[^]]*\]\(plots/(\S+\.svg)\)", re.MULTILINE)
ENTRY = re.compile(r"^ *- .*: (\S+\.md)$")


def size(path):
    kilobytes = path.stat().st_size / 1000
    return f"{kilobytes:.1f} KB" if kilobytes < 100 else f"{kilobytes:.0f} KB"


def title(page):
    return page.read_text().partition("\n")[0].removeprefix("# ").partition(":")[0]


def rerun(page, text, program):
    """The text of a page with what its commands print now."""
    for block, outcomes in outputs.runs(page, program):
        lines = []
        for command, shown, printed in outcomes:
            if shown is None:
                sys.exit(outputs.fault(page, command, printed))
            lines += ["$ " + command.replace("\n", "\n> "), *shown]
        text = text.replace(f"```console\n{block}```", "```console\n" + "\n".join(lines) + "\n```")
    return text


def draw(text, program, plots):
    """Draws the figures of a page that stand below the commands that draw them."""
    for commands, figure in FIGURE.findall(text):
        if f"--out {figure}" in commands:
            environment = {**os.environ, "PATH": os.pathsep.join([str(program.parent), os.environ["PATH"]])}
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run(["bash", "-ec", commands], cwd=folder, env=environment, stdout=subprocess.DEVNULL, check=True)
                shutil.copy(Path(folder, figure), plots)


def table_of(folder):
    """A page of a folder that pages link: its files, to download."""
    lines = [f"# The files of {folder.relative_to(ROOT)}\n", "| file | size |", "|---|---|"]
    lines += [f"| [{file.name}]({file.name}) | {size(file)} |" for file in sorted(folder.iterdir()) if file.is_file()]
    return "\n".join(lines) + "\n"


def data_page(folder):
    """The tables of reference values, each with its title, size and link."""
    lines = [(folder / "README.md").read_text(), "## The tables\n"]
    lines += ["What the columns mean and how the values were computed: [reference data](../../docs/reference_data.md).\n"]
    lines += ["| table | rows | size | what it is |", "|---|---|---|---|"]
    for table in json.loads((folder / "index.json").read_text())["tables"]:
        file, description = table["file"], table["description"]
        about = json.loads((folder / description).read_text())["title"]
        lines += [f"| [{file}]({file}) | {table['rows']} | {size(folder / file)} | {about} ([more]({description})) |"]
    others = [file.name for file in sorted(folder.iterdir()) if file.is_file() and file.suffix not in {".csv", ".md"}]
    lines += ["\nBeside them: " + ", ".join(f"[{name}]({name})" for name in others) + "."]
    return "\n".join(lines) + "\n"


def map_page(results):
    """The page that leads to the report, with what its results were measured on."""
    rows = [json.loads(line) for line in results.read_text().splitlines()]
    session = next(row["session"] for row in rows if "session" in row)
    scenes, schemes = ({row[key] for row in rows if "ending" in row} for key in ("scene", "scheme"))
    return f"""---
hide: [navigation, toc]
---
# The map

For each problem and accuracy the cheapest scheme, and why: the report of {len(schemes)} schemes on {len(scenes)} scenes, measured
with fdebench {session["version"]} on {session["machine"]}. Times are those of that machine; `fdebench run` and
`fdebench report` make this page on yours ([the commands](docs/command.md)).

[Open the map](map/index.html){{ .md-button .md-button--primary }}

<iframe class="map" src="map/index.html" title="The map" loading="lazy"></iframe>
"""


def command_page(program):
    """The help of each subcommand, as the program prints it."""
    def printed(*words):
        return subprocess.run([program, *words], stdout=subprocess.PIPE, text=True, check=True).stdout
    offered = (line.partition("\t")[0] for line in printed("__complete", "").splitlines())
    helps = (f"## {name}\n\n```text\n{printed('help', name)}```\n" for name in offered if not name.startswith("-"))
    return "\n".join(["# The command\n", f"```text\n{printed('help')}```\n", *helps])


def copy(name, pages):
    target = pages / name
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(ROOT / name, target)


def assemble(pages, build, quick):
    """Copies the pages and the files that they link; the figures are those of the build folder where it has them."""
    for page in [*(ROOT / name for name in FRONT), *sorted((ROOT / "docs").glob("*.md"))]:
        name = page.relative_to(ROOT)
        text = page.read_text()
        for link in LINK.findall(CODE.sub("", text)):
            linked = (page.parent / link).resolve()
            if linked.is_dir():
                shutil.copytree(linked, pages / linked.relative_to(ROOT), dirs_exist_ok=True)
                about = data_page if linked == ROOT / "reference/data" else table_of
                (pages / linked.relative_to(ROOT) / "README.md").write_text(about(linked))
                text = text.replace(f"]({link})", f"]({link}/README.md)")
            elif linked.suffix != ".md":
                copy(linked.relative_to(ROOT), pages)
        if not quick and page in outputs.pages_to_run():
            text = rerun(page, text, build / "fdebench")
            draw(text, build / "fdebench", pages / "docs/plots")
        (pages / name).parent.mkdir(parents=True, exist_ok=True)
        text = NAMED_LINK.sub(lambda link: f"[{title(page.parent / link[1])}]{link[2]}", text)
        (pages / name).write_text(NAMED_FENCE.sub(r'\1 title="\2"', text))
    for figure in (build / "plots").rglob("*.svg"):
        shutil.copyfile(figure, pages / "docs/plots" / figure.relative_to(build / "plots"))


def run_notebooks(pages, work, build):
    """Pages of the notebooks, with what their cells print and draw; none without nbconvert."""
    for notebook in (ROOT / "docs/examples").glob("*.ipynb") if importlib.util.find_spec("nbconvert") else []:
        copied = shutil.copy(notebook, work)
        command = [sys.executable, "-m", "nbconvert", "--log-level", "ERROR", "--execute", "--to", "markdown", copied]
        environment = {**os.environ, "PYTHONPATH": str(build / "python"), "PYDEVD_DISABLE_FILE_VALIDATION": "1"}
        subprocess.run([*command, "--output-dir", pages / "docs/examples"], check=True, env=environment)


def configuration(pages):
    """mkdocs.yml without the entries whose page does not exist."""
    lines = (HERE / "mkdocs.yml").read_text().splitlines()
    entries = ((line, ENTRY.match(line)) for line in lines)
    return "\n".join(line for line, entry in entries if not entry or (pages / entry[1]).exists()) + "\n"


def from_disk(site):
    """A script with the search index and the worker that searches it: a page from a disk can load these in no other way."""
    worker = next((site / "assets/javascripts/workers").glob("search.*.js")).read_text()
    index = (site / "search/search_index.json").read_text()
    (site / "search/from_disk.js").write_text(
        f"var __search = {{index: Promise.resolve({index}), worker: URL.createObjectURL(new Blob([{json.dumps(worker)}]))}}\n")


def main(build, site, headers, results, *options):
    build, site = Path(build).resolve(), Path(site).resolve()
    work = site.with_name(site.name + "_pages")
    shutil.rmtree(work, ignore_errors=True)
    pages = work / "docs"
    pages.mkdir(parents=True)
    assemble(pages, build, "--quick" in options)
    if "--quick" not in options:
        run_notebooks(pages, work, build)
    (pages / "api").mkdir()
    api.write(pages / "api", Path(headers).read_text().split(), work / "doxygen", build / "python")
    (pages / "api/command.md").write_text(command_page(build / "fdebench"))
    (pages / "map.md").write_text(map_page(Path(results)))
    subprocess.run([build / "fdebench", "report", results, "--out", pages / "map"], check=True, stdout=subprocess.DEVNULL)
    shutil.copyfile(HERE / "site.css", pages / "site.css")
    shutil.copytree(HERE / "theme", work / "theme")
    (work / "mkdocs.yml").write_text(configuration(pages))
    subprocess.run([sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", site], cwd=work, check=True)
    from_disk(site)
    print(site / "index.html")


if __name__ == "__main__":
    main(*sys.argv[1:])
