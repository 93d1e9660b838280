#!/usr/bin/env python3
"""Panels of the viewer beside the picture: at every size of the window nothing lies over a pixel. Exit status 77: there is no Xvfb,
xdotool, oiiotool or python-xlib.

usage: layout_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without
from viewer_test import SCENES, SCRATCH, STERADIAN, UPRIGHT, same, steradian

OPTIONS = "--samples", "1", "--visibility", "none", "--exposure", "8", "--gl-debug"
COLUMN = 290  # width of the left column before scaling


def picture_of(viewer: Viewer) -> tuple[int, int, int, int]:
    """x, y, width and height of the picture in the window, as the viewer says."""
    width, height, x, y = map(int, re.findall(r"The picture has (\d+)x(\d+) pixels, at (\d+),(\d+)\.", viewer.errors())[-1])
    return x, y, width, height


def codes_of(png: Path, width: int, height: int) -> bytes:
    plain = SCRATCH / "plain.ppm"
    subprocess.run(["oiiotool", png, "--ch", "R,G,B", "-d", "uint8", *UPRIGHT, "-o", plain], check=True)
    codes = plain.read_bytes()
    assert re.match(rb"P6\s+%d %d\s" % (width, height), codes), f"{png} has another size than the picture"
    return codes[-3 * width * height:]


def is_bare(viewer: Viewer) -> bool:
    """Whether the window shows the pixels of the picture, but for the few that the mark of a light hides."""
    x, y, width, height = picture_of(viewer)
    codes, screen = codes_of(viewer.shot(exr=False), width, height), viewer.display.pixels()
    places = {(i, j) for i in (*range(0, width, 29), width - 1) for j in (*range(0, height, 23), height - 1)}
    hidden = [(i, j) for i, j in places
              if any(abs(a - b) > 1 for a, b in zip(screen(x + i, y + j), codes[3 * (j * width + i):][:3]))]
    return len(hidden) <= 8


def docking(size: str, scene: str, scale: int = 1):
    """All pixels of the picture are seen, beside a column of the expected width."""
    width, height = map(int, size.split("x"))
    with Display(SCRATCH / f"display_{size}_{scale}", width, height) as display:
        if scale != 1:
            resources(display, f"Xft.dpi:\t{96 * scale}\n")
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENES / scene, "--size", size, *OPTIONS)
        viewer.done()
        viewer.move(5, height - 3)
        viewer.wait(lambda: is_bare(viewer), f"a picture that nothing covers, {size}, scale {scale}", 20)
        x, _, shown, _ = picture_of(viewer)
        assert x + shown == width, (x, shown)
        assert x == min(COLUMN * scale, width - 330 * scale), x
        viewer.changed_by(lambda: viewer.key("w"))
        right = int(max(min(230 * scale, 0.34 * width), min(420 * scale, 0.27 * width)))
        x, _, shown, _ = picture_of(viewer)
        assert abs(x + shown - (width - right)) <= 1, f"the Pixels panel has {width - x - shown} pixels of {width}, not {right}"
        viewer.move(5, height - 3)
        viewer.wait(lambda: is_bare(viewer), f"a picture beside a panel, {size}, scale {scale}", 20)
        viewer.close()


def resources(display: Display, text: str):
    """Sets the X resources, among them how dense the screen is."""
    from Xlib import Xatom
    from Xlib import display as xlib
    connection = xlib.Display(display.environment["DISPLAY"])
    connection.screen().root.change_property(Xatom.RESOURCE_MANAGER, Xatom.STRING, 8, text.encode())
    connection.sync()
    display.connection = connection  # the server forgets the property with its last client


def hiding(display: Display):
    """H gives the window to the picture, which the next run remembers. A camera that frames the scene follows, as render's does."""
    arguments = SCENES / "spheres.gltf", "--camera", "auto", "--size", "900x500", *OPTIONS
    viewer = Viewer(display, STERADIAN, SCRATCH / "hiding", *arguments)
    viewer.done()
    framed(viewer)
    viewer.changed_by(lambda: viewer.key("h"))
    assert picture_of(viewer) == (0, 0, 900, 500), picture_of(viewer)
    framed(viewer)
    viewer.close()
    viewer = Viewer(display, STERADIAN, SCRATCH / "hiding", *arguments, remembers=True)
    viewer.done()
    assert picture_of(viewer) == (0, 0, 900, 500), "the panels are back"
    viewer.changed_by(lambda: viewer.key("h"))
    viewer.wait(lambda: picture_of(viewer)[0] == COLUMN, "the column")
    return viewer


