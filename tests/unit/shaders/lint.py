#!/usr/bin/env python3
"""Lints every shader with glslangValidator: entry files as they are, the others each alone in an entry file of its
own, so that a file that forgets an include of its own is found.

usage: lint.py STERADIAN GLSLANG_VALIDATOR SHADERS_FOLDER
"""
import subprocess
import sys
import tempfile
from pathlib import Path

# Files that only a fragment shader can hold need nothing else; this is what goes around a file to make it an entry.
WRAPPER = '#version 410 core\n#include "{name}"\nvoid main() {{}}\n'


def expanded(steradian: str, name: str, folder: Path) -> str:
    """The shader as the driver would see it."""
    result = subprocess.run([steradian, "expand", name, "--shaders", str(folder)], capture_output=True, text=True)
    if result.returncode != 0:
        raise SystemExit(f"{name}: {result.stderr.strip()}")
    return result.stdout


def complaints(validator: str, source: str, suffix: str) -> str:
    """What the validator has against a source; empty if nothing."""
    with tempfile.NamedTemporaryFile("w", suffix=suffix) as file:
        file.write(source)
        file.flush()
        result = subprocess.run([validator, file.name], capture_output=True, text=True)
    return "" if result.returncode == 0 else result.stdout + result.stderr


def main() -> int:
    steradian, validator, root = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    if not complaints(validator, "#version 410 core\nvoid main() { undeclared = 1.0; }\n", ".frag"):
        print("the validator accepts a broken shader: it checks nothing")
        return 1
    failures = 0
    names = sorted(p.relative_to(root).as_posix() for p in root.rglob("*") if p.suffix in {".glsl", ".frag", ".vert"})
    for name in names:
        suffix = Path(name).suffix
        with tempfile.TemporaryDirectory() as scratch:
            entry = name
            if suffix == ".glsl":
                entry, suffix = "lint.frag", ".frag"
                Path(scratch, entry).write_text(WRAPPER.format(name=name))
            text = complaints(validator, expanded(steradian, entry, Path(scratch)), suffix)
        failures += bool(text)
        print(f"{'FAILED' if text else 'ok':7} {name}")
        if text:
            print(text)
    print(f"{len(names)} shaders, {failures} refused")
    return 1 if failures or not names else 0


if __name__ == "__main__":
    sys.exit(main())
