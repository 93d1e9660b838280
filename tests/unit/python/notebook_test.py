"""Executes the notebooks of examples/notebooks/: in a kernel where nbclient and ipykernel are installed, else cell by cell in this process.

usage: notebook_test.py NOTEBOOK     (its name without .ipynb; PYTHONPATH names the folder of the package)
"""
import ast
import json
import sys
from pathlib import Path

NOTEBOOKS = Path(__file__).parents[3] / "examples" / "notebooks"


def execute_in_kernel(file):
    """@return whether there is a kernel"""
    try:
        import ipykernel  # noqa: F401
        import nbclient
        import nbformat
    except ImportError:
        return False
    notebook = nbformat.read(file, as_version=4)
    nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(file.parent)}}).execute()
    return True


def shown(value):
    """Asks a value for what a notebook would show."""
    for way in ("_repr_html_", "_repr_svg_", "_repr_png_"):
        if hasattr(value, way):
            assert len(getattr(value, way)()) > 100, (value, way)


def execute_here(file):
    names = {"__name__": "__main__"}
    for number, cell in enumerate(json.loads(file.read_text(encoding="utf-8"))["cells"]):
        if cell["cell_type"] != "code":
            continue
        code = ast.parse("".join(cell["source"]), f"{file.name}[{number}]")
        last = code.body.pop() if isinstance(code.body[-1], ast.Expr) else None
        exec(compile(code, f"{file.name}[{number}]", "exec"), names)
        if last:
            shown(eval(compile(ast.Expression(last.value), f"{file.name}[{number}]", "eval"), names))


def main():
    file = NOTEBOOKS / f"{sys.argv[1]}.ipynb"
    cells = json.loads(file.read_text(encoding="utf-8"))["cells"]
    assert all(not cell.get("outputs") for cell in cells), "clear its outputs: they are of one machine"
    assert sum(cell["cell_type"] == "code" for cell in cells) >= 4
    if not execute_in_kernel(file):
        execute_here(file)


if __name__ == "__main__":
    main()
