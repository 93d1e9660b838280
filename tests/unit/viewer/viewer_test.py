#!/usr/bin/env python3
"""The viewer, driven by real key and mouse events on a display of its own. Exit status 77: there is no Xvfb or xdotool.

usage: viewer_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without

STERADIAN, SCENES, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
WIDTH, HEIGHT = 400, 300  # of the window
SIZE, SAMPLES = f"{WIDTH}x{HEIGHT}", "2"
UPRIGHT = "--attrib", "pnm:pfmflip", "0"  # OpenImageIO 2.5 writes a PPM upside down without it


def steradian(*arguments) -> subprocess.CompletedProcess:
    return subprocess.run([STERADIAN, *map(str, arguments)], capture_output=True, text=True, timeout=250)


def same(a: Path, b: Path, factor: float = 1.0) -> bool:
    """Whether `a` times a factor is `b`, to the rounding of floats: |a - b| / max(a, b)."""
    scaled = [a, "--ch", "R,G,B", "--mulc", str(factor)]
    other = [b, "--ch", "R,G,B"]
    result = subprocess.run(["oiiotool", *scaled, *other, "--absdiff", *scaled, *other, "--max", "--div", "--printstats"],
                            capture_output=True, text=True)
    return max(map(float, re.search(r"Stats Max: +(\S+) (\S+) (\S+)", result.stdout).groups())) < 1e-5


def provenance(picture: Path) -> set[str]:
    """The attributes that say how a picture was made, without those of how `render` was stopped."""
    listed = subprocess.run(["oiiotool", "--info", "-v", picture], capture_output=True, text=True, check=True).stdout
    return {name for name in re.findall(r"steradian:(\w+)", listed) if not re.match("stopped_by|error_target|samples_", name)}


def rendered(scene: Path, camera: str, *arguments) -> Path:
    file = SCRATCH / "rendered.exr"
    result = steradian("render", scene, "--camera", camera, "--size", SIZE, "--samples", SAMPLES, "-o", file, *arguments)
    assert result.returncode == 0, result.stderr
    return file


def brightest(picture: Path) -> tuple[int, int]:
    """Where the picture is brightest: the middle of the lamp."""
    small = SCRATCH / "lamp.ppm"
    subprocess.run(["oiiotool", picture, "--ch", "G,G,G", "--divc", "16000", "-d", "uint8", *UPRIGHT, "-o", small], check=True)
    pixels = small.read_bytes()[-3 * WIDTH * HEIGHT:]
    lit = [i // 3 for i in range(0, len(pixels), 3) if pixels[i] == 255]
    return lit[len(lit) // 2] % WIDTH, lit[len(lit) // 2] // WIDTH


def pixels_of(png: Path, width: int = WIDTH, height: int = HEIGHT):
    """A function from x, y to the (r, g, b) of a PNG of this size."""
    plain = SCRATCH / "plain.ppm"
    subprocess.run(["oiiotool", png, "--ch", "R,G,B", "-d", "uint8", *UPRIGHT, "-o", plain], check=True)
    file = plain.read_bytes()
    assert re.match(rb"P6\s+%d %d\s" % (width, height), file), f"{png} has another size than the picture"
    pixels = file[-3 * width * height:]

    def pixel(x: int, y: int) -> tuple[int, ...]:
        first = 3 * (y * width + x)
        return tuple(pixels[first:first + 3])
    return pixel


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


def looking_around(viewer: Viewer, scene: Path, first: Path):
    """The converged picture is render's; a drag orbits; F frames; 0 goes back to the file's camera."""
    assert same(first, rendered(scene, "main")), "not the picture that render makes"
    viewer.changed_by(lambda: viewer.drag((200, 150), (240, 160)))
    orbited, camera = viewer.shot(), camera_of(viewer)
    assert not same(first, orbited), "a drag changes nothing"
    assert same(orbited, rendered(scene, camera)), f"render --camera '{camera}' is another picture"
    viewer.changed_by(lambda: viewer.key("f"))
    assert camera_of(viewer) != camera and not same(orbited, viewer.shot()), "F changes nothing"
    viewer.changed_by(lambda: viewer.key("0"))
    assert same(first, viewer.shot()), "the file's camera is not where it was"


def editing_lights(viewer: Viewer, scene: Path, first: Path):
    """A click selects the emitter, Enter takes its value, and twice the flux is twice the radiance, in a saved file, too.
    Ctrl Z takes it back, Space switches it off."""
    relit = scene.with_name("relit.gltf")
    viewer.click(*brightest(first))
    viewer.wait(lambda: "Selected " in viewer.errors(), "a selected light")
    viewer.key("h", "Return")
    viewer.changed_by(lambda: viewer.type("1600 lm"))
    assert same(first, viewer.shot(), 2.0), "twice the flux is not twice the radiance"
    viewer.key("ctrl+s", "ctrl+a")
    viewer.type(str(relit))
    viewer.wait(relit.exists, "a saved file")
    assert same(first, rendered(relit, "main"), 2.0), "the saved file is not what was seen"
    viewer.changed_by(lambda: viewer.key("ctrl+z"))
    assert same(first, viewer.shot()), "undone it is not what it was"
    viewer.changed_by(lambda: viewer.key("space"))
    assert same(first, viewer.shot(), 0.0), "switched off it shines"
    viewer.changed_by(lambda: viewer.key("space"))
    viewer.key("Escape", "h")


SIDE = WIDTH // 4, HEIGHT // 2  # a pixel that panels cover in a window so small


def probing_and_comparing(viewer: Viewer, without: tuple[int, int, int]):
    """A probe answers, and brings back the hidden panels (layout_test.py looks at its lobe); a wipe shows the reference beside the new
    picture. `without`: the colour at SIDE without panels."""
    side = SIDE
    viewer.wait(lambda: viewer.screen(*side) == without, "a picture without panels")
    viewer.click(WIDTH // 2, HEIGHT - 40)
    viewer.wait(lambda: f"Probed pixel {WIDTH // 2},{HEIGHT - 40}." in viewer.errors(), "an answer")
    viewer.wait(lambda: viewer.screen(*side) != without, "the panels, over a window so small")
    viewer.key("Escape", "h")
    viewer.wait(lambda: viewer.screen(*side) == without, "the picture without panels")
    viewer.key("b")
    viewer.wait(lambda: "Reference kept." in viewer.errors(), "a kept picture")
    places = side, (3 * WIDTH // 4, HEIGHT // 2)
    viewer.pause()
    before = [viewer.screen(*place) for place in places]
    viewer.changed_by(lambda: viewer.key("1"))
    viewer.wait(lambda: viewer.screen(*places[0]) != before[0], "the new picture on the wipe's own side")
    assert viewer.screen(*places[1]) == before[1], "the wipe's other side is not the kept picture"
    earlier = set(viewer.folder.glob("*.png"))
    viewer.key("alt+F12")
    seen = viewer.wait(lambda: set(viewer.folder.glob("*.png")) - earlier, "a picture of what is seen").pop()
    shown = pixels_of(seen)
    # The file is written before the window shows the frame.
    viewer.wait(lambda: all(shown(*place) == viewer.screen(*place) for place in places), "a window that shows what was written")
    viewer.key("Escape")
    viewer.changed_by(lambda: viewer.key("0"))


def reloading(viewer: Viewer, shader: Path, scene: Path, first: Path):
    """A broken shader is named with its line while the last picture goes on; mended, it shows. So does a saved scene."""
    code = '#include "surface/surface.glsl"\nvec3 f_r(Surface x, vec3 wi, vec3 wo) {{\n    return {};\n}}\n'
    viewer.write(shader, code.format("undeclared"))
    viewer.wait(lambda: "f_r.glsl:3" in viewer.errors(), "the error's line")
    assert same(first, viewer.shot()), "the last good picture is gone"
    viewer.changed_by(lambda: viewer.write(shader, code.format("vec3(0.0)")))
    assert not same(first, viewer.shot()), "the mended shader does not show"
    viewer.changed_by(shader.unlink)
    assert same(first, viewer.shot()), "without the overlay it is not what it was"
    scene.write_text("{")
    viewer.wait(lambda: "scene.gltf:1:" in viewer.errors(), "the broken file's line")
    viewer.changed_by(lambda: viewer.write(scene, (SCENES / "spheres.gltf").read_text()))
    # Under a folder of shaders, even an empty one, finely meshed surfaces are rasterised, and rounded otherwise.
    assert same(viewer.shot(), rendered(scene, "main", "--shaders", shader.parent.parent)), "the saved scene does not show"


def opening(viewer: Viewer):
    viewer.key("h", "ctrl+o")
    viewer.changed_by(lambda: viewer.type(str(SCENES / "veach.gltf")))
    assert "veach.gltf" in viewer.title(), viewer.title()


LAMPS = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}, "intensity": 10}]}},
    "cameras": [{"type": "perspective", "perspective": {"yfov": 2 * math.atan(0.25), "znear": 0.1}}],
    "nodes": [
        {"name": "eye", "camera": 0, "translation": [0, 1, 4]},  # a metre at the lamps is 150 pixels
        {"name": "plate", "translation": [0, 1, 0], "extras": {"steradian": {
            "shape": "rectangle", "width": 1, "height": 0.5, "quantity": {"value": 100, "unit": "lm"}}}},
        {"name": "spot", "translation": [-0.5, 1, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}]}


def gripping(viewer: Viewer, folder: Path):
    """A drag of its edge widens a rectangle, a key and the pointer turn it; a drag of a ring turns a spot; Esc gives up. The
    saved file has both."""
    file, saved = folder / "lamps.gltf", folder / "turned.gltf"
    file.write_text(json.dumps(LAMPS))
    viewer.key("ctrl+o")
    viewer.changed_by(lambda: viewer.type(str(file)))
    viewer.key("h", "Tab")
    viewer.changed_by(lambda: viewer.drag((275, 150), (305, 150)))
    assert "width 1.4 m" in viewer.errors(), viewer.errors()
    viewer.move(300, 150)
    viewer.key("r")
    viewer.changed_by(lambda: (viewer.move(200, 50), viewer.click(200, 50)))
    assert "turned by 90.0 deg about the view" in viewer.errors(), viewer.errors()
    viewer.key("Tab")
    viewer.changed_by(lambda: viewer.drag((116, 221), (116, 266)))
    assert "turned by 28.6 deg about X" in viewer.errors(), viewer.errors()
    viewer.key("g")
    viewer.move(230, 120)
    viewer.key("Escape")
    viewer.wait(lambda: "Change discarded." in viewer.errors(), "a move that was given up")
    viewer.key("h", "ctrl+s", "ctrl+a")
    viewer.type(str(saved))
    viewer.wait(saved.exists, "a saved file")
    nodes = json.loads(saved.read_text())["nodes"]
    plate, spot = (nodes[nodes[i]["children"][0]] for i in (1, 2))
    assert abs(plate["extras"]["steradian"]["width"] - 1.4) < 1e-3, plate
    assert plate["extras"]["steradian"]["height"] == 0.5, plate
    for node, axes in (plate, [0, 1, 0, -1, 0, 0, 0, 0, 1]), (spot, [1, 0, 0, 0, .878, .479, 0, -.479, .878]):
        turned = [node["matrix"][i] for i in (0, 1, 2, 4, 5, 6, 8, 9, 10)]
        assert all(abs(a - b) < 2e-3 for a, b in zip(turned, axes)), node
        assert all(abs(x) < 1e-5 for x in node["matrix"][12:15]), node


def keys_beside_fields(viewer: Viewer):
    """Tab goes through the lights, not into a panel's fields; in a field Ctrl Q still quits."""
    for name in ("plate", "spot", "plate"):
        before = viewer.errors().count(f"Selected {name}.")
        viewer.key("Tab")
        viewer.wait(lambda: viewer.errors().count(f"Selected {name}.") > before, f"the {name} by Tab")
    viewer.key("Return")
    viewer.close()


