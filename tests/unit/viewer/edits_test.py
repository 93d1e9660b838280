#!/usr/bin/env python3
"""Unsaved edits in the viewer: the title, questions before they are lost, files that are not overwritten, the journal. Exit status 77:
there is no Xvfb, xdotool or python-xlib.

usage: edits_test.py STERADIAN SCENES_FOLDER SCRATCH_FOLDER
"""
import json
import shutil
import signal
import sys
from pathlib import Path

from driver import PATIENCE, Display, Viewer, skip_without

STERADIAN, SCENES, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:])
OPTIONS = "--size", "400x300", "--samples", "1", "--visibility", "none", "--exposure", "8"


def is_unsaved(viewer: Viewer, expected: bool):
    viewer.wait(lambda: viewer.title().startswith("*") == expected, f"a title {'with' if expected else 'without'} a star")


def journals(display: Display) -> list[Path]:
    return list((display.file.parent / "state" / "steradian").glob("*.json"))


def with_materials_reversed(scene: Path) -> str:
    """The same scene by another exporter: its materials have other numbers."""
    root = json.loads(scene.read_text())
    last = len(root["materials"]) - 1
    root["materials"].reverse()
    for mesh in root["meshes"]:
        for primitive in mesh["primitives"]:
            primitive["material"] = last - primitive["material"]
    return json.dumps(root)


def edited_lights(file: Path) -> list[str]:
    """Names of the materials that state what they emit, as edits do."""
    return [material["name"] for material in json.loads(file.read_text())["materials"]
            if "quantity" in material.get("extras", {}).get("steradian", {})]


def close(display: Display, viewer: Viewer):
    """Asks the window to close, as a window manager does."""
    from Xlib import display as xlib
    from Xlib.protocol.event import ClientMessage
    connection = xlib.Display(display.environment["DISPLAY"])
    window = connection.create_resource_object("window", int(viewer.window))
    protocols, delete = (connection.intern_atom(name) for name in ("WM_PROTOCOLS", "WM_DELETE_WINDOW"))
    window.send_event(ClientMessage(window=window, client_type=protocols, data=(32, [delete, 0, 0, 0, 0])))
    connection.sync()
    connection.close()


def asking(display: Display, viewer: Viewer, other: Path):
    """Quitting, closing the window, reloading and opening ask while edits are unsaved; Esc keeps all as it is."""
    is_unsaved(viewer, False)
    viewer.key("Tab", "space")
    is_unsaved(viewer, True)
    viewer.key("ctrl+q")
    viewer.said("unsaved edits. Quit?")
    viewer.key("t", "space", "Escape")  # only the answer counts
    viewer.process.send_signal(signal.SIGSTOP)  # a slow frame: D is typed before the question is seen
    viewer.key("F5", "d")
    viewer.process.send_signal(signal.SIGCONT)
    viewer.said("unsaved edits. Reload it?")
    is_unsaved(viewer, True)
    viewer.key("Escape")
    close(display, viewer)
    viewer.said("unsaved edits. Quit?", 2)
    viewer.key("Escape", "ctrl+o")
    viewer.type(f"{other}x")
    viewer.said("veach.gltfx: ")  # which is not there: nothing is asked
    assert "Open veach.gltfx?" not in viewer.errors()
    viewer.type(str(other))
    viewer.said("unsaved edits. Open veach.gltf?")
    viewer.key("Escape", "Escape")
    is_unsaved(viewer, True)
    assert "scene.gltf" in viewer.title() and "tone" not in viewer.errors(), viewer.errors()


def dragging(display: Display, viewer: Viewer):
    """A drag whose button is released under a question has ended: the pointer moves nothing afterwards."""
    asked, copied = (viewer.errors().count(text) for text in ("unsaved edits. Quit?", "Copied: "))
    display.do("mousemove", 200, 150, "mousedown", 1, "mousemove", 210, 150, "mousemove", 220, 160)
    close(display, viewer)
    viewer.said("unsaved edits. Quit?", asked + 1)
    display.do("mouseup", 1)
    viewer.key("Escape", "ctrl+c")
    viewer.said("Copied: ", copied + 1)
    viewer.move(300, 200)
    viewer.key("ctrl+c")
    viewer.said("Copied: ", copied + 2)
    first, second = viewer.errors().split("Copied: ")[-2:]
    assert first.splitlines()[0] == second.splitlines()[0], (first, second)
    viewer.key("0")


