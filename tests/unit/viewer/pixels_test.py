#!/usr/bin/env python3
"""Pixels of the viewer: enlarged with their numbers, statistics of a rectangle, pinned pixels. Exit status 77: there is no Xvfb, xdotool or
oiiotool.

usage: pixels_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without
from layout_test import picture_of
from viewer_test import SCENES, SCRATCH, STERADIAN, same

OPTIONS = "--size", "1200x500", "--samples", "1", "--visibility", "none", "--exposure", "8", "--gl-debug"


def statistics_of(viewer: Viewer) -> tuple[str, float, float]:
    """Rectangle, mean and maximum of luminance, as the viewer said last."""
    found = re.findall(r"Statistics of the render, (\S+): mean (\S+), at most (\S+)\.", viewer.errors())[-1]
    return found[0], float(found[1]), float(found[2])


def luminance_of(exr: Path, cut: str | None = None) -> tuple[float, float]:
    """Mean and maximum of luminance by another program."""
    crop = ["--cut", cut] if cut else []
    weights = "--mulc", "0.2126,0.7152,0.0722", "--chsum"
    result = subprocess.run(["oiiotool", exr, *crop, "--ch", "R,G,B", *weights, "--printstats"], capture_output=True, text=True,
                            check=True).stdout
    return float(re.search(r"Stats Avg: +(\S+)", result)[1]), float(re.search(r"Stats Max: +(\S+)", result)[1])


def close_to(a: float, b: float) -> bool:
    return abs(a - b) < 1e-3 * abs(b)


def measuring(viewer: Viewer) -> Path:
    """W shows statistics of the picture, which stays as it is; a Shift drag those of a rectangle."""
    viewer.changed_by(lambda: viewer.key("w"))
    viewer.said("Statistics of ")
    film = viewer.shot()
    x, y, width, height = picture_of(viewer)
    viewer.wait(lambda: statistics_of(viewer)[0] == f"{width}x{height}+0+0", "statistics of all pixels")
    _, mean, most = statistics_of(viewer)
    assert close_to(mean, luminance_of(film)[0]) and close_to(most, luminance_of(film)[1]), (mean, most, luminance_of(film))
    viewer.display.do("keydown", "shift")
    viewer.pull((x + 120, y + 200), (x + 179, y + 229))
    viewer.display.do("keyup", "shift")
    viewer.wait(lambda: statistics_of(viewer)[0] != f"{width}x{height}+0+0", "statistics of a rectangle")
    viewer.pause()
    cut, mean, most = statistics_of(viewer)
    assert all(abs(a - b) <= 3 for a, b in zip(map(int, re.findall(r"\d+", cut)), (60, 30, 120, 200))), cut
    expected = luminance_of(film, cut)
    assert close_to(mean, expected[0]) and close_to(most, expected[1]), (mean, most, expected)
    assert same(viewer.shot(), film), "looking at the film has changed it"
    viewer.key("Escape")
    viewer.wait(lambda: statistics_of(viewer)[0] == f"{width}x{height}+0+0", "statistics of all pixels again")
    viewer.move(x + 50, y + 70)
    viewer.key("shift+w")
    viewer.said("Pinned pixel 50,70.")
    return film


def are_16_wide(viewer: Viewer, x: int, y: int, width: int) -> bool:
    """Whether a row of the picture is drawn in steps of 16, or twice that where neighbours are alike."""
    columns = [viewer.screen(x + i, y + 4) for i in range(width)]
    edges = [i for i in range(1, width) if columns[i] != columns[i - 1]]
    sides = [b - a for a, b in zip(edges, edges[1:])]
    wide = sum(14 <= side <= 16 or 29 <= side <= 32 for side in sides)  # the others have a light's mark
    return wide > 8 and wide > 0.7 * len(sides)


def enlarging(viewer: Viewer, film: Path):
    """An enlarged pixel is a square of its colour. A drag moves the pixels, a click probes the one below it, Esc ends it."""
    x, y, width, height = picture_of(viewer)
    at = x + 120, y + 200
    color = viewer.screen(*at)
    viewer.move(*at)
    viewer.key("z", "z", "z", "z")
    viewer.said("16 times as large")
    viewer.move(5, 497)  # the pointer has colours of its own
    viewer.wait(lambda: are_16_wide(viewer, x, y, width), "pixels that are about 16 wide")
    viewer.wait(lambda: viewer.screen(at[0], at[1]) == color, "the same pixel where the pointer was")
    before = viewer.converged()
    viewer.drag((x + 100, y + 100), (x + 164, y + 100))
    viewer.wait(lambda: viewer.screen(at[0] + 64, at[1]) == color, "the pixels 64 further right")
    viewer.click(at[0] + 64, at[1])
    viewer.said("Probed pixel 120,200.")
    viewer.key("Escape", "Escape")
    viewer.said("Pixels have their size again.")
    assert viewer.converged() == before, "the picture is rendered again"
    assert same(viewer.shot(), film)


def keeping(viewer: Viewer):
    """While a kept picture is shown, the panel has its numbers and says so; a probe, which is of the render, says why it does not probe."""
    viewer.key("ctrl+k")
    viewer.said("It is picture A.")
    _, mean, most = statistics_of(viewer)
    viewer.key("b", "b", "b")  # difference, FLIP map, the picture alone
    viewer.said("Comparison: render alone.")
    viewer.changed_by(lambda: viewer.key("Tab", "ctrl+period"))
    viewer.wait(lambda: statistics_of(viewer)[1] > 1.02 * mean, "statistics of the brighter render")
    viewer.key("shift+k")
    viewer.said("Statistics of picture A, ")
    kept = re.findall(r"Statistics of picture A, \S+ mean (\S+), at most (\S+)\.", viewer.errors())[-1]
    assert close_to(float(kept[0]), mean) and close_to(float(kept[1]), most), (kept, mean, most)
    x, y, *_ = picture_of(viewer)
    viewer.move(x + 50, y + 70)
    viewer.key("p")
    viewer.said("Picture A is shown, and a probe is of the render. Esc goes back to it.")
    said = viewer.errors().count("Statistics of the render")
    viewer.key("Escape")
    viewer.said("Statistics of the render", said + 1)
    viewer.key("ctrl+z")


def main() -> int:
    skip_without("oiiotool", modules=("Xlib",))
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    with Display(SCRATCH / "display", 1200, 500) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENES / "cornell.gltf", *OPTIONS)
        viewer.done()
        enlarging(viewer, measuring(viewer))
        keeping(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