def converging_by_error(display: Display):
    """It stops when render --error does, with the same frozen pixels; the window divides each by its own samples."""
    size, error = (160, 120), ("--error", "4%")
    viewer = Viewer(display, STERADIAN, SCRATCH / "error", SCENES / "cornell.gltf", "--size", "160x120", *error,
                    "--visibility", "none", "--gl-debug", "--exposure", "10")
    viewer.done()
    viewer.key("h")
    exr, png = viewer.shot(), viewer.shot(exr=False)
    file = SCRATCH / "error.exr"
    result = steradian("render", SCENES / "cornell.gltf", "--size", "160x120", *error, "--visibility", "none", "-o", file,
                       "--json")
    summary = json.loads(result.stdout)
    assert summary["samples_min"] < summary["samples"], f"no pixel is frozen: choose another error, {result.stdout}"
    assert f"done, {summary['samples']} samples, error" in viewer.title(), (viewer.title(), summary)
    assert same(exr, file), "not the picture that render makes"
    assert provenance(exr) == provenance(file) >= {"estimator", "visibility", "seed", "error"}, provenance(exr)
    shown, screen = pixels_of(png, *size), viewer.display.pixels()
    for x, y in ((x, y) for x in range(0, size[0], 5) for y in range(0, size[1], 5)):
        assert all(abs(a - b) <= 1 for a, b in zip(screen(x, y), shown(x, y))), (x, y, screen(x, y), shown(x, y))
    viewer.close()


