#!/usr/bin/env python3
"""Animations, material variants and files that are dropped, in the viewer on a display of its own. Exit status 77: there is
no Xvfb, xdotool or python-xlib.

usage: motion_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without
from viewer_test import SAMPLES, SCENES, SCRATCH, SIZE, STERADIAN, rendered, same


OPTIONS = "--energy-compensation"


def arguments_of(viewer: Viewer) -> list[str]:
    """The last picture that converged, as `render` takes it: a camera, a moment, a variant."""
    return shlex.split(re.findall(r"converged: .*?, --camera (.*)", viewer.errors())[-1])


def playing(viewer: Viewer, scene: Path):
    """What plays moves, and at any time at which it is paused it is render's picture; a hot reload keeps the time."""
    first = viewer.shot()
    assert arguments_of(viewer) == ["main", "--at", "0.25"], "not the requested time"
    assert same(first, rendered(scene, "main", "--at", "0.25", OPTIONS)), "not the picture that render makes of it"
    viewer.changed_by(lambda: viewer.key("alt+Right", "alt+Right"))
    assert arguments_of(viewer)[1:] == ["--at", "0.3333333333333333"], arguments_of(viewer)
    assert not same(first, viewer.shot()), "a frame on it is the same"
    viewer.key("space")
    viewer.wait(lambda: "Playing." in viewer.errors(), "an animation that plays")
    first_color = viewer.screen(150, 250)
    viewer.wait(lambda: viewer.screen(150, 250) != first_color, "another picture while it plays")
    viewer.key("k")  # on a slow machine a picture may converge between two frames of what still plays
    viewer.wait(lambda: re.search(r"Paused.*converged:", viewer.errors(), re.DOTALL), "a paused picture that converged")
    camera, *moment = arguments_of(viewer)
    paused = viewer.shot()
    assert same(paused, rendered(scene, camera, *moment, OPTIONS)), f"render {moment} is another picture"
    viewer.changed_by(lambda: viewer.write(scene, scene.read_text() + " "))
    assert arguments_of(viewer) == [camera, *moment], "a file that was saved is shown at another time"
    assert same(paused, viewer.shot())


def shooting(viewer: Viewer, scene: Path):
    """A screenshot that is asked for while it plays has the window's size, and is the converged picture of its moment."""
    viewer.key("k")
    viewer.wait(lambda: viewer.errors().count("Playing.") == 2, "an animation that plays")
    picture = viewer.shot()
    camera, *moment = arguments_of(viewer)
    assert same(picture, rendered(scene, camera, *moment, OPTIONS)), f"render {moment} is another picture"


def varying(viewer: Viewer, scene: Path):
    """A variant is render's, of the camera and the moment that were there, and stays when the file is saved."""
    before = arguments_of(viewer)
    viewer.changed_by(lambda: viewer.key("n"))
    camera, *moment = arguments_of(viewer)
    assert [camera, *moment] == before + ["--variant", "gilded"], moment
    assert same(viewer.shot(), rendered(scene, camera, *moment, OPTIONS)), "not the picture that render makes of the variant"
    viewer.changed_by(lambda: viewer.write(scene, scene.read_text() + " "))
    assert arguments_of(viewer) == [camera, *moment], "a file that was saved has another variant"


def dropping(viewer: Viewer, display: Display):
    """A picture is compared with, a scene is opened, anything else is one line over the picture."""
    from drop import drop
    window = int(viewer.window)
    picture, text = SCRATCH / "my picture.png", SCRATCH / "notes.txt"
    subprocess.run(["oiiotool", "--pattern", "constant:color=0.2,0.6,0.4", SIZE, "3", "-d", "uint8", "-o", picture], check=True)
    text.write_text("no picture")
    drop(display.environment["DISPLAY"], window, [picture])
    viewer.wait(lambda: "Comparing with my picture.png" in viewer.errors(), "a picture to compare with")
    viewer.wait(lambda: viewer.screen(300, 150) == (51, 153, 102), "the dropped picture's colours")
    drop(display.environment["DISPLAY"], window, [text])
    viewer.wait(lambda: "notes.txt: is neither" in viewer.errors(), "a clear line")
    loud = SCRATCH / "VEACH.GLTF"
    shutil.copy(SCENES / "veach.gltf", loud)
    viewer.changed_by(lambda: drop(display.environment["DISPLAY"], window, [loud]))
    assert "VEACH.GLTF" in viewer.title(), viewer.title()


def main() -> int:
    skip_without(modules=("Xlib",))
    shutil.rmtree(SCRATCH, ignore_errors=True)
    with Display(SCRATCH / "display", 800, 600) as display:
        scene = SCRATCH / "scene.gltf"
        shutil.copy(SCENES / "motion.gltf", scene)
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", scene, "--size", SIZE, "--samples", SAMPLES, "--gl-debug",
                        "--exposure", "3", "--at", "0.25", OPTIONS)
        viewer.done()
        viewer.key("h")
        playing(viewer, scene)
        shooting(viewer, scene)
        varying(viewer, scene)
        dropping(viewer, display)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
