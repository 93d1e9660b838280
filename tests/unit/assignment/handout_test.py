#!/usr/bin/env python3
"""What the handout of a2-diffuse says: its functions are all of the equation there, so the renderer's own picture is the same.

usage: handout_test.py STERADIAN ASSIGNMENTS_FOLDER
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def main() -> int:
    steradian, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        student = Path(scratch) / "a2"

        def run(*words: str) -> None:
            subprocess.run([steradian, *words], check=True, cwd=student if student.exists() else scratch)

        run("assignment", "new", str(folder / "a2-diffuse"), str(student), "--student", "1")
        for file in (folder / "a2-diffuse" / "shaders").glob("*.glsl"):  # the reference in the place of the student's
            shutil.copy(file, student)
        size = ["--size", "160x120", "--samples", "4", "--visibility", "none"]
        run("render", "scenes/room.gltf", *size, "--shaders", ".", "--shaders", "overlay", "-o", "mine.exr")
        run("render", "scenes/room.gltf", *size, "-o", "theirs.exr")
        run("compare", "mine.exr", "theirs.exr", "--max", "rel=0.001")
    return 0


if __name__ == "__main__":
    sys.exit(main())
