#!/usr/bin/env python3
"""Light mixer: changes of lights show at once, and are what a render of the saved file shows. Exit status 77: there is no Xvfb, xdotool or
oiiotool.

usage: mixer_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import shutil
import sys

from driver import Display, Viewer, skip_without
from layout_test import picture_of
from viewer_test import SCENES, SCRATCH, STERADIAN, pixels_of, steradian

OPTIONS = "--samples", "1", "--exposure", "8", "--visibility", "none"
MUTED = 213, 94, 0  # a button that is pressed in


def seen(viewer: Viewer):
    """A picture of what is seen, by the viewer's own key."""
    before = set(viewer.folder.glob("*.png"))
    viewer.key("alt+F12")
    return viewer.wait(lambda: set(viewer.folder.glob("*.png")) - before, "a picture of what is seen").pop()


def are_alike(a, b, size: tuple[int, int]) -> bool:
    a, b = pixels_of(a, *size), pixels_of(b, *size)
    places = [(x, y) for x in range(2, size[0], 9) for y in range(2, size[1], 9)]
    return all(abs(p - q) <= 1 for at in places for p, q in zip(a(*at), b(*at)))


def mixing(viewer: Viewer) -> tuple[int, int]:
    """One light muted and the other one twice as bright: no picture is rendered, and it is the one of the saved file."""
    viewer.key("shift+m")
    viewer.said("Mixing 2 lights, 1 samples each.")
    size = picture_of(viewer)[2:]
    rendered, saved, mixed = viewer.converged(), SCRATCH / "mixed.gltf", SCRATCH / "mixed.png"
    before = seen(viewer)
    viewer.key("Tab", "space", "Tab", *3 * ["ctrl+period"])
    viewer.said("lamp 2: +0.33 EV.", 3)
    viewer.wait(lambda: viewer.count(MUTED) > 50, "a muted light")
    after = seen(viewer)
    assert not are_alike(before, after, size), "the mix is as before"
    viewer.key("ctrl+s", "ctrl+a")
    viewer.type(str(saved))
    viewer.wait(saved.exists, "a saved file")
    result = steradian("render", saved, "--size", "{}x{}".format(*size), *OPTIONS, "-o", mixed)
    assert result.returncode == 0, result.stderr
    assert are_alike(after, mixed, size), "the mix is not what the saved file shows"
    assert viewer.converged() == rendered, "a picture was rendered"
    return size


def press(viewer: Viewer, x: int, y: int):
    """Clicks the button whose upper left corner this is, as a person does: it is lit under the pointer, then pressed in, then released
    there. A pointer that has left when the button is released does not click."""
    def changes_by(*action):
        before = viewer.screen(x + 2, y + 2)  # left of the pointer, which is on the screen, too
        viewer.display.do(*action)
        viewer.wait(lambda: viewer.screen(x + 2, y + 2) != before, f"a button that answers to {action[0]}")

    changes_by("mousemove", x + 7, y + 7)
    changes_by("mousedown", 1)
    changes_by("mouseup", 1)


def switching(viewer: Viewer):
    """A click on the lit button switches the light on; undoing that keeps mixing."""
    width, _ = viewer.display.size()
    words = list(viewer.display.words())
    wanted = MUTED[0] << 16 | MUTED[1] << 8 | MUTED[2]
    y, x = divmod(next(i for i, word in enumerate(words) if word & 0xffffff == wanted), width)
    press(viewer, x, y)
    viewer.move(5, 5)
    viewer.wait(lambda: viewer.count(MUTED) == 0, "no muted light")
    viewer.key("ctrl+z")
    viewer.said("Undone: enabling lamp 1.")
    viewer.wait(lambda: viewer.count(MUTED) > 50, "the muted light again")
    assert "Mixing has ended." not in viewer.errors(), viewer.errors()


def grouping(viewer: Viewer):
    """Lights whose names differ in a number have a common fader, which brightens both by as much."""
    viewer.key("ctrl+y")
    viewer.said("Redone: enabling lamp 1.")
    quantities = []
    for number in 1, 2:
        viewer.pull((875, 102), (875 + 20 * number, 102))
        saved = SCRATCH / f"group{number}.gltf"
        viewer.fields = viewer.errors().count("text field focused")
        viewer.key("ctrl+s", "ctrl+a")
        viewer.type(str(saved))
        viewer.wait(saved.exists, "a saved file")
        lamps = [node for node in json.loads(saved.read_text())["nodes"] if node.get("name") in ("lamp 1", "lamp 2")]
        quantities.append([lamp["extras"]["steradian"]["quantity"]["value"] for lamp in lamps])
    ratios = [after / before for before, after in zip(*quantities)]
    assert len(ratios) == 2 and ratios[0] > 1.2 and abs(ratios[0] / ratios[1] - 1) < 1e-4, (quantities, ratios)
    undone = viewer.errors().count("Undone: enabling lamp 1.")
    viewer.key(*3 * ["ctrl+z"])
    viewer.said("Undone: enabling lamp 1.", undone + 1)
    viewer.wait(lambda: viewer.count(MUTED) > 50, "the muted light again")
    viewer.pull((875, 102), (905, 102))
    assert viewer.count(MUTED) > 50, "the fader of the group switched a muted light on"
    count = viewer.errors().count("Saved ")
    viewer.fields = viewer.errors().count("text field focused")
    viewer.key("ctrl+s")
    viewer.type("")
    viewer.said("Saved ", count + 1)


def main() -> int:
    skip_without("oiiotool")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    with Display(SCRATCH / "display", 1000, 500) as display:
        scene = (SCENES / "spheres.gltf").read_text()
        (SCRATCH / "spheres.gltf").write_text(scene.replace('"softbox"', '"lamp 1"').replace('"bulb"', '"lamp 2"'))
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCRATCH / "spheres.gltf", "--size", "1000x500", *OPTIONS, "--gl-debug")
        viewer.done()
        viewer.move(5, 5)
        size = mixing(viewer)
        switching(viewer)
        grouping(viewer)
        viewer.changed_by(lambda: viewer.key("shift+m"))
        viewer.wait(lambda: picture_of(viewer)[2] > size[0], "the room of the panel")
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
