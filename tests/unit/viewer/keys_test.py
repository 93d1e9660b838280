#!/usr/bin/env python3
"""Keys of the viewer that a file changes, under other keyboard layouts, and keys that must do nothing. Exit status 77: there is no Xvfb, xdotool or
setxkbmap.

usage: keys_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from driver import Display, Viewer, skip_without

STERADIAN, SCENES, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
OPTIONS = "--size", "400x300", "--samples", "1", "--visibility", "none", "--exposure", "8"


def layout(display: Display, name: str):
    """Sets the layout. xdotool then presses the key that has the label."""
    subprocess.run(["setxkbmap", "-display", display.environment["DISPLAY"], name], check=True)


def camera_of(viewer: Viewer) -> str:
    return re.findall(r"--camera '([^']*)'", viewer.errors())[-1]


def azerty(viewer: Viewer):
    """A is where Q is on a US keyboard. Ctrl A does not quit, A frames all; Z flies, because it is where W is."""
    viewer.key("h", "ctrl+a", "t")  # T copies the view, as the file of keys says
    viewer.said("Copied: steradian render ")
    viewer.changed_by(lambda: viewer.key("a"))
    assert viewer.process.poll() is None and "eye=" in camera_of(viewer), camera_of(viewer)
    framed = camera_of(viewer)
    viewer.move(200, 150)
    viewer.display.do("mousedown", "3", "keydown", "z")
    viewer.changed_by(lambda: viewer.display.do("sleep", "0.2", "keyup", "z", "mouseup", "3"))
    assert camera_of(viewer) != framed, "Z does not fly"
    viewer.changed_by(lambda: viewer.key("a"))


def history(viewer: Viewer):
    """M lists the messages while the panels are hidden, too. On AZERTY it is beside L."""
    viewer.pause()
    before = viewer.screen(200, 150)
    viewer.key("m")
    viewer.wait(lambda: viewer.screen(200, 150) != before, "a list of messages over the picture")
    viewer.key("m")
    viewer.wait(lambda: viewer.screen(200, 150) == before, "the picture again")


def qwertz(viewer: Viewer):
    """Ctrl Z undoes and Ctrl Y redoes, which are in each other's places."""
    viewer.key("Tab", "space", "ctrl+z")
    viewer.said("Undone: ")
    viewer.key("ctrl+y")
    viewer.said("Redone: ")
    viewer.key("ctrl+z")
    viewer.said("Undone: ", 2)


def soon(viewer: Viewer, *keys: str) -> bool:
    """Presses keys; whether the last one came soon after the first one."""
    begin = time.monotonic()
    viewer.key(*keys)
    return time.monotonic() - begin < 1.5


def cancelling(viewer: Viewer):
    """An Esc cancels one thing, the innermost first. Keys that follow a refused command soon do nothing."""
    for _ in range(5):
        if cancels(viewer):
            return
    raise AssertionError("the keys never came soon after each other")


def cancels(viewer: Viewer) -> bool:
    """False if the keys did not come soon, as on a machine under load."""
    def count(text: str) -> int:
        return viewer.errors().count(text)
    viewer.key("Escape", "Escape", "Escape", "Escape")
    viewer.changed_by(lambda: viewer.key("0"))
    viewer.wait(lambda: "eye=" not in camera_of(viewer), "the camera of the file")  # an earlier picture may converge first
    compared = count("Reference kept.") + count("Comparison: wipe.")
    viewer.key("Tab", "b")
    viewer.wait(lambda: count("Reference kept.") + count("Comparison: wipe.") > compared, "a comparison")
    camera, before, undone = camera_of(viewer), viewer.errors(), count("Undone: ")
    if not soon(viewer, "g", "x", "1", "Return"):
        return False
    viewer.said("Emissive surfaces cannot be moved.")
    wiped = count("Comparison: wipe.")
    viewer.key("F1", "Escape", "Escape", "b")  # help, comparison; a light is selected still
    viewer.said("Comparison: wipe.", wiped + 1)
    viewer.changed_by(lambda: viewer.key("space"))
    assert viewer.title().startswith("*") and camera_of(viewer) == camera, "another view, or the light is not selected"
    viewer.key("ctrl+z")
    viewer.said("Undone: ", undone + 1)
    after = viewer.errors()[len(before):]
    assert "text field" not in after, after
    return True


