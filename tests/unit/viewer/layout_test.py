#!/usr/bin/env python3
"""Panels of the viewer beside the picture: at every size of the window nothing lies over a pixel. Exit status 77: there is no Xvfb,
xdotool, oiiotool or python-xlib.

usage: layout_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import re
import shutil
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without
from viewer_test import SCENES, SCRATCH, STERADIAN, pixels_of, same, steradian

OPTIONS = "--samples", "1", "--visibility", "none", "--exposure", "8", "--gl-debug"
COLUMN = 290  # width of the left column before scaling


def picture_of(viewer: Viewer) -> tuple[int, int, int, int]:
    """x, y, width and height of the picture in the window, as the viewer says."""
    width, height, x, y = map(int, re.findall(r"converged: .* (\d+)x(\d+) pixels at (\d+),(\d+),", viewer.errors())[-1])
    return x, y, width, height


def is_bare(viewer: Viewer) -> bool:
    """Whether the window shows the pixels of the picture, but for the few that the mark of a light hides."""
    x, y, width, height = picture_of(viewer)
    code, screen = pixels_of(viewer.shot(exr=False), width, height), viewer.display.pixels()
    places = {(i, j) for i in (*range(0, width, 29), width - 1) for j in (*range(0, height, 23), height - 1)}
    hidden = [(i, j) for i, j in places if any(abs(a - b) > 1 for a, b in zip(screen(x + i, y + j), code(i, j)))]
    return len(hidden) <= 8


def docking(viewer: Viewer, width: int, height: int, scale: int = 1):
    """All pixels of the picture are seen, beside columns of the expected width. The picture keeps half of the window's width: where two
    columns would leave it less, panels share one by tabs, and the picture stays as it is."""
    viewer.resize(width, height)
    viewer.wait(lambda: sum(picture_of(viewer)[::2]) == width, f"a picture in a window of {width}x{height}")
    x, _, shown, _ = picture_of(viewer)
    assert x == max(230 * scale, min(COLUMN * scale, width // 2, width - 330 * scale)), x
    assert 2 * shown >= width, (shown, width)
    two = 2 * 460 * scale <= width
    right = int(min(max(230 * scale, min(420 * scale, 0.27 * width)), 0.5 * width - 230 * scale)) if two else 0
    closed = [] if two else at_rest(viewer)
    before, counts, numbers = picture_of(viewer), viewer.converged(), viewer.errors().count("Statistics of ")
    (viewer.changed_by if two else lambda act: act())(lambda: viewer.key("w"))
    viewer.said("Statistics of ", numbers + 1)
    x, _, shown, _ = picture_of(viewer)
    assert abs(x + shown - (width - right)) <= 1, f"the Pixels panel has {width - x - shown} pixels of {width}, not {right}"
    assert 2 * shown >= width - 2, (shown, width)
    assert two or (picture_of(viewer), viewer.converged()) == (before, counts), "a tab has changed the picture"
    see_all(viewer, width, height)
    if two:
        viewer.changed_by(lambda: viewer.key("w"))
    else:
        viewer.key("w")
        viewer.wait(lambda: column_of(viewer) == closed, "the column as it was without the Pixels panel")


def see_all(viewer: Viewer, width: int, height: int):
    if width > 1500:
        return  # its pictures take seconds to write and to read; the smaller ones show the rule
    viewer.move(5, height - 3)
    viewer.wait(lambda: is_bare(viewer), f"a picture that nothing covers, {width}x{height}")


def column_of(viewer: Viewer) -> list[tuple[int, int, int]]:
    """Pixels of the left column, below its tabs."""
    screen = viewer.display.pixels()
    return [screen(x, y) for x in range(4, 225, 5) for y in range(46, 250, 3)]


def at_rest(viewer: Viewer) -> list[tuple[int, int, int]]:
    """The left column once it has stayed the same for a while: a panel takes some frames to find its size."""
    def stays() -> list[tuple[int, int, int]] | None:
        before = column_of(viewer)
        viewer.pause()
        return before if column_of(viewer) == before else None
    return viewer.wait(stays, "a column that stays as it is")


def sharing(viewer: Viewer):
    """A panel that is behind another one comes to the front by its key, before this would close it; so do the controls, by a command
    that needs their fields, or by a click on their tab."""
    viewer.move(5, 397)
    controls = at_rest(viewer)

    def is_shown(pixels, what: str):
        viewer.wait(lambda: column_of(viewer) == pixels, what)

    def another(act, others: list, what: str) -> list:
        act()
        viewer.wait(lambda: column_of(viewer) not in others, what)
        return at_rest(viewer)

    scene = another(lambda: viewer.key("o"), [controls], "the scene")
    pixels = another(lambda: viewer.key("w"), [controls, scene], "the statistics of pixels")
    viewer.key("o")
    is_shown(scene, "the scene in front again")
    viewer.click(25, 30)
    viewer.move(5, 397)
    below_tabs = another(lambda: None, [scene], "the controls by their tab")
    assert below_tabs not in (pixels, controls), "the column has no tabs"
    viewer.key("o")
    is_shown(scene, "the scene in front again")
    viewer.key("h")
    viewer.wait(lambda: picture_of(viewer)[:3] == (0, 0, 640), "a picture without panels")
    viewer.key("o")
    is_shown(scene, "the panel whose key was pressed while panels were hidden")
    viewer.key("o", "o", "o", "o")
    viewer.key("w", "w")
    is_shown(controls, "the controls alone")


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
    viewer.wait(lambda: abs(picture_of(viewer)[0] - COLUMN - 80) <= 2, "a wider column")
    viewer.move(5, 497)
    viewer.wait(lambda: is_bare(viewer), "a picture that nothing covers beside a wider column")


def probing(viewer: Viewer):
    """The table of a probe takes room from the picture, which is shown smaller and not rendered again."""
    before, color = viewer.converged(), (0, 158, 115)  # of the lobe
    x, y, width, height = picture_of(viewer)
    viewer.key("shift+g")  # a grid that goes on beyond the picture
    viewer.click(x + width // 2, y + 2 * height // 3)
    viewer.said("Probed pixel")
    viewer.wait(lambda: viewer.count(color) > 50, "a lobe")
    screen = viewer.display.pixels()
    margin = {screen(i, j) for i in range(x + 1, x + 60) for j in range(y + 20, y + height // 3)}
    assert len(margin) == 1, "marks lie beside the smaller picture"
    viewer.key("shift+g")
    assert viewer.converged() == before, "the picture is rendered again"
    viewer.key("Escape")
    viewer.wait(lambda: viewer.count(color) == 0, "no lobe")
    viewer.move(5, 497)
    viewer.wait(lambda: is_bare(viewer), "the whole picture again")
    assert viewer.converged() == before


def explaining(viewer: Viewer):
    """Between panels on both sides, too, an explained pixel shows what each light adds to it."""
    viewer.changed_by(lambda: viewer.resize(930, 520))
    viewer.changed_by(lambda: viewer.key("w"))
    x, y, width, height = picture_of(viewer)
    viewer.move(x + width // 2, y + height // 2)
    viewer.key("e")
    viewer.said("Explained: ")
    viewer.wait(lambda: viewer.count((44, 69, 86)) + viewer.count((54, 79, 95)) > 50, "a bar of L_r")
    viewer.key("Escape")


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
    with Display(SCRATCH / "display_1", 2560, 1440) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENES / "motion.gltf", "--size", "1280x720", *OPTIONS)  # with a bar
        viewer.done()
        for size in (1280, 720), (2560, 1440), (640, 400):
            docking(viewer, *size)
        sharing(viewer)
        explaining(viewer)
        viewer.close()
    with Display(SCRATCH / "display_2", 1280, 800) as display:
        resources(display, f"Xft.dpi:\t{96 * 2}\n")
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENES / "motion.gltf", "--size", "1280x800", *OPTIONS)
        viewer.done()
        docking(viewer, 1280, 800, scale=2)
        viewer.close()
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
