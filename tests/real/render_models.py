#!/usr/bin/env python3
"""Renders every real model: each makes a picture. Exits with 77 (skipped) without the folder.

usage: render_models.py STERADIAN MODELS_FOLDER [--or-one-line]

With --or-one-line it looks into the folder's folders, too, and a model may also be refused in one line.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77


def complaint(steradian: str, model: Path, output: Path, may_be_refused: bool) -> str:
    """What is wrong with how the model fared; empty if nothing."""
    result = subprocess.run([steradian, "render", model, "-o", output, "--size", "96x54", "--samples", "2", "--gl-debug"],
                            capture_output=True, text=True, timeout=100, check=False)
    is_one_line = result.stderr.count("\n") == 1 and result.stderr.startswith(str(model.parent))
    if may_be_refused and result.returncode == 3 and is_one_line and not output.exists():
        return ""
    if result.returncode != 0 or not output.exists():
        return f"exit status {result.returncode}: {result.stderr}"
    return ""


def main() -> int:
    steradian, folder = sys.argv[1], Path(sys.argv[2])
    may_be_refused = sys.argv[3:] == ["--or-one-line"]
    models = sorted(p for p in folder.glob("**/*" if may_be_refused else "*") if p.suffix in {".gltf", ".glb"})
    if not models:
        print(f"no models in {folder}: {'install assimp-testmodels' if may_be_refused else 'set STERADIAN_MODELS'}")
        return SKIPPED
    failures = 0
    with tempfile.TemporaryDirectory() as scratch:
        for number, model in enumerate(models):
            text = complaint(steradian, model, Path(scratch, f"{number}.png"), may_be_refused)
            failures += bool(text)
            print(f"{'FAILED' if text else 'ok':7} {model.name} {text}")
    print(f"{len(models)} models, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
