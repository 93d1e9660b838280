#!/usr/bin/env python3
"""An assignment proves itself, and the proof is the table of assets/assignments/README.md.

usage: assignment_test.py STERADIAN ASSIGNMENTS_FOLDER NAME
"""
import subprocess
import sys
from pathlib import Path


def main() -> int:
    steradian, folder, name = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    run = subprocess.run([steradian, "assignment", "test", str(folder / name)], capture_output=True, text=True)
    sys.stdout.write(run.stdout)
    sys.stderr.write(run.stderr)
    if run.returncode != 0:
        print(f"{name}: does not prove itself")
        return 1
    if "**WRONG**" in run.stdout or run.stdout.count("reference") < 1:
        print(f"{name}: exit status 0 with a wrong proof, or none")
        return 1
    if run.stdout not in (folder / "README.md").read_text():
        print(f"{folder / 'README.md'}: has another table: put this one there")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
