#!/usr/bin/env python3
"""The viewer without a scene: its first page, and what leads from one file and one view to the next. Exit status 77: there is no Xvfb or
xdotool.

usage: start_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from driver import Display, Viewer, skip_without

STERADIAN, SCENES, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
OPTIONS = "--size", "640x400", "--samples", "1", "--visibility", "none", "--exposure", "8", "--seed", "3", "--gl-debug"


def camera_of(viewer: Viewer) -> dict[str, list[float]]:
    """The numbers of the last camera that was shown."""
    text = re.findall(r"--camera '([^']*)'", viewer.errors())[-1]
    return {key: [float(n) for n in value.split(",")] for key, value in (part.split("=") for part in text.split(";"))}


def first_page(viewer: Viewer, folder: Path):
    """A path that leads nowhere leaves the page as it is. Tab completes a path; a folder is entered."""
    viewer.type("nowhere.glb")
    viewer.said("nowhere.glb: ")
    viewer.said("text field focused", 2)
    viewer.key("Escape")
    viewer.said("text field focused", 3)
    viewer.fields = 2
    viewer.type(str(folder.parent))
    viewer.said("text field focused", 4)  # of the folder
    assert viewer.title() == "Steradian", viewer.title()
    for begun, completed in ("fold", "folder/"), ("b", "folder/b.gltf"):
        viewer.display.do("type", "--delay", "20", begun)
        viewer.key("Tab")
        viewer.said(f"Completed: {folder.parent}/{completed}\n")
    viewer.key("Return")
    viewer.done()
    assert viewer.title().startswith("b.gltf"), viewer.title()


def neighbours(viewer: Viewer):
    """Ctrl PgDn and Ctrl PgUp go through the files of the folder, and around its end."""
    for key, name in ("Next", "c.gltf"), ("Next", "a.gltf"), ("Prior", "c.gltf"), ("Prior", "b.gltf"):
        viewer.changed_by(lambda: viewer.key("ctrl+" + key))
        viewer.wait(lambda: viewer.title().startswith(name), name)


def placing(viewer: Viewer):
    """Position, target and field of view are typed with units; what makes no sense changes nothing."""
    viewer.key("shift+c")
    viewer.changed_by(lambda: viewer.type("0.5, 120 cm, 4"))
    viewer.key("shift+c")
    viewer.type("1, 2")
    viewer.said("'1, 2' is no point")
    viewer.key("shift+c")
    viewer.wait(lambda: viewer.errors().count("text field focused") > viewer.fields, "the first field")
    viewer.fields += 1
    for _ in range(2):  # two in one frame would count as one
        count = viewer.errors().count("keyboard in another field")
        viewer.key("Tab")
        viewer.said("keyboard in another field", count + 1)
    viewer.display.do("type", "--delay", "20", "50 mm")
    viewer.changed_by(lambda: viewer.key("Return"))
    camera = camera_of(viewer)
    assert all(abs(a - b) < 1e-6 for a, b in zip(camera["eye"], (0.5, 1.2, 4))), camera
    assert abs(camera["yfov"][0] - 0.4710899) < 1e-6, camera  # 2 atan(12 mm / 50 mm)


def bookmarks(viewer: Viewer):
    """A view that was kept comes back after another one."""
    kept = camera_of(viewer)
    viewer.key("ctrl+b")
    viewer.said("Kept as view 1.")
    viewer.changed_by(lambda: viewer.key("Left"))
    assert camera_of(viewer) != kept
    viewer.changed_by(lambda: viewer.key("shift+b"))
    assert camera_of(viewer) == kept, (camera_of(viewer), kept)
    return kept


def history(viewer: Viewer):
    """Backspace goes back to the view before, Shift Backspace forward again; Undo is for edits."""
    first = camera_of(viewer)
    viewer.changed_by(lambda: viewer.key("Right"))
    second = camera_of(viewer)
    viewer.key("ctrl+z")
    viewer.said("Nothing to undo.")
    viewer.changed_by(lambda: viewer.key("BackSpace"))
    assert camera_of(viewer) == first, (camera_of(viewer), first)
    viewer.changed_by(lambda: viewer.key("shift+BackSpace"))
    assert camera_of(viewer) == second, (camera_of(viewer), second)
    viewer.key("shift+BackSpace")
    viewer.said("There is no later view.")


def turning(viewer: Viewer):
    """A turntable has the pictures of `render --turntable`, and leaves the view alone. Edits wait until it has ended or is cancelled."""
    viewer.changed_by(lambda: viewer.key("a"))
    camera, converged = camera_of(viewer), viewer.converged()
    viewer.key("ctrl+F12")
    viewer.said("Field of the turntable: pictures\n")
    viewer.key("Escape")
    viewer.pause()
    fields = {"pictures": "3", "to": None, "rate": None, "size": "96x64", "samples": "2", "error": ""}
    viewer.fill("ctrl+F12", "turntable", fields)
    viewer.said("-turntable: 3 pictures.")
    folder, = viewer.folder.glob("*-turntable")
    render_copied(viewer, SCRATCH / "turn.####.png", turntable="3", size="96x64", samples="2")
    for number in range(3):
        compared = subprocess.run([STERADIAN, "compare", folder / f"{number:04}.png", SCRATCH / f"turn.{number:04}.png", "--json"], capture_output=True)
        assert json.loads(compared.stdout)["metrics"]["mean_abs"] < 0.002, (number, compared.stdout)
    assert len(list(folder.iterdir())) == 3 and camera_of(viewer) == camera and viewer.converged() == converged
    viewer.fill("ctrl+F12", "turntable", {**fields, "pictures": "360", "size": "640x400", "samples": "64"})
    viewer.said("-turntable. Esc cancels.", 2)
    for key, name in ("ctrl+period", "Brighten the light"), ("v", "Next view"):
        viewer.key(key)
        viewer.said(f"{name} would change what is exported. Now: turntable: ")
    viewer.changed_by(lambda: viewer.key("Left"))  # the view is free
    viewer.key("Escape")
    viewer.said("Turntable cancelled after ")
    video = viewer.folder / "turn.mp4"
    if not shutil.which("ffmpeg"):
        return print("without ffmpeg: no video is tried (tools/setup)")
    viewer.fill("ctrl+F12", "turntable", {**fields, "to": video.name, "rate": "5"})
    viewer.said("Wrote turn.mp4: 3 pictures.")
    subprocess.run(["ffmpeg", "-v", "error", "-i", video, viewer.folder / "of_video.%d.png"], check=True)
    assert len(list(viewer.folder.glob("of_video.*.png"))) == 3
    viewer.fill("ctrl+F12", "turntable", {**fields, "to": video.name})
    viewer.said("Asked: turn.mp4 exists already. Replace it?")
    viewer.key("r")
    viewer.said("Wrote turn.mp4: 3 pictures.", 2)
    assert not list(viewer.folder.glob(".steradian*")), "a temporary file is left"


def render_copied(viewer: Viewer, output: Path, **changed: str) -> list[str]:
    """Runs the command that Ctrl C copies, with other values of some options, and returns its words."""
    count = viewer.errors().count("Copied: ")
    viewer.key("ctrl+c")
    viewer.said("Copied: ", count + 1)
    words = shlex.split(re.findall(r"Copied: (steradian render .*)", viewer.errors())[-1])
    words[words.index("-o") + 1] = str(output)
    for key, value in changed.items():
        if f"--{key}" in words:
            words[words.index(f"--{key}") + 1] = value
        else:
            words += [f"--{key}", value]
    subprocess.run([STERADIAN, *words[1:]], cwd=viewer.folder, check=True, capture_output=True)
    return words


def background(viewer: Viewer):
    """Alt B shows another background. The command that Ctrl C copies makes the picture that is seen."""
    viewer.changed_by(lambda: viewer.key("alt+b"))
    viewer.said("Background: grey, ")
    viewer.key("ctrl+c")
    viewer.wait(lambda: re.search(r"Copied: .*--background \d", viewer.errors()), "the background in the copied view")
    viewer.key("t", "comma")  # the next tone curve, a darker picture
    shot = viewer.shot(exr=False)
    words = render_copied(viewer, SCRATCH / "copied.png")
    assert {"--visibility", "--exposure", "--tone-curve", "--background", "--seed"} <= set(words), words
    compared = subprocess.run([STERADIAN, "compare", SCRATCH / "copied.png", shot, "--json"], capture_output=True)
    assert json.loads(compared.stdout)["metrics"]["max_abs"] == 0, compared.stdout
    viewer.changed_by(lambda: viewer.key("alt+b"))
    viewer.said("Background: white, ")
    viewer.wait(lambda: min(viewer.screen(*CORNER)) > 200, "a white background")
    viewer.changed_by(lambda: viewer.key("alt+b"))
    viewer.said("Background: black, ")
    viewer.wait(lambda: max(viewer.screen(*CORNER)) < 50, "a black background")


def copying(viewer: Viewer, clipboard: Path):
    """Ctrl Shift C gives the picture that is seen to a program of the system; one that fails is a line."""
    viewer.key("alt+F12")
    written = viewer.wait(lambda: re.findall(r"Wrote (\S+\.png)\.", viewer.errors()), "a picture")[-1]
    viewer.key("ctrl+shift+c")
    viewer.said("Copied the picture: ")
    assert (clipboard / "args").read_text().split() == ["-selection", "clipboard", "-target", "image/png", "-in"]
    assert (clipboard / "copied.png").read_bytes() == (viewer.folder / written).read_bytes()
    (clipboard / "xclip").write_text("#!/bin/sh\necho no display >&2\nexit 1\n")
    viewer.key("ctrl+shift+c")
    viewer.said("xclip: no display: ")
    viewer.key("Escape")


def grid(viewer: Viewer):
    """Shift G draws a grid and axes over the picture, and takes them away again."""
    viewer.move(5, 395)
    viewer.pause()
    axis = 86, 180, 233
    assert viewer.count(axis) < 20
    viewer.key("shift+g")
    viewer.said("Grid: lines each ")
    viewer.wait(lambda: viewer.count(axis) > 40, "an axis")
    viewer.key("shift+g")
    viewer.said("No grid.")
    viewer.wait(lambda: viewer.count(axis) < 20, "the picture alone")


def has_picture(viewer: Viewer) -> bool:
    """Whether the first recent file has a picture: the red wall of the Cornell box."""
    red, green, blue = viewer.screen(54, 245)
    return red > 60 and red > 2 * green and red > 2 * blue


ORANGE = 230, 159, 0
CORNER = 600, 50  # of the picture, beside the box


def broken(display: Display, folder: Path):
    """A file that cannot be rendered is marked. A cache that cannot be written is said; the page works without it."""
    recent = Path(display.environment["XDG_CONFIG_HOME"]) / "steradian/recent"
    (folder / "z.gltf").write_text('{"asset": {"version": "2.0"},')
    lines = recent.read_text().splitlines()
    recent.write_text("\n".join([lines[0], str(folder / "z.gltf"), *lines[1:]]) + "\n")
    cache = Path(display.environment["XDG_CACHE_HOME"]) / "steradian/thumbnails"
    shutil.rmtree(cache, ignore_errors=True)
    cache.parent.mkdir(parents=True, exist_ok=True)
    cache.write_text("no folder")
    viewer = Viewer(display, STERADIAN, SCRATCH / "run", *OPTIONS)
    viewer.said(f"{cache} cannot be written, so the first page has no new pictures.")
    assert viewer.errors().count("cannot be written") == 1, viewer.errors()
    viewer.close()
    cache.unlink()


def main() -> int:
    skip_without()
    shutil.rmtree(SCRATCH, ignore_errors=True)
    folder = SCRATCH / "some" / "folder"
    folder.mkdir(parents=True)
    for name in "abc":  # a scene of one file
        (folder / f"{name}.gltf").write_text((SCENES / "cornell.gltf").read_text())
    for buffer in SCENES.glob("cornell*.bin"):
        shutil.copy(buffer, folder)
    clipboard = SCRATCH / "clipboard"
    clipboard.mkdir()
    (clipboard / "xclip").write_text(f"#!/bin/sh\necho $* > {clipboard}/args\nexec cat > {clipboard}/copied.png\n")
    (clipboard / "xclip").chmod(0o755)
    with Display(SCRATCH / "display", 640, 400) as display:
        display.environment["PATH"] = f"{clipboard}:{display.environment['PATH']}"
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", *OPTIONS)
        first_page(viewer, folder)
        neighbours(viewer)
        placing(viewer)
        kept = bookmarks(viewer)
        history(viewer)
        grid(viewer)
        background(viewer)
        copying(viewer, clipboard)
        turning(viewer)
        viewer.close()
        broken(display, folder)
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", *OPTIONS)
        viewer.said("text field focused")
        viewer.wait(lambda: has_picture(viewer), "a thumbnail of the file")
        viewer.wait(lambda: viewer.count(ORANGE) > 5, "the reason why the broken file has no picture")
        pictures = {file.name: file.stat().st_mtime_ns for file in (SCRATCH / "display/cache/steradian/thumbnails").glob("*[0-9a-f].png")}
        assert pictures, "the thumbnail is not in the cache"
        viewer.click(44, 224)  # the first of the recent files
        viewer.done()
        assert viewer.title().startswith("b.gltf"), viewer.title()
        viewer.changed_by(lambda: viewer.key("shift+b"))
        assert camera_of(viewer) == kept, "the bookmark is lost"
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
