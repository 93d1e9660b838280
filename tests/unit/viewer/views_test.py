#!/usr/bin/env python3
"""Views of the viewer: each entry of the menu is the picture of `render --view`, pictures by one light alone add up, one of any size is
exported, and kept ones are compared. Exit status 77: there is no Xvfb, xdotool or oiiotool.

usage: views_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without
from layout_test import picture_of
from viewer_test import SCENES, SCRATCH, STERADIAN, provenance, same

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
        now = viewer.wait(lambda: pixels() if pixels() != before else None, f"other pixels in {name}")
        before = now
    viewer.changed_by(lambda: viewer.key("v"))
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


def exporting(viewer: Viewer):
    """A picture of another size and shape than the window's is that of render. Esc cancels one, and nothing is written. What would change the
    picture meanwhile says why it does not."""
    def fill(size: str, samples: str, target: Path):
        viewer.fill("ctrl+e", "export", {"size": size, "samples": samples, "error": "", "file": str(target)})

    target, file = SCRATCH / "exported.exr", SCRATCH / "exported_by_render.exr"
    converged = viewer.converged()
    fill("150x240", "3", target)
    viewer.said(f"Wrote {target}: 150x240 pixels.")
    subprocess.run([STERADIAN, "render", SCENE, "-o", file, "--size", "150x240", *METHOD[2:], "--samples", "3"], check=True)
    assert same(target, file), "not the picture that render makes of that size"
    assert provenance(target) == provenance(file), provenance(target) ^ provenance(file)
    assert viewer.converged() == converged, "the picture in the window was rendered again"
    never = SCRATCH / "never.png"
    fill("1500x1200", "65536", never)
    begun = f"Exporting {never} at 1500x1200."
    viewer.wait(lambda: begun in viewer.errors(), begun, interval=0.001)
    viewer.key("Escape")  # in the frame after Enter, in which the field still had the keyboard
    viewer.said("Export cancelled: no file is written.")
    assert not never.exists()
    converged = viewer.converged()
    fill("1500x1200", "65536", never)
    viewer.said(f"Exporting {never} at 1500x1200.", 2)
    for key, name in ("v", "Next view"), ("ctrl+period", "Brighten the light"), ("ctrl+F12", ""):
        viewer.key(key)
        viewer.said(f"{name} would change what is exported. Now: exporting" if name else "Now: exporting", 1 if name else 3)
    click_view(viewer, "radiance")
    viewer.said("Next view would change what is exported.", 2)
    viewer.key("Escape")
    viewer.said("Export cancelled: no file is written.", 2)
    assert viewer.converged() == converged and not viewer.title().startswith("*"), "what was refused has changed the picture"


def keeping(viewer: Viewer):
    """Two pictures are kept, shown in turns with the render, and measured against each other as `compare` does it."""
    chosen(viewer, lambda: click_view(viewer, "radiance"), "View: radiance.")
    viewer.key("comma")  # an exposure that does not follow the picture
    shots = []
    for letter in "AB":
        shots.append(chosen(viewer, lambda: viewer.key("shift+v"), "Only "))
        viewer.key("ctrl+k")
        viewer.said(f"It is picture {letter}.")
    viewer.changed_by(lambda: viewer.key("Escape"))  # ends the picture by one light
    viewer.key("b", "b", "b")  # difference, FLIP map, the picture alone
    viewer.said("Comparison: render alone.")
    viewer.pause()
    x, y, width, height = picture_of(viewer)

    def pixels() -> tuple:
        pixel = viewer.display.pixels()
        return tuple(pixel(x + i, y + j) for i in range(5, width, 40) for j in range(60, height, 40))  # below the caption

    seen = [pixels()]
    for said in "Picture A: ", "Picture B: ", "The render.", "Picture A: ":
        viewer.key("shift+k")
        viewer.said(said, 1 + (len(seen) == 4))
        seen.append(viewer.wait(lambda: pixels() if pixels() != seen[-1] else None, f"other pixels: {said}"))
    render, a, b, render_again, a_again = seen
    assert (render, a) == (render_again, a_again) and len({render, a, b}) == 3, seen
    viewer.key("alt+k")
    viewer.said("Measured A against B: relMSE ")
    measured = float(re.findall(r"Measured A against B: relMSE (\S+),", viewer.errors())[-1])
    told = subprocess.run([STERADIAN, "compare", *shots, "--json"], capture_output=True, text=True)
    expected = json.loads(told.stdout)["metrics"]["rel_mse"]
    assert abs(measured / expected - 1) < 1e-3, (measured, expected)
    viewer.key("ctrl+shift+k")
    viewer.said("Comparing A against A.")


def timing(viewer: Viewer):
    """Shift T shows the time of a sample by parts: their sum is the time that the message area has."""
    viewer.key("shift+t")
    viewer.said("A sample: ")

    def parts() -> dict[str, float]:
        found = re.findall(r"([a-z ]+) (-?[0-9.]+) ms", re.findall(r"A sample: (.*)", viewer.errors())[-1])
        values = {name.strip(): float(value) for name, value in found}
        sample = float(re.findall(r"converged: .*, (\S+) ms each", viewer.errors())[-1])
        assert min(values.values()) >= 0 and abs(sum(values.values()) - sample) < 0.1, (values, sample)
        return values

    assert [*parts()] == ["surfaces", "shadow rays"], parts()
    viewer.changed_by(lambda: viewer.key("Left"))  # from its first sample on, a picture is measured by pass
    viewer.said("A sample: ", 2)
    passes = parts()
    assert [*passes] == ["depth", "shading", "shadow rays", "adding", "the rest"], passes
    assert passes["shading"] > passes["the rest"] and passes["depth"] > 0 and passes["adding"] > 0, passes
    viewer.key("shift+t")


def click_view(viewer: Viewer, name: str):
    """Chooses an entry of the Views menu by the pointer; radiance is the first one."""
    viewer.click(*MENU)
    viewer.pause()
    line = 18 * (0 if name == "radiance" else 1 + views().index(name))
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
        exporting(viewer)
        lights(viewer)
        keeping(viewer)
        timing(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
