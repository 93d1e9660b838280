"""Executes the notebooks of examples/notebooks/ in a kernel, as Jupyter does. Skipped without nbclient and ipykernel.

usage: notebook_test.py NOTEBOOK [FILE.ipynb]     (its name without .ipynb; where the executed one goes; PYTHONPATH names the folder of the package)
"""
import sys
from pathlib import Path

NOTEBOOKS = Path(__file__).parents[3] / "examples" / "notebooks"


def check_outputs(cells):
    """Each cell that ends with a value shows it; there are pictures, and no warnings."""
    kinds = set()
    for cell in cells:
        for output in cell.outputs:
            assert output.output_type != "stream" or output.name == "stdout", output
            kinds |= set(output.get("data", {}))
    assert kinds & {"text/html", "image/png", "image/svg+xml"}, kinds


def main():
    try:
        import ipykernel  # noqa: F401
        import nbclient
        import nbformat
    except ImportError as missing:
        print(missing)
        sys.exit(77)
    file = NOTEBOOKS / f"{sys.argv[1]}.ipynb"
    notebook = nbformat.read(file, as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert not any(cell.outputs for cell in cells), "clear its outputs: they are of one machine"
    assert len(cells) >= 4
    nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(file.parent)}}).execute()
    check_outputs(cells)
    if len(sys.argv) > 2:
        nbformat.write(notebook, sys.argv[2])


if __name__ == "__main__":
    main()
