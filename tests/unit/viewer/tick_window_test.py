#!/usr/bin/env python3
"""`view --tick`: a question's change is shown at the exposure of the picture before, and taken back. Exit status 77: there is no Xvfb or
xdotool.

usage: tick_window_test.py STERADIAN ASSIGNMENTS_FOLDER SCRATCH_FOLDER
"""
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer

STERADIAN, ASSIGNMENTS, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
FOLDER = SCRATCH / "my-a2"
STUDENT = "2"  # whose second question halves the colour of a material
SIZE = 400, 300


def seen(display: Display) -> list[tuple[int, int, int]]:
    """Colours on a grid."""
    pixel = display.pixels()
    return [pixel(x, y) for x in range(20, SIZE[0], 12) for y in range(20, SIZE[1], 12)]


def main():
    if not (shutil.which("Xvfb") and shutil.which("xdotool")):
        print("SKIPPED: Xvfb or xdotool is not installed")
        sys.exit(77)
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    subprocess.run([STERADIAN, "assignment", "new", "a2", FOLDER, "--student", STUDENT], check=True)
    for file in (ASSIGNMENTS / "a2-diffuse/shaders").glob("*.glsl"):
        shutil.copy(file, FOLDER)
    display = Display(SCRATCH / "display", *SIZE)
    try:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", "--assignment", FOLDER, "--tick", "--size", "{}x{}".format(*SIZE), "--samples", "2")
        viewer.wait(lambda: "4 questions." in viewer.errors(), "questions", 280)
        viewer.key("j")
        viewer.wait(lambda: "2 of 4." in viewer.errors(), "the second question")
        viewer.key("h")
        viewer.wait(lambda: seen(display) == (viewer.pause() or seen(display)), "a picture that stays")
        before = seen(display)
        viewer.changed_by(lambda: viewer.key("i"))
        assert "The scene is changed." in viewer.errors(), viewer.errors()
        viewer.wait(lambda: seen(display) != before and seen(display) == (viewer.pause() or seen(display)), "the change")
        after = seen(display)
        lit = [(a, b) for a, b in zip(before, after) if max(a) > 20]
        same = [a for a, b in lit if max(abs(p - q) for p, q in zip(a, b)) <= 1]
        darker = [a for a, b in lit if sum(b) < 0.85 * sum(a)]
        assert len(same) > len(lit) / 3, f"{len(same)} of {len(lit)} places keep their colour: the exposure has followed the change"
        assert len(darker) > 10, f"{len(darker)} places are darker"
        viewer.key("i")
        viewer.wait(lambda: "taken back" in viewer.errors() and seen(display) == before, "the picture as it was")
        viewer.close()
    finally:
        display.close()


if __name__ == "__main__":
    main()
