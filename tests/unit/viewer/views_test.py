#!/usr/bin/env python3
"""Views of the viewer: each entry of the menu is the picture of `render --view`, and pictures by one light alone add up. Exit status 77:
there is no Xvfb, xdotool or oiiotool.

usage: views_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without
from layout_test import picture_of
from viewer_test import SCENES, SCRATCH, STERADIAN, same

SCENE = SCENES / "office.gltf"
METHOD = "--samples", "1", "--visibility", "none"
MENU = 560, 10


def views() -> list[str]:
    """Those that `render --help` lists, in the order of the menu."""
    shown = subprocess.run([STERADIAN, "render", "--help"], capture_output=True, text=True, check=True).stdout
    return re.findall(r"(?:hdr: |\), )([a-z]+) \(", re.search(r"--view NAME .*", shown)[0])


def rendered(view: str, size: tuple[int, int]) -> Path:
    target = SCRATCH / f"{view}.exr"
    subprocess.run([STERADIAN, "render", SCENE, "--view", view, "-o", target, "--size", "{}x{}".format(*size), *METHOD], check=True,
                   capture_output=True)
    return target


def chosen(viewer: Viewer, act, said: str) -> Path:
    """The picture after it was changed by something that the viewer answers with these words."""
    count = viewer.errors().count(said)
    viewer.changed_by(act)
    viewer.said(said, count + 1)
    return viewer.shot()


def all_views(viewer: Viewer):
    """V goes through all views, and each has the pixels of the command."""
    names, (_, _, *size) = views(), picture_of(viewer)
    assert {"irradiance", "wireframe", "visibility", "roughness"} < set(names), names
    for name in names:
        film = chosen(viewer, lambda: viewer.key("v"), f"View: {name}, ") if name != "luminance" else None
        if film is None:  # radiance in other colours: nothing is rendered
            viewer.key("v")
            viewer.said("View: luminance, ")
            continue
        assert same(film, rendered(name, size)), f"{name} is another picture than that of render --view"
    viewer.key("v")
    viewer.said("View: radiance.")


def lights(viewer: Viewer):
    """Shift V shows the irradiance by each light alone: the sum is the irradiance by all. Nothing is edited, Esc ends it."""
    whole = chosen(viewer, lambda: click_view(viewer, "irradiance"), "View: irradiance, ")
    parts = [chosen(viewer, lambda: viewer.key("shift+v"), f"Only panel {n}, {n} of 6.") for n in range(1, 7)]
    assert not same(parts[0], parts[1]), "both lights make the same picture"
    total = SCRATCH / "sum.exr"
    subprocess.run(["oiiotool", *parts, *["--add"] * 5, "-o", total], check=True)
    assert same(total, whole), "the pictures of single lights do not add up"
    assert same(chosen(viewer, lambda: viewer.key("Escape"), "All lights."), whole)
    assert not viewer.title().startswith("*"), "a view is an edit"


def click_view(viewer: Viewer, name: str):
    """Chooses an entry of the Views menu by the pointer; radiance is the first one."""
    viewer.click(*MENU)
    viewer.pause()
    line = 18 * (1 + views().index(name))
    viewer.click(MENU[0] + 20, MENU[1] + 26 + line)
    viewer.pause()
    viewer.move(5, 395)


def main() -> int:
    skip_without("oiiotool")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    with Display(SCRATCH / "display", 640, 400) as display:
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", SCENE, "--size", "640x400", *METHOD, "--gl-debug")
        viewer.done()
        all_views(viewer)
        lights(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
