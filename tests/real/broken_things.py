#!/usr/bin/env python3
"""Renders files of which one thing is broken, and files that ask for what few readers know: each makes a picture, with
the one warning that it deserves, which --strict makes an error. Exits with 77 (skipped) without the folder.

usage: broken_things.py STERADIAN CASES_FOLDER
"""
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77

# The file, further arguments, and what the warning says; an empty one where there is none.
CASES = [
    ("spot_inner_equals_outer/scene.gltf", [], "its edge is hard"),
    ("lamp_in_vanishing_node_spot/scene.gltf", ["--at", "1"], "/nodes/2 is scaled to 0: its lamp is off"),
    ("lamp_in_vanishing_node_spot/scene.gltf", [], ""),
    ("anim_target_without_node/scene.gltf", ["--at", "0.5"], "/animations/0/channels/0/target names no node"),
    ("uri_inner_dotdot/scene.gltf", [], ""),
    ("data_upper_scheme/scene.gltf", [], ""),
    ("khr_meshopt/meshopt-no-fallback.gltf", [], ""),
    ("spec_gloss/Material_SpecularGlossiness_06.gltf", [], ""),
]


def complaint(steradian: str, file: Path, arguments: list, warning: str, output: Path) -> str:
    """What is wrong with how the file fared; empty if nothing."""
    def render(*more):
        output.unlink(missing_ok=True)
        return subprocess.run([steradian, "render", file, "-o", output, "--size", "48x48", "--samples", "2", "--gl-debug",
                               *arguments, *more], capture_output=True, text=True, timeout=100)

    result = render()
    told = [line for line in result.stderr.splitlines() if "no lamp in this file" not in line]
    if result.returncode != 0 or not output.exists():
        return f"exit status {result.returncode}: {result.stderr}"
    if len(told) != (1 if warning else 0) or warning not in result.stderr:
        return f"warns of {told}"
    strict = render("--strict")
    if strict.returncode != (3 if warning else 0) or output.exists() == bool(warning):
        return f"--strict: exit status {strict.returncode}: {strict.stderr}"
    return ""


def main() -> int:
    steradian, folder = sys.argv[1], Path(sys.argv[2])
    if not folder.is_dir():
        print(f"no folder {folder}: skipped")
        return SKIPPED
    failures = 0
    with tempfile.TemporaryDirectory() as scratch:
        for name, arguments, warning in CASES:
            what = complaint(steradian, folder / name, arguments, warning, Path(scratch) / "a.png")
            failures += bool(what)
            print(f"{name} {' '.join(arguments)}: {what or 'right'}")
    print(f"{len(CASES) - failures} passed, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