def losing_the_display():
    """The X server goes away under an open window."""
    display = Display(SCRATCH / "lost_display", 400, 300)
    viewer = Viewer(display, STERADIAN, SCRATCH / "lost", SCENES / "cornell.gltf", "--size", "64x48", "--samples", "1")
    viewer.done()
    display.close()
    assert viewer.process.wait(20) == 3, viewer.process.returncode
    assert "lost the connection to the display" in viewer.errors().splitlines()[-1], viewer.errors()


def main() -> int:
    skip_without()
    shutil.rmtree(SCRATCH, ignore_errors=True)
    no_display()
    losing_the_display()
    with Display(SCRATCH / "display", 800, 600) as display:
        scene, shader = SCRATCH / "scene.gltf", SCRATCH / "shaders" / "brdf" / "f_r.glsl"
        shader.parent.mkdir(parents=True)
        shutil.copy(SCENES / "cornell.gltf", scene)
        no_file(display)
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", scene, "--size", SIZE, "--samples", SAMPLES, "--gl-debug",
                        "--exposure", "8", "--shaders", shader.parent.parent)
        viewer.done()
        viewer.key("h")  # the picture alone
        first = viewer.shot()
        looking_around(viewer, scene, first)
        without = viewer.screen(*SIDE)
        editing_lights(viewer, scene, first)
        probing_and_comparing(viewer, without)
        reloading(viewer, shader, scene, first)
        opening(viewer)
        gripping(viewer, SCRATCH)
        keys_beside_fields(viewer)
        converging_by_error(display)
    return 0


if __name__ == "__main__":
    sys.exit(main())
