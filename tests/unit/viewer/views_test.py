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

SCENE = SCENES / "spheres.gltf"
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
    """V goes through all views. Each shows other pixels than the one before; those of each way to finish are the command's."""
    names, (x, y, *size) = views(), picture_of(viewer)
    assert {"irradiance", "wireframe", "visibility", "roughness"} < set(names), names

    def pixels() -> list[tuple[int, int, int]]:
        pixel = viewer.display.pixels()
        return [pixel(x + i, y + j) for i in range(0, size[0], 7) for j in range(0, size[1] - 90, 7)]  # above the legend

    before = pixels()
    for name in names:
        if name == "luminance":  # radiance in other colours: nothing is rendered
            viewer.key("v")
            viewer.said("View: luminance, ")
        elif name in ("irradiance", "wireframe", "overdraw", "leaks"):
            film = chosen(viewer, lambda: viewer.key("v"), f"View: {name}, ")
            assert same(film, rendered(name, size)), f"{name} is another picture than that of render --view"
        else:
            viewer.changed_by(lambda: viewer.key("v"))
            viewer.said(f"View: {name}, ")
        now = viewer.wait(lambda: pixels() if pixels() != before else None, f"other pixels in {name}", 10)
        before = now
    viewer.key("v")
    viewer.said("View: radiance.")


def lights(viewer: Viewer):
    """Shift V shows the irradiance by each light alone: the sum is the irradiance by all. Nothing is edited, Esc ends it."""
    whole = chosen(viewer, lambda: click_view(viewer, "irradiance"), "View: irradiance, ")
    names = "softbox", "bulb"
    parts = [chosen(viewer, lambda: viewer.key("shift+v"), f"Only {name}, {n + 1} of 2.") for n, name in enumerate(names)]
    assert not same(parts[0], parts[1]), "both lights make the same picture"
    total = SCRATCH / "sum.exr"
    subprocess.run(["oiiotool", *parts, "--add", "-o", total], check=True)
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
