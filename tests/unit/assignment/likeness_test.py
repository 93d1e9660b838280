#!/usr/bin/env python3
"""`assignment likeness`: of three submissions the two that are alike after their variables were renamed, and not the independent one.

usage: likeness_test.py STERADIAN ASSIGNMENTS_FOLDER SCRATCH_FOLDER
$STERADIAN_LIKENESS_PYTHON names a Python with the package copydetect (default: this one). Exit status 77: it has none.
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

STERADIAN, ASSIGNMENTS, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:4])
A2 = ASSIGNMENTS / "a2-diffuse"
PYTHON = os.environ.get("STERADIAN_LIKENESS_PYTHON", sys.executable)
CLASS = SCRATCH / "class"


def solutions(task: str) -> str:
    """The last of the other solutions of a task."""
    parts = re.split(r"^// (mistake|solution) (\w+)\s*$", (A2 / f"variants/{task}.glsl").read_text(), flags=re.M)
    return [code for kind, code in zip(parts[1::3], parts[3::3]) if kind == "solution"][-1].strip("\n") + "\n"


def hand_in(name: str, change):
    folder = CLASS / name
    folder.mkdir(parents=True)
    (folder / "assignment.json").write_text(json.dumps({"assignment": "a2-diffuse", "student": name}))
    for file in (A2 / "shaders").glob("*.glsl"):
        (folder / file.name).write_text(change(file.read_text()))


def renamed(text: str) -> str:
    for old, new in (("to_lamp", "d"), ("r2", "squared_length"), ("intensity", "candela"), ("Phi", "flux"), ("rho", "albedo")):
        text = re.sub(rf"\b{old}\b", new, text)
    return text


def independent(text: str) -> str:
    return re.sub(r"(// begin solution (A2\.\d)[^\n]*\n).*?(^// end)", lambda m: m[1] + solutions(m[2]) + m[3], text, flags=re.M | re.S)


def likeness(python, *more):
    return subprocess.run([STERADIAN, "assignment", "likeness", "a2", "--submissions", CLASS, "-o", SCRATCH / "pairs.html", "--python", python, *more],
                          capture_output=True, text=True, timeout=200)


def check_without_package():
    bare = SCRATCH / "python"
    bare.write_text(f'#!/bin/sh\nexec {sys.executable} -S -E "$@"\n')
    bare.chmod(0o755)
    run = likeness(bare)
    assert run.returncode == 3 and "copydetect" in run.stderr and "-m pip install copydetect" in run.stderr, (run.returncode, run.stderr)
    assert len(run.stderr.splitlines()) == 1 and not (SCRATCH / "pairs.html").exists(), run.stderr
    missing = likeness("no-such-python")
    assert missing.returncode == 3 and "no-such-python" in missing.stderr, missing.stderr


def check_pairs():
    run = likeness(PYTHON, "--least", "0.7")
    assert run.returncode == 0, run.stderr
    pairs = [line for line in run.stdout.splitlines() if " %" in line]
    assert len(pairs) == 1 and "ann" in pairs[0] and "ben" in pairs[0] and "eve" not in pairs[0], run.stdout
    page = (SCRATCH / "pairs.html").read_text()
    assert page.count("<mark>") > 4 and "<script>" not in page and "&lt;script&gt;" in page, "the page's marks or escapes"
    words = page.lower()
    assert "alike" in words and "look at" in words and not any(word in words for word in ("plagiar", "cheat", "guilty")), "the page judges"
    again = likeness(PYTHON, "--least", "0.7")
    assert again.stdout == run.stdout and (SCRATCH / "pairs.html").read_text() == page, "the same class gives another page"
    every = likeness(PYTHON, "--least", "0")
    assert every.stdout.count(" %") == 6, every.stdout


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    hand_in("ann", lambda text: text)
    hand_in("ben", lambda text: renamed(text).replace("// begin solution A2.1\n", "// begin solution A2.1\n// <script>alert(1)</script>\n"))
    hand_in("eve", independent)
    check_without_package()
    if subprocess.run([PYTHON, "-c", "import copydetect"], capture_output=True).returncode != 0:
        print(f"SKIPPED: {PYTHON} has no copydetect (pip install copydetect); only its absence was tested")
        sys.exit(77)
    check_pairs()


if __name__ == "__main__":
    main()
