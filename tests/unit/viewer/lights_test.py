#!/usr/bin/env python3
"""Lights in the view: their lines, a click on them, adding, duplicating and renaming. Exit status 77: there is no Xvfb or xdotool.

usage: lights_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import shutil
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without

STERADIAN, SCENES, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
SIZE = 800, 500
OPTIONS = "--size", "800x500", "--samples", "1", "--visibility", "none", "--exposure", "8", "--gl-debug"
LIST = 60, 218  # a place in the list of lights
LINES = 230, 159, 0  # of the selected light


def places_of(viewer: Viewer, color: tuple[int, int, int]) -> list[tuple[int, int]]:
    """Where the picture has this colour, as x and y."""
    width, _ = viewer.display.size()
    wanted = color[0] << 16 | color[1] << 8 | color[2]
    places = (divmod(i, width) for i, word in enumerate(viewer.display.words()) if word & 0xffffff == wanted)
    return [(x, y) for y, x in places if x > 300]


def adding(viewer: Viewer):
    """Shift A asks for a kind. The new light is seen by its lines, and lights what is looked at."""
    viewer.key("shift+a")
    viewer.said("Asked: Add which light?")
    viewer.changed_by(lambda: viewer.key("r"))
    viewer.said("Added a light: rectangle.")
    viewer.wait(lambda: len(places_of(viewer, LINES)) > 60, "the lines of the new light")
    viewer.changed_by(lambda: viewer.key("shift+space"))  # alone
    viewer.changed_by(lambda: viewer.key("h"))
    viewer.wait(lambda: 40 < max(viewer.screen(SIZE[0] // 2, SIZE[1] // 2)) < 250, "a picture that is neither dark nor white")
    viewer.changed_by(lambda: viewer.key("h"))
    viewer.changed_by(lambda: viewer.key("ctrl+z"))


def naming(viewer: Viewer):
    """A copy gets another name; the saved file has both."""
    viewer.changed_by(lambda: viewer.key("shift+d"))
    viewer.said("Added new rectangle copy.")
    viewer.key("F2", "ctrl+a")
    viewer.type("desk")
    saved = SCRATCH / "more.gltf"
    viewer.key("ctrl+s", "ctrl+a")
    viewer.type(str(saved))
    viewer.wait(saved.exists, "a saved file")
    nodes = {node.get("name"): node for node in json.loads(saved.read_text())["nodes"]}
    a, b = nodes["new rectangle"], nodes["desk"]
    assert a["extras"] == b["extras"] and a["matrix"][12] != b["matrix"][12], (a, b)


def picking(viewer: Viewer):
    """A click on the outline selects the light; with Ctrl it is added or taken away."""
    shown = places_of(viewer, LINES)
    assert len(shown) > 60, "no lines"
    corner = min(shown, key=sum)  # the upper left, where the other light is not
    viewer.key("Escape")
    viewer.wait(lambda: not places_of(viewer, LINES), "no light selected")
    before = viewer.errors().count("Selected desk.")
    viewer.click(*corner)
    viewer.said("Selected desk.", before + 1)
    viewer.wait(lambda: len(places_of(viewer, LINES)) > 60, "its lines again")
    for said in "No light is selected.", "Selected desk.":  # a click with Ctrl takes it away, and adds it
        count = viewer.errors().count(said)
        viewer.display.do("keydown", "ctrl", "mousemove", *corner, "click", "1", "keyup", "ctrl")
        viewer.said(said, count + 1)
    viewer.key("Return")  # the value's field takes keys, until Esc leaves it
    viewer.type("500 lm")
    viewer.said("desk: 500 lm")


def several(viewer: Viewer):
    """Shift Up over the list selects what it passes, edits are of all and undone in one step."""
    viewer.move(*LIST)
    viewer.pause()
    viewer.key("shift+Up")
    viewer.said("Selected 2 lights.")
    for keys, said, undone in ((["ctrl+period"], "2 lights: +0.33 EV.", "value of 2 lights"),
                               (["g", "x", "1", "Return"], "moved by 1.000 0.000 0.000 m", "transform of 2 lights"),
                               (["space"], None, "disabling 2 lights"), (["shift+d"], "Added 2 lights.", "adding 2 lights")):
        viewer.key(*keys)
        if said:
            viewer.said(said)
        count = viewer.errors().count(f"Undone: {undone}.")
        viewer.key("ctrl+z")
        viewer.said(f"Undone: {undone}.", count + 1)


def last_of_the_list(viewer: Viewer):
    """In a scene whose new lights are the last ones: two are added, and undoing drops the selection with the light."""
    viewer.key("ctrl+o")
    viewer.type(str(SCENES / "spheres.gltf"))
    viewer.wait(lambda: viewer.title().startswith("spheres.gltf - done"), "the other scene")
    for key, kind in ("p", "point"), ("t", "tube"):
        asked = viewer.errors().count("Asked: Add which light?")
        viewer.key("shift+a")
        viewer.said("Asked: Add which light?", asked + 1)
        viewer.key(key)
        viewer.said(f"Added a light: {kind}.")
    viewer.wait(lambda: len(places_of(viewer, LINES)) > 20, "the lines of the tube")
    several(viewer)
    for _ in range(2):
        undone = viewer.errors().count("Undone: ")
        viewer.key("ctrl+z")
        viewer.said("Undone: ", undone + 1)
    viewer.wait(lambda: not viewer.title().startswith("*"), "no unsaved edits")


def main() -> int:
    skip_without()
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    shutil.copy(SCENES / "cornell.gltf", SCRATCH)
    with Display(SCRATCH / "display", *SIZE) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCRATCH / "cornell.gltf", *OPTIONS)
        viewer.done()
        viewer.move(310, 60)
        adding(viewer)
        naming(viewer)
        picking(viewer)
        saved = viewer.errors().count("Saved ")
        viewer.key("ctrl+s")
        viewer.type("")
        viewer.said("Saved ", saved + 1)
        last_of_the_list(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
