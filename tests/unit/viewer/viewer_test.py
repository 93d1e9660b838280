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
WIDTH, HEIGHT = 400, 300
SIZE, SAMPLES = f"{WIDTH}x{HEIGHT}", "4"


def steradian(*arguments) -> subprocess.CompletedProcess:
    return subprocess.run([STERADIAN, *map(str, arguments)], capture_output=True, text=True, timeout=100)


def same(a: Path, b: Path, factor: float = 1.0) -> bool:
    """Whether `a` times a factor is `b`, to the rounding of floats: |a - b| / max(a, b)."""
    scaled = [a, "--ch", "R,G,B", "--mulc", str(factor)]
    other = [b, "--ch", "R,G,B"]
    result = subprocess.run(["oiiotool", *scaled, *other, "--absdiff", *scaled, *other, "--max", "--div", "--printstats"],
                            capture_output=True, text=True)
    return max(map(float, re.search(r"Stats Max: +(\S+) (\S+) (\S+)", result.stdout).groups())) < 1e-5


def rendered(scene: Path, camera: str, *arguments) -> Path:
    file = SCRATCH / "rendered.exr"
    result = steradian("render", scene, "--camera", camera, "--size", SIZE, "--samples", SAMPLES, "-o", file, *arguments)
    assert result.returncode == 0, result.stderr
    return file


def brightest(picture: Path) -> tuple[int, int]:
    """Where the picture is brightest: the middle of the lamp."""
    small = SCRATCH / "lamp.ppm"
    subprocess.run(["oiiotool", picture, "--ch", "G,G,G", "--divc", "16000", "-d", "uint8", "-o", small], check=True)
    pixels = small.read_bytes()[-3 * WIDTH * HEIGHT:]
    lit = [i // 3 for i in range(0, len(pixels), 3) if pixels[i] == 255]
    return lit[len(lit) // 2] % WIDTH, lit[len(lit) // 2] // WIDTH


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


def editing_lights(display: Display):
    """A click selects the emitter, Enter takes its value, and twice the flux is twice the radiance. Space switches it off."""
    viewer = Viewer(display, STERADIAN, SCRATCH / "lights", SCENES / "cornell.gltf", "--size", SIZE, "--samples", SAMPLES,
                    "--gl-debug")
    viewer.done()
    first = viewer.shot()
    viewer.key("h")
    viewer.click(*brightest(first))
    viewer.wait(lambda: "selected " in viewer.errors(), "a selected light")
    viewer.key("h", "Return")
    viewer.changed_by(lambda: viewer.type("1600 lm"))
    assert same(first, viewer.shot(), 2.0), "twice the flux is not twice the radiance"
    viewer.changed_by(lambda: viewer.key("ctrl+z"))
    assert same(first, viewer.shot()), "undone it is not what it was"
    viewer.changed_by(lambda: viewer.key("space"))
    assert same(first, viewer.shot(), 0.0), "switched off it shines"
    viewer.close()


def asking_and_opening(display: Display):
    """A pixel answers with its lights; a kept picture is compared; another file is opened by its path."""
    viewer = Viewer(display, STERADIAN, SCRATCH / "ask", SCENES / "cornell.gltf", "--size", SIZE, "--samples", SAMPLES,
                    "--gl-debug", "--exposure", "8")
    viewer.done()
    viewer.key("h")
    viewer.click(WIDTH // 2, HEIGHT - 40)
    viewer.wait(lambda: f"pixel {WIDTH // 2},{HEIGHT - 40} answers" in viewer.errors(), "an answer")
    viewer.key("Escape", "b")
    viewer.wait(lambda: "kept: " in viewer.errors(), "a kept picture")
    before = viewer.screen(WIDTH // 4, HEIGHT // 2), viewer.screen(3 * WIDTH // 4, HEIGHT // 2)
    viewer.changed_by(lambda: viewer.key("1"))
    assert viewer.screen(3 * WIDTH // 4, HEIGHT // 2) == before[1], "the wipe's other side is not the kept picture"
    assert viewer.screen(WIDTH // 4, HEIGHT // 2) != before[0], "the wipe's own side is not the new picture"
    viewer.key("h", "ctrl+o")
    viewer.changed_by(lambda: viewer.type(str(SCENES / "veach.gltf")))
    assert "veach.gltf" in viewer.title(), viewer.title()
    viewer.key("Escape")
    assert same(viewer.shot(), rendered(SCENES / "veach.gltf", "main")), "the opened file is not what render makes of it"
    viewer.close()


def reloading(display: Display):
    """A broken shader is named with its line while the last picture goes on; mended, it shows. So does a saved scene."""
    shaders, scene = SCRATCH / "shaders" / "brdf", SCRATCH / "scene.gltf"
    shaders.mkdir(parents=True)
    shutil.copy(SCENES / "cornell.gltf", scene)
    viewer = Viewer(display, STERADIAN, SCRATCH / "reload", scene, "--size", SIZE, "--samples", SAMPLES, "--gl-debug",
                    "--shaders", shaders.parent)
    viewer.done()
    first = viewer.shot()
    body = 'vec3 f_r(Surface x, vec3 wi, vec3 wo) {{\n    return {};\n}}\n'
    viewer.write(shaders / "f_r.glsl", '#include "surface/surface.glsl"\n' + body.format("undeclared"))
    viewer.wait(lambda: "f_r.glsl:3" in viewer.errors(), "the error's line", 10)
    assert same(first, viewer.shot()), "the last good picture is gone"
    viewer.changed_by(lambda: viewer.write(shaders / "f_r.glsl", '#include "surface/surface.glsl"\n'
                                                                 + body.format("vec3(0.0)")))
    assert not same(first, viewer.shot()), "the mended shader does not show"
    viewer.changed_by(lambda: (shaders / "f_r.glsl").unlink())
    assert same(first, viewer.shot()), "without the overlay it is not what it was"
    scene.write_text("{")
    viewer.wait(lambda: "scene.gltf:1:" in viewer.errors(), "the broken file's line", 10)
    text = (SCENES / "spheres.gltf").read_text()
    viewer.changed_by(lambda: viewer.write(scene, text))
    assert same(viewer.shot(), rendered(scene, camera_of(viewer))), "the saved scene does not show"
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
        editing_lights(display)
        asking_and_opening(display)
        reloading(display)
    finally:
        display.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
