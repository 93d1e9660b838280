#!/usr/bin/env python3
"""The viewer, driven by real key and mouse events on a display of its own. Exit status 77: there is no Xvfb or xdotool.

usage: viewer_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer

STERADIAN, SCENES, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
SIZE, SAMPLES = "400x300", "4"


def steradian(*arguments) -> subprocess.CompletedProcess:
    return subprocess.run([STERADIAN, *map(str, arguments)], capture_output=True, text=True, timeout=100)


def same(a: Path, b: Path) -> bool:
    """Whether two EXRs agree to the rounding of floats; what is lit in them has some 100 cd/m²."""
    result = subprocess.run(["oiiotool", "--fail", "1e-4", "--diff", a, b], capture_output=True)
    return result.returncode == 0


def rendered(scene: Path, camera: str, *arguments) -> Path:
    file = SCRATCH / "rendered.exr"
    result = steradian("render", scene, "--camera", camera, "--size", SIZE, "--samples", SAMPLES, "-o", file, *arguments)
    assert result.returncode == 0, result.stderr
    return file


def camera_of(viewer: Viewer) -> str:
    """The camera of the last picture that converged, as `render` takes it."""
    return re.findall(r"--camera '([^']*)'", viewer.errors())[-1]


def no_display():
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    result = subprocess.run([STERADIAN, "view", SCENES / "cornell.gltf"], env=environment, capture_output=True, text=True)
    assert result.returncode == 3 and "DISPLAY" in result.stderr, result
    assert len(result.stderr.strip().splitlines()) == 1, result.stderr


def no_file(display: Display):
    result = subprocess.run([STERADIAN, "view", "nowhere.gltf"], env=display.environment, capture_output=True, text=True)
    assert result.returncode == 3 and result.stderr.startswith("nowhere.gltf"), result


def looking_around(display: Display):
    """The converged picture is render's; a drag orbits; F frames; C goes back; closing the window ends it."""
    scene = SCENES / "cornell.gltf"
    viewer = Viewer(display, STERADIAN, SCRATCH / "look", scene, "--size", SIZE, "--samples", SAMPLES, "--gl-debug")
    viewer.done()
    viewer.key("h")  # the picture alone
    first = viewer.shot()
    assert same(first, rendered(scene, "main")), "not the picture that render makes"
    viewer.changed_by(lambda: viewer.drag((200, 150), (240, 160)))
    orbited, camera = viewer.shot(), camera_of(viewer)
    assert not same(first, orbited), "a drag changes nothing"
    assert same(orbited, rendered(scene, camera)), f"render --camera '{camera}' is another picture"
    viewer.changed_by(lambda: viewer.key("f"))
    assert camera_of(viewer) != camera and not same(orbited, viewer.shot()), "F changes nothing"
    viewer.changed_by(lambda: viewer.key("0"))
    assert same(first, viewer.shot()), "the file's camera is not where it was"
    viewer.close()


def main() -> int:
    if not shutil.which("Xvfb") or not shutil.which("xdotool"):
        print("Xvfb and xdotool are needed: sudo apt-get install xvfb xdotool")
        return 77
    shutil.rmtree(SCRATCH, ignore_errors=True)
    display = Display(SCRATCH / "display", 800, 600)
    try:
        no_display()
        no_file(display)
        looking_around(display)
    finally:
        display.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