def hiding(display: Display, viewer: Viewer):
    """A window that is not seen shows itself to ask."""
    asked = viewer.errors().count("unsaved edits. Quit?")
    display.do("windowunmap", "--sync", viewer.window)
    close(display, viewer)
    viewer.said("unsaved edits. Quit?", asked + 1)
    viewer.wait(lambda: display.do("search", "--onlyvisible", "--name", "Steradian"), "a window that is seen again")
    display.do("windowfocus", "--sync", viewer.window)
    viewer.key("Escape")


def saving(viewer: Viewer, scene: Path):
    """Neither the open file nor another one is overwritten without a question; undo goes on after saving."""
    other, edited = scene.with_name("other.gltf"), scene.with_name("scene_edited.gltf")
    before = scene.read_bytes()
    other.write_text("{}")
    viewer.key("ctrl+s", "ctrl+a")
    viewer.type(str(scene))
    viewer.said("is the open file")
    viewer.type("")  # the field has the keyboard again, with the path
    viewer.said("is the open file", 2)
    viewer.wait(lambda: viewer.errors().count("text field focused") > viewer.fields, "the field again")
    viewer.fields += 1
    viewer.key("Escape", "ctrl+s", "ctrl+a")
    viewer.type(str(other))
    viewer.said("exists already. Replace it?")
    viewer.key("Escape")
    assert scene.read_bytes() == before and other.read_text() == "{}", "overwritten without an answer"
    is_unsaved(viewer, True)
    viewer.key("ctrl+s")
    viewer.type("")  # the name that is proposed
    viewer.wait(edited.exists, "a saved file")
    is_unsaved(viewer, False)
    viewer.key("ctrl+z")
    viewer.said("Undone: disabling ")
    viewer.key("ctrl+shift+z")
    viewer.said("Redone: disabling ")
    is_unsaved(viewer, False)
    asked = viewer.errors().count("exists already. Replace it?")
    viewer.write(edited, "{}")  # another program changes what was saved
    viewer.key("ctrl+s")
    viewer.type("")
    viewer.said("scene_edited.gltf exists already. Replace it?", 1)
    viewer.key("r")
    viewer.said(f"Saved {edited}.", 2)
    viewer.key("ctrl+s")
    viewer.type("")
    viewer.said(f"Saved {edited}.", 3)
    assert viewer.errors().count("exists already. Replace it?") == asked + 1, "asked about its own file"
    asked = viewer.errors().count("unsaved edits. Reload it?")
    viewer.key("ctrl+period")  # brightens the light
    is_unsaved(viewer, True)
    viewer.write(scene, with_materials_reversed(scene))  # another program changes what the edits start from
    viewer.said("unsaved edits. Reload it?", asked + 1)
    viewer.key("Escape", "ctrl+s")
    viewer.type("")
    viewer.said(f"Saved {edited}. scene.gltf has changed or gone since it was opened")
    brightened = edited.read_bytes()
    assert edited_lights(scene) == [] and edited_lights(edited) == ["lamp"], edited_lights(edited)
    viewer.key("ctrl+period")
    is_unsaved(viewer, True)
    scene.unlink()
    viewer.said("unsaved edits. Reload it?", asked + 2)
    viewer.key("Escape", "ctrl+z", "ctrl+s")
    viewer.type("")
    viewer.said(f"Saved {edited}. scene.gltf has changed or gone since it was opened", 2)
    assert edited.read_bytes() == brightened, "a removed file gives another copy"


