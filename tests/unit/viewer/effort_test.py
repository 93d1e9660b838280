#!/usr/bin/env python3
"""What the viewer does with its time: a probe of many lights between frames, nothing while it is minimised.
Exit status 77: there is no Xvfb or xdotool.

usage: effort_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import math
import shutil
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without

STERADIAN, SCENES, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
LIGHTS = 100


def many_lights() -> dict:
    """A scene whose floor has point lights over it, and one below."""
    scene = json.loads((SCENES / "veach.gltf").read_text())
    scene["extensionsUsed"] = ["KHR_lights_punctual"]
    scene["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 10}]}}
    angles = [2 * math.pi * i / LIGHTS for i in range(LIGHTS)]
    lights = [{"translation": [3 * math.cos(a), 3, 3 * math.sin(a)], "extensions": {"KHR_lights_punctual": {"light": 0}}}
              for a in angles]
    scene["scenes"][0]["nodes"] += range(len(scene["nodes"]), len(scene["nodes"]) + LIGHTS)
    scene["nodes"] += lights
    return scene


def probing(viewer: Viewer):
    """The first numbers come before the last ones, and commands are done in between."""
    viewer.click(450, 310)
    viewer.wait(lambda: "The first numbers of the probe are there." in viewer.errors(), "first numbers")
    viewer.key("v")
    viewer.wait(lambda: "View: " in viewer.errors(), "a command that is done during the probe")
    assert "Probed pixel" not in viewer.errors(), "the probe is too short to show anything: take more lights"


def hiding(viewer: Viewer):
    """A window that is not seen costs nothing, and goes on when it is seen again."""
    viewer.display.do("windowunmap", "--sync", viewer.window)

    def costs_nothing():
        before = viewer.processor_time()
        viewer.pause()
        viewer.pause()
        return viewer.processor_time() - before < 0.1

    viewer.wait(costs_nothing, "0.6 s without processor time while nobody sees the window")
    assert "Probed pixel" not in viewer.errors(), "the probe has ended, and so would the work of a window that is seen"
    viewer.display.do("windowmap", "--sync", viewer.window)
    viewer.display.do("windowfocus", viewer.window)
    viewer.key("M")


def main() -> int:
    skip_without()
    shutil.rmtree(SCRATCH, ignore_errors=True)
    with Display(SCRATCH / "display", 640, 400) as display:
        scene = SCRATCH / "many.gltf"
        scene.write_text(json.dumps(many_lights()))
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", scene, "--size", "640x400", "--samples", "100000", "--exposure", "8")
        viewer.wait(lambda: "many.gltf" in viewer.title(), "a picture")
        probing(viewer)
        hiding(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
