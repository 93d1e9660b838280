#!/usr/bin/env python3
"""Measures the viewer as a person meets it, on a display of its own (Xvfb, xdotool): what start takes until the first
picture, by part; frames while a drag orbits; memory over many reloads; frames and memory while an animation plays.

usage: viewer.py STERADIAN SCENE [--size WxH] [--reloads N | --play SECONDS] [-- OPTION...]

What follows -- goes to `steradian view`.
"""
import argparse
import json
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests/unit/viewer"))
from driver import Display, Viewer  # noqa: E402


def resident(viewer: Viewer) -> float:
    """Memory in use [MB]."""
    status = Path(f"/proc/{viewer.process.pid}/status").read_text()
    return int(next(line for line in status.splitlines() if line.startswith("VmRSS")).split()[1]) / 1024


def orbit(viewer: Viewer, width: int, height: int, seconds: float = 5.0):
    """A drag that goes on, 60 moves a second."""
    moves = []
    for i in range(int(60 * seconds)):
        moves += ["mousemove", width // 2 + i % (width // 3), height // 2 + i % 40, "sleep", "0.0167"]
    viewer.display.do("mousemove", width // 2, height // 2, "mousedown", 1, *moves, "mouseup", 1)


def reload(viewer: Viewer, count: int):
    """Reads the scene anew, again and again, and says what memory does."""
    for i in range(count + 1):
        if i in (20, count // 2, count):
            print(f"after {i:4} reloads: {resident(viewer):.0f} MB")
        if i < count:
            viewer.key("F5")
            viewer.wait(lambda: viewer.errors().count("reloaded.") > i, "a reload")


def play(viewer: Viewer, seconds: float):
    """Plays the animation, and says what memory does."""
    viewer.key("k")
    begin = time.monotonic()
    for part in (0.1, 0.5, 1.0):
        time.sleep(max(0.0, begin + seconds * part - time.monotonic()))
        print(f"after {seconds * part:4.0f} s: {resident(viewer):.0f} MB")
    viewer.key("k")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("steradian", type=Path)
    parser.add_argument("scene", type=Path)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--reloads", type=int, default=0)
    parser.add_argument("--play", type=float, default=0.0)
    parser.add_argument("more", nargs="*")
    options = parser.parse_args()
    width, height = map(int, options.size.split("x"))
    with tempfile.TemporaryDirectory() as folder:
        display = Display(Path(folder) / "display", width, height)
        try:
            viewer = Viewer(display, options.steradian.resolve(), Path(folder) / "run", options.scene.resolve(), "--size",
                            options.size, "--samples", "1", "--json", *options.more)
            viewer.done()
            viewer.key("h")
            if options.reloads:
                reload(viewer, options.reloads)
            elif options.play:
                play(viewer, options.play)
            else:
                orbit(viewer, width, height)
                time.sleep(1.0)
            print(json.dumps(json.loads(viewer.close()), indent=2))
        finally:
            display.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
