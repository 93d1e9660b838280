#!/usr/bin/env python3
"""Explain: the terms of a probed pixel with their lines of GLSL, and the picture without a term. Exit status 77: there is no Xvfb, xdotool or
oiiotool.

usage: explain_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import shutil
import sys

from driver import Display, Viewer, skip_without
from viewer_test import SCENES, SCRATCH, STERADIAN, pixels_of, steradian

SIZE = 900, 560
OPTIONS = "--size", "900x560", "--samples", "1", "--exposure", "8"
CHOSEN = 120, 84, 0  # the cell of the chosen term


def rendered(name: str, *options: str):
    """The picture of `render`, as a function from x, y to code values."""
    file = SCRATCH / f"{name}.png"
    result = steradian("render", SCENES / "spheres.gltf", *OPTIONS, *options, "-o", file)
    assert result.returncode == 0, result.stderr
    return pixels_of(file, *SIZE)


def cell_at(viewer: Viewer) -> tuple[int, int, int, int]:
    """Left, top, right and bottom of the chosen cell."""
    width, _ = viewer.display.size()
    words = viewer.display.words()
    wanted = CHOSEN[0] << 16 | CHOSEN[1] << 8 | CHOSEN[2]
    places = [divmod(i, width) for i, word in enumerate(words) if word & 0xffffff == wanted]
    rows, columns = zip(*places)
    return min(columns), min(rows), max(columns), max(rows)


def choosing(viewer: Viewer):
    """E explains the pixel under the pointer. A click on a number shows the line that computes it; Shift E goes on to the next term."""
    viewer.move(650, 470)
    viewer.key("e")
    viewer.said("Explained: fᵣ of softbox, shaders/brdf/models/metallic_roughness.glsl:6")
    viewer.wait(lambda: viewer.count(CHOSEN) > 100, "a chosen number")
    left, top, right, bottom = cell_at(viewer)
    viewer.click(right + (right - left) // 2, (top + bottom) // 2)
    viewer.said("Explained: L of softbox, shaders/light/rectangle.glsl:")
    viewer.key("shift+e")
    viewer.said("Explained: V of softbox, shaders/visibility/ray.glsl:")


def is_of(viewer: Viewer, left, right) -> bool:
    """Whether the window shows these pictures on the two sides of its middle."""
    screen, middle = viewer.display.pixels(), SIZE[0] // 2
    places = [(x, y) for x in range(7, SIZE[0], 12) for y in range(40, SIZE[1], 12) if abs(x - middle) > 3]
    other = [(x, y) for x, y in places
             if any(abs(a - b) > 1 for a, b in zip(screen(x, y), (left if x < middle else right)(x, y)))]
    return len(other) <= len(places) // 100  # the mark of a light


def leaving_out(viewer: Viewer):
    """The picture without V is the one of `render --visibility none`; without cosθ it is brighter. Esc takes the term back."""
    whole, lit = rendered("whole"), rendered("lit", "--visibility", "none")
    viewer.key("alt+e")
    viewer.said("Right: without V.")
    viewer.said("The picture without the term has converged.")
    viewer.changed_by(lambda: viewer.key("h"))
    viewer.said("The picture without the term has converged.", 2)
    viewer.wait(lambda: is_of(viewer, whole, lit), "the picture without shadows beside the picture")
    viewer.key("alt+e")
    viewer.said("The term is back.")
    viewer.wait(lambda: is_of(viewer, whole, whole), "the picture alone")
    viewer.key("shift+e", "alt+e")
    viewer.said("Right: without cos θᵢ.")
    viewer.said("The picture without the term has converged.", 3)

    def is_brighter() -> bool:
        screen = viewer.display.pixels()
        floor = [(x, y) for x in range(480, 880, 20) for y in range(500, 550, 10)]
        return sum(sum(screen(*at)) for at in floor) > 1.05 * sum(sum(whole(*at)) for at in floor)
    viewer.wait(is_brighter, "a brighter floor")
    viewer.key("Escape")
    viewer.said("The term is back.", 2)
    viewer.wait(lambda: is_of(viewer, whole, whole), "the picture alone again")


def ending(viewer: Viewer):
    """Another light ends the explanation, whose numbers do not hold any more."""
    viewer.changed_by(lambda: viewer.key("h"))
    viewer.wait(lambda: viewer.count(CHOSEN) > 100, "the numbers again")
    viewer.changed_by(lambda: viewer.key("Tab", "space"))
    viewer.wait(lambda: viewer.count(CHOSEN) == 0, "no numbers")
    viewer.changed_by(lambda: viewer.key("ctrl+z"))


def main() -> int:
    skip_without("oiiotool")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    with Display(SCRATCH / "display", *SIZE) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENES / "spheres.gltf", *OPTIONS, "--gl-debug")
        viewer.done()
        choosing(viewer)
        leaving_out(viewer)
        ending(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
