#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""notebook.py NOTEBOOK FOLDER: executes a notebook in a folder, as Jupyter does; each cell must run, and the notebook is kept without
outputs."""

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

source, folder = Path(sys.argv[1]), Path(sys.argv[2])
folder.mkdir(exist_ok=True)
notebook = nbformat.read(source, as_version=4)
nbformat.validate(notebook)
cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
assert not any(cell.outputs or cell.execution_count for cell in cells), "is kept with outputs"
assert any("assert " in cell.source for cell in cells), "checks nothing"
NotebookClient(notebook, timeout=120, resources={"metadata": {"path": folder}}).execute()  # raises where a cell does
pictures = [output for cell in cells for output in cell.outputs if "image/png" in output.get("data", {})]
assert len(pictures) == sum("plt.show()" in cell.source for cell in cells), "draws no pictures"
nbformat.write(notebook, folder / source.name)
