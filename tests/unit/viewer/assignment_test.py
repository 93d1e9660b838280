#!/usr/bin/env python3
"""A student's folder in the viewer: its picture by its shaders, saves, marks, errors, the reference beside it. Exit status 77: there is
no Xvfb or xdotool.

usage: assignment_test.py STERADIAN ASSIGNMENTS_FOLDER SCRATCH_FOLDER
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without

STERADIAN, ASSIGNMENTS, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
FOLDER = SCRATCH / "my-a3"
SIZE = "320x240"


def steradian(*arguments, status=0):
    run = subprocess.run([STERADIAN, *map(str, arguments)], capture_output=True, text=True, timeout=250)
    assert run.returncode == status, (arguments, run.stdout, run.stderr)
    return run.stdout


def solution(file: str) -> str:
    return (ASSIGNMENTS / "a3-brdf/shaders" / file).read_text()


def save(viewer: Viewer, text: str):
    """Saves microfacets.glsl, and waits until the picture is by it."""
    viewer.changed_by(lambda: Viewer.write(FOLDER / "microfacets.glsl", text))


def factor_of(picture: Path, reference: Path) -> float:
    """The sum of a picture over that of another."""
    sums = []
    for file in (picture, reference):
        stats = subprocess.run(["oiiotool", file, "--ch", "R,G,B", "--printstats"], capture_output=True, text=True).stdout
        sums.append(sum(map(float, re.search(r"Stats Avg: +(\S+) (\S+) (\S+)", stats).groups())))
    return sums[0] / sums[1]


def main():
    skip_without("oiiotool")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    steradian("assignment", "new", "a3", FOLDER, "--student", "12345")
    (FOLDER / "phong.glsl").write_text(solution("phong.glsl"))
    right = solution("microfacets.glsl")
    (FOLDER / "microfacets.glsl").write_text(right.replace("a2 / (pi * d * d)", "a2 / (d * d)"))
    reference = SCRATCH / "reference.exr"
    with Display(SCRATCH / "display", 320, 240) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", "--assignment", FOLDER, "--size", SIZE, "--samples", "2")
        viewer.wait(lambda: "Shaders reloaded." in viewer.errors(), "a check that ends")
        viewer.changed_by(lambda: None) if viewer.converged() < 2 else None
        camera = re.findall(r"--camera '([^']*)'", viewer.errors())[-1]
        shaders = ASSIGNMENTS / "a3-brdf/shaders", ASSIGNMENTS / "a3-brdf/overlay"
        steradian("render", ASSIGNMENTS / "a3-brdf/scenes/tiles.gltf", "--camera", camera, "--size", SIZE, "--samples", "2",
                  "--shaders", shaders[0], "--shaders", shaders[1], "-o", reference)
        mistaken = factor_of(viewer.shot(), reference)
        assert abs(mistaken / 3.14159 - 1) < 0.01, f"without 1/pi the picture is the reference times {mistaken}"
        save(viewer, right)
        steradian("compare", viewer.shot(), reference)
        viewer.write(FOLDER / "microfacets.glsl", right.replace("float a2 =", "float a2 = nothing +"))
        viewer.wait(lambda: "microfacets.glsl:" in viewer.errors() and "not declared" in viewer.errors(), "the line of an error")
        steradian("compare", viewer.shot(), reference)
        save(viewer, right.replace("a2 / (pi * d * d)", "0.25 * a2 / (pi * d * d)"))
        viewer.key("h")
        places = (80, 130), (240, 130)  # left: the student's, right: the reference's
        viewer.wait(lambda: sum(viewer.screen(*places[1])) > 0, "a picture")
        before = viewer.screen(*places[1])
        viewer.key("b")
        viewer.wait(lambda: sum(viewer.screen(*places[1])) > 1.5 * sum(before), "the reference's picture beside")
        viewer.close()


if __name__ == "__main__":
    main()
