#!/usr/bin/env python3
"""Renders every real model: each makes a picture. Exits with 77 (skipped) without the folder.

usage: render_models.py STERADIAN MODELS_FOLDER
"""
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77


def complaint(steradian: str, model: Path, output: Path) -> str:
    """What is wrong with how the model fared; empty if nothing."""
    result = subprocess.run([steradian, "render", model, "-o", output, "--size", "96x54", "--samples", "2", "--gl-debug"],
                            capture_output=True, text=True, timeout=100)
    if result.returncode != 0 or not output.exists():
        return f"exit status {result.returncode}: {result.stderr}"
    return ""


def main() -> int:
    steradian, folder = sys.argv[1], Path(sys.argv[2])
    models = sorted(p for p in folder.glob("*") if p.suffix in {".gltf", ".glb"})
    if not models:
        print(f"no models in {folder}: set STERADIAN_MODELS")
        return SKIPPED
    failures = 0
    with tempfile.TemporaryDirectory() as scratch:
        for model in models:
            text = complaint(steradian, model, Path(scratch, model.stem + ".png"))
            failures += bool(text)
            print(f"{'FAILED' if text else 'ok':7} {model.name} {text}")
    print(f"{len(models)} models, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