def framed(viewer: Viewer):
    _, _, width, height = picture_of(viewer)
    file = SCRATCH / "framed.exr"
    result = steradian("render", SCENES / "spheres.gltf", "--camera", "auto", "--size", f"{width}x{height}", "--samples", "1",
                       "--visibility", "none", "-o", file)
    assert result.returncode == 0, result.stderr
    assert same(viewer.shot(), file), f"not framed as render does at {width}x{height}"


def widening(viewer: Viewer):
    """The column's edge can be dragged; that is remembered."""
    viewer.pull((COLUMN - 1, 250), (COLUMN + 79, 250))
    viewer.wait(lambda: abs(picture_of(viewer)[0] - COLUMN - 80) <= 2, "a wider column", 20)
    viewer.move(5, 497)
    viewer.wait(lambda: is_bare(viewer), "a picture that nothing covers beside a wider column", 20)


def probing(viewer: Viewer):
    """The table of a probe takes room from the picture, which is shown smaller and not rendered again."""
    before, color = viewer.converged(), (0, 158, 115)  # of the lobe
    x, y, width, height = picture_of(viewer)
    viewer.click(x + width // 2, y + 2 * height // 3)
    viewer.said("Probed pixel")
    viewer.wait(lambda: viewer.count(color) > 50, "a lobe")
    assert viewer.converged() == before, "the picture is rendered again"
    viewer.key("Escape")
    viewer.wait(lambda: viewer.count(color) == 0, "no lobe")
    viewer.move(5, 497)
    viewer.wait(lambda: is_bare(viewer), "the whole picture again", 20)
    assert viewer.converged() == before


def viewing(viewer: Viewer):
    """A view has a legend over the picture. Shift Y gives the false colours the range of the picture. A click on a menu runs its row."""
    lowest, highest = (68, 1, 84), (253, 231, 37)  # the ends of the colour map
    viewer.key("y")
    viewer.said("View: luminance")
    viewer.wait(lambda: min(viewer.count(lowest), viewer.count(highest)) > 20, "both ends of the colour map in the legend")
    viewer.key("shift+y")
    viewer.said("Range: ")
    low, high = map(float, re.findall(r"Range: (\S+) to (\S+) cd/m", viewer.errors())[-1])
    assert 0 < low < high, (low, high)
    viewer.changed_by(lambda: viewer.key("v"))
    viewer.said("View: leaks")
    viewer.wait(lambda: viewer.count(highest) == 0, "no colour map")
    viewer.changed_by(lambda: viewer.key("v"))
    viewer.said("View: radiance")


def main() -> int:
    skip_without("oiiotool", modules=("Xlib",))
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    docking("640x400", "cornell.gltf")
    docking("1280x720", "motion.gltf")  # with an animation's bar
    docking("2560x1440", "veach.gltf")
    docking("1280x800", "motion.gltf", scale=2)
    with Display(SCRATCH / "display", 900, 500) as display:
        viewer = hiding(display)
        widening(viewer)
        probing(viewer)
        viewing(viewer)
        viewer.close()
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENES / "cornell.gltf", "--size", "900x500", *OPTIONS, remembers=True)
        viewer.done()
        assert abs(picture_of(viewer)[0] - COLUMN - 80) <= 2, picture_of(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
