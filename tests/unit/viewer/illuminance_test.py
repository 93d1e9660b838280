#!/usr/bin/env python3
"""Illuminance in the viewer's window: the numbers of `steradian illuminance`, isolines where the plane is, figures that follow the lights.
Exit status 77: there is no Xvfb or xdotool.

usage: illuminance_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without
from viewer_test import SCENES, SCRATCH, STERADIAN

MONITOR = 530, 330  # in the window
OPTIONS = "--size", "1000x600", "--samples", "1", "--exposure", "8", "--gl-debug"


def means(viewer: Viewer) -> list[float]:
    return [float(mean) for mean in re.findall(r"Illuminance: mean (\S+) lx", viewer.errors())]


def by_the_command(scene: Path, extension: str) -> bytes:
    target = SCRATCH / f"command{extension}"
    subprocess.run([STERADIAN, "illuminance", scene, "-o", target], check=True, capture_output=True)
    return target.read_bytes()


def following_the_picture(viewer: Viewer, scene: Path, whole: float):
    """What is seen is what is measured: one light alone, without hidden objects, and without lights that are off."""
    shown = subprocess.run([STERADIAN, "illuminance", scene, "--by-light", "--json"], check=True, capture_output=True, text=True).stdout
    alone = json.loads(shown)["lights"][0]["mean"]
    viewer.key("shift+v")
    viewer.said("cells, by panel 1 alone.")
    assert abs(means(viewer)[-1] / alone - 1) < 1e-3, (means(viewer), alone)
    viewer.key("Escape")
    viewer.wait(lambda: means(viewer)[-1] == whole, "the plane under all lights")
    viewer.move(*MONITOR)
    viewer.key("shift+o", "shift+h")
    viewer.said("cells, without 1 hidden object.")
    assert means(viewer)[-1] > whole, (means(viewer), whole)
    viewer.key("alt+h", "Tab", "space")
    viewer.said("cells, without 1 light that is off.")
    assert means(viewer)[-1] < whole, (means(viewer), whole)
    viewer.key("ctrl+z")
    viewer.wait(lambda: means(viewer)[-1] == whole, "the plane under all lights again")


def main() -> int:
    skip_without()
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    scene = SCENES / "office.gltf"
    with Display(SCRATCH / "display", 1000, 600) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", scene, *OPTIONS)
        viewer.done()
        viewer.key("ctrl+l")
        viewer.said("L measures a plane first.")
        before = bytes(display.words())
        viewer.key("l")
        viewer.wait(lambda: means(viewer), "a measured plane")
        assert bytes(display.words()) != before, "no isolines are seen"
        viewer.key("ctrl+l")
        viewer.said("Wrote office-001.svg.")
        for extension in ".csv", ".svg":
            assert (viewer.folder / f"office-001{extension}").read_bytes() == by_the_command(scene, extension), extension
        viewer.key("Tab", "ctrl+period")  # a third of an EV
        viewer.wait(lambda: len(means(viewer)) == 2, "the plane under a brighter light")
        first, second = means(viewer)
        assert 1.0 < second / first < 2 ** (1 / 3) + 1e-3, (first, second)
        viewer.key("ctrl+z")
        viewer.wait(lambda: len(means(viewer)) == 3, "the plane as it was")
        assert means(viewer)[2] == first, (first, means(viewer))
        following_the_picture(viewer, scene, first)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
