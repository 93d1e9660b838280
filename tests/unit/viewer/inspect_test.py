#!/usr/bin/env python3
"""The scene panel of the viewer: objects are hidden, isolated and framed; a material is edited, undone and saved. Exit status 77: there
is no Xvfb, xdotool or oiiotool.

usage: inspect_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import re
import shutil
import sys

from driver import Display, Viewer, skip_without
from viewer_test import SCENES, SCRATCH, STERADIAN, same

OPTIONS = "--size", "1000x600", "--samples", "1", "--visibility", "none", "--exposure", "8", "--gl-debug"
BALL = 470, 330  # a place of the window that shows an object


def camera_of(viewer: Viewer) -> str:
    return re.findall(r"--camera '([^']*)'", viewer.errors())[-1]


def inspecting(viewer: Viewer) -> str:
    """Shift O over an object opens the panel, which makes the picture narrower. @return the name of the object"""
    viewer.move(*BALL)
    viewer.changed_by(lambda: viewer.key("shift+o"))
    viewer.said("Inspecting ")
    return re.findall(r"Inspecting (.*)\.", viewer.errors())[-1]


def hiding(viewer: Viewer):
    """What is hidden is not in the picture, nor anything that it does there; all comes back."""
    before = viewer.shot()
    viewer.changed_by(lambda: viewer.key("shift+h"))
    viewer.said("1 of ")
    assert not same(viewer.shot(), before), "it is in the picture"
    viewer.changed_by(lambda: viewer.key("alt+h"))
    viewer.said("All objects are shown.")
    assert same(viewer.shot(), before)
    viewer.changed_by(lambda: viewer.key("slash"))
    count, total = map(int, re.findall(r"(\d+) of (\d+) objects are hidden", viewer.errors())[-1])
    assert count == total - 1, (count, total)
    camera = camera_of(viewer)
    viewer.changed_by(lambda: viewer.key("f"))
    assert camera_of(viewer) != camera, "the object is not framed"
    viewer.changed_by(lambda: viewer.key("slash"))
    viewer.said("All objects are shown.", 2)
    viewer.changed_by(lambda: viewer.key("0"))


def emitting(viewer: Viewer):
    """A material that gets an emission lights the picture, and is among the lights; undo makes it dark again."""
    viewer.display.do("mousemove", 850, 500, "click", "--repeat", 30, 5)  # the end of the panel, where the field is
    viewer.pause()
    before = viewer.shot()
    viewer.changed_by(lambda: viewer.pull((758, 542), (798, 542)))
    viewer.move(5, 595)
    assert not same(viewer.shot(), before), "the material emits nothing"
    viewer.changed_by(lambda: viewer.key("ctrl+z"))
    viewer.said("Undone: emission of ")
    assert same(viewer.shot(), before)
    viewer.changed_by(lambda: viewer.key("ctrl+y"))


def editing(viewer: Viewer, slider: tuple[int, int]):
    """A drag of the slider changes the roughness in the picture. Undo takes it back, redo brings it again, a saved file has it."""
    before = viewer.shot()
    viewer.changed_by(lambda: viewer.pull(slider, (slider[0] + 40, slider[1])))
    edited = viewer.shot()
    assert not same(edited, before), "the material is as it was"
    assert viewer.title().startswith("*"), viewer.title()
    viewer.changed_by(lambda: viewer.key("ctrl+z"))
    viewer.said("Undone: material ")
    assert same(viewer.shot(), before)
    viewer.changed_by(lambda: viewer.key("ctrl+y"))
    assert same(viewer.shot(), edited)
    viewer.click(slider[0], slider[1] + 40)  # the branch "clearcoat", and its first slider
    viewer.pause()
    viewer.changed_by(lambda: viewer.pull((slider[0] - 20, slider[1] + 60), (slider[0] + 20, slider[1] + 60)))
    assert not same(viewer.shot(), edited), "the material has no coat"
    emitting(viewer)
    target = SCRATCH / "saved.gltf"
    viewer.key("ctrl+s")
    viewer.type(str(target))
    viewer.said("Saved ")
    return json.loads(target.read_text())


def main() -> int:
    skip_without("oiiotool")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    with Display(SCRATCH / "display", 1000, 600) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENES / "spheres.gltf", *OPTIONS)
        viewer.done()
        name = inspecting(viewer)
        hiding(viewer)
        saved = editing(viewer, (800, 485))
        file = json.loads((SCENES / "spheres.gltf").read_text())
        changed = [new["name"] for old, new in zip(file["materials"], saved["materials"]) if old != new]
        assert len(changed) == 1 and name, (name, changed)
        coats = [m["extensions"]["KHR_materials_clearcoat"] for m in saved["materials"] if m["name"] == changed[0]]
        assert coats[0]["clearcoatFactor"] > 0 and "KHR_materials_clearcoat" in saved["extensionsUsed"], coats
        emissions = [m["extras"]["steradian"]["quantity"] for m in saved["materials"] if m["name"] == changed[0]]
        assert emissions[0]["value"] > 1 and emissions[0]["unit"] == "cd/m^2", emissions
        for key in "o", "o", "o", "o":
            viewer.key(key)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