def typing_ahead(viewer: Viewer, target: Path):
    """What is typed at once after a key that opens a field goes into the field, in its order, however late the field appears."""
    viewer.process.send_signal(signal.SIGSTOP)  # a slow frame
    viewer.display.do("key", "--delay", "1", "ctrl+s", "ctrl+a", "type", "--delay", "1", "--args", "1", str(target), "key", "Return")
    viewer.process.send_signal(signal.SIGCONT)
    viewer.said(f"Saved {target}.")
    viewer.pause()
    by_name, in_field = target.with_name("by_name.gltf"), target.with_name("in_field.gltf")
    viewer.process.send_signal(signal.SIGSTOP)  # the palette's command opens the field
    viewer.display.do("key", "--delay", "1", "ctrl+p", "type", "--delay", "1", "--args", "1", "save as", "key", "Return",
                      "key", "--delay", "1", "ctrl+a", "type", "--delay", "1", "--args", "1", str(by_name), "key", "Return")
    viewer.process.send_signal(signal.SIGCONT)
    viewer.said(f"Saved {by_name}.")
    viewer.pause()
    viewer.key("ctrl+s")
    viewer.wait(lambda: viewer.errors().rstrip().endswith("text field focused"), "the field", interval=0.001)  # in the frame after it
    viewer.process.send_signal(signal.SIGSTOP)  # Ctrl A and what replaces the name come in one frame
    viewer.display.do("key", "--delay", "1", "ctrl+a", "type", "--delay", "1", "--args", "1", str(in_field), "key", "Return")
    viewer.process.send_signal(signal.SIGCONT)
    viewer.said(f"Saved {in_field}.")


def opening(viewer: Viewer, other: Path):
    """A path that cannot be opened stays in the field, which keeps the keyboard."""
    viewer.key("ctrl+o")
    viewer.type(f"{other}x")
    viewer.said("veach.gltfx")
    viewer.type("")  # tries the same path again
    viewer.said("veach.gltfx", 2)
    viewer.type(str(other))  # in the place of the path, which is selected
    viewer.wait(lambda: "veach.gltf" in viewer.title(), "the file that was meant")


def crashing(viewer: Viewer, display: Display, scene: Path):
    """Edits of a run that was killed are offered at the next start, by name if the file has changed; a clean end leaves no journal."""
    viewer.key("Tab", "space")
    is_unsaved(viewer, True)
    viewer.wait(lambda: journals(display), "a journal")
    viewer.process.kill()
    viewer.process.wait()
    journal = journals(display)[0]
    damaged = journal.with_name(journal.name.rpartition("-")[0] + "-9.json")
    damaged.write_text('{"edits": ')
    viewer.write(scene, with_materials_reversed(scene))
    viewer = Viewer(display, STERADIAN, SCRATCH / "again", scene, *OPTIONS)
    viewer.said(f"{damaged}.damaged: is a damaged journal of unsaved edits")
    viewer.said("Asked: An earlier run ended without saving 1 edited light or material of veach.gltf. The file has changed since")
    viewer.key("r")
    viewer.said("The edits are recovered.")
    is_unsaved(viewer, True)
    copy = scene.with_name("veach_edited.gltf")
    viewer.key("ctrl+q")
    viewer.said("Quit?")
    viewer.key("s")
    viewer.process.communicate(timeout=PATIENCE)
    assert viewer.process.returncode == 0, viewer.errors()
    stated = [node for node in json.loads(copy.read_text())["nodes"] if "extras" in node]
    assert [node["extras"]["steradian"]["quantity"]["value"] for node in stated] == [0], f"not switched off: {stated}"
    assert not journals(display), journals(display)


def main() -> int:
    skip_without(modules=("Xlib",))
    shutil.rmtree(SCRATCH, ignore_errors=True)
    with Display(SCRATCH / "display", 800, 600) as display:
        scene, other = SCRATCH / "scene.gltf", SCRATCH / "veach.gltf"
        shutil.copy(SCENES / "cornell.gltf", scene)
        shutil.copy(SCENES / "veach.gltf", other)
        viewer = Viewer(display, STERADIAN, SCRATCH / "run", scene, *OPTIONS)
        viewer.done()
        asking(display, viewer, other)
        dragging(display, viewer)
        hiding(display, viewer)
        saving(viewer, scene)
        opening(viewer, other)
        typing_ahead(viewer, scene.with_name("at_once.gltf"))
        crashing(viewer, display, other)
    return 0


if __name__ == "__main__":
    sys.exit(main())