def finding(viewer: Viewer):
    """Ctrl P finds a command by a part of its name; arrows choose, Enter runs it, Esc leaves all as it is."""
    focused, framed = viewer.errors().count("text field focused"), viewer.errors().count("Reference kept.")

    def look_for(text: str, *keys: str):
        nonlocal focused
        viewer.key("ctrl+p")
        focused += 1
        viewer.said("text field focused", focused)
        viewer.display.do("type", "--delay", "30", text)
        viewer.key(*keys)

    viewer.key("Escape", "Escape")
    look_for("cop", "Return")
    viewer.said("Copied: steradian render ", 2)
    viewer.changed_by(lambda: look_for("view from", "Down", "Down", "Return"))  # front, back, right
    eye, target = ([float(x) for x in re.search(rf"{name}=([^;']*)", camera_of(viewer))[1].split(",")] for name in ("eye", "target"))
    assert eye[0] > target[0] and abs(eye[2] - target[2]) < 1e-3, camera_of(viewer)
    look_for("b", "Escape")
    viewer.changed_by(lambda: viewer.key("0"))
    assert viewer.errors().count("Reference kept.") == framed, "a letter that was typed is a command"


def followed(viewer: Viewer, keys: Path):
    """The keys follow the file. One that is broken leaves those of before; without a file the built-in keys work."""
    viewer.write(keys, '{"Copy the view": "F8"}')
    viewer.said(f"The keys are those of {keys} now.")
    viewer.key("F8")
    viewer.said("Copied: steradian render ", 2)
    viewer.pause()
    without_error = viewer.screen(200, 30)
    viewer.write(keys, '{"Copy the vew": "F9"}')
    viewer.said(f'{keys}:1:2: there is no command "Copy the vew"')
    viewer.wait(lambda: viewer.screen(200, 30) != without_error, "the error over the picture")
    viewer.key("F9", "F8")
    viewer.said("Copied: steradian render ", 3)
    viewer.write(keys, '{"Copy the view": "F9"}')
    viewer.wait(lambda: viewer.screen(200, 30) == without_error, "the picture without the error")
    viewer.key("F8", "F9")
    viewer.said("Copied: steradian render ", 4)
    keys.unlink()
    viewer.said("Your file of keys is gone: the built-in keys are in use.")
    viewer.key("F9", "ctrl+c")
    viewer.said("Copied: steradian render ", 5)
    keys.mkdir()
    viewer.said(f"{keys}: this is a folder")
    keys.rmdir()
    viewer.said("Your file of keys is gone: the built-in keys are in use.", 2)
    keys.symlink_to(keys)
    viewer.said(f"{keys}: the file cannot be opened (Too many levels of symbolic links)")
    keys.unlink()
    viewer.said("Your file of keys is gone: the built-in keys are in use.", 3)


def remapped(display: Display):
    """A file gives commands other keys. One that is wrong is refused with its place; the built-in keys work then."""
    folder = Path(display.environment["XDG_CONFIG_HOME"]) / "steradian"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "keys.json").write_text('{"Next tone curve": "F8",\n "Copy the view": "T",\n "Pixels": "ctrl+q"}')
    broken = f'{folder}/keys.json:3:12: Ctrl Q is the key of "Quit", too: give one of the two another key, or none: []'
    printed = subprocess.run([STERADIAN, "view", "--print-keys"], env=display.environment, capture_output=True, text=True)
    assert (printed.returncode, printed.stderr.strip()) == (3, broken), (printed.returncode, printed.stderr)
    viewer = Viewer(display, STERADIAN, SCRATCH / "broken", SCENES / "cornell.gltf", *OPTIONS)
    viewer.done()
    viewer.said(broken)
    viewer.pause()
    with_error = viewer.screen(200, 30)  # which stays until Esc
    viewer.key("Escape")
    viewer.wait(lambda: viewer.screen(200, 30) != with_error, "the picture without the error")
    viewer.key("ctrl+c")
    viewer.said("Copied: steradian render ")
    followed(viewer, folder / "keys.json")
    viewer.close()
    (folder / "keys.json").write_text('{"Next tone curve": "F8",\n "Copy the view": "T"}')
    printed = json.loads(subprocess.run([STERADIAN, "view", "--print-keys"], env=display.environment, capture_output=True).stdout)
    assert printed["Copy the view"] == "T" and printed["Quit"] == "Ctrl Q", printed


def main() -> int:
    skip_without("setxkbmap")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    with Display(SCRATCH / "display", 800, 600) as display:
        remapped(display)
        layout(display, "fr")
        viewer = Viewer(display, STERADIAN, SCRATCH / "fr", SCENES / "cornell.gltf", *OPTIONS)
        viewer.done()
        azerty(viewer)
        history(viewer)
        layout(display, "de")
        qwertz(viewer)
        cancelling(viewer)
        finding(viewer)
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
