#!/usr/bin/env python3
"""examples/golden for another renderer from PyPI, as its README says: its goldens pass, and a change of its picture fails.

usage: adopted_test.py STERADIAN SOURCE_FOLDER SCRATCH_FOLDER RENDERER
Installs the renderer into a virtual environment in SCRATCH_FOLDER, which stays for the next time; exit status 77
(skipped) where it cannot be had.
"""
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
# A change of the renderer's script, and the tests that must fail by it.
CHANGES = {
    "matplotlib": ("plot.py", "(1, 10, 100)", "(1, 11, 100)", {"polar"}),
    "mitsuba": ("render.py", "image = mi.render", "scene['light']['emitter']['radiance']['value'] = [19.0, 14.0, 7.0]\nimage = mi.render",
                {"box"}),
}


def environment_with(requirements, folder):
    """The environment in which the renderer can be imported."""
    python = folder / "bin" / "python3"
    words = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", requirements]
    try:
        if not python.exists():
            subprocess.run([sys.executable, "-m", "venv", folder], check=True, timeout=120)
        subprocess.run(words, check=True, timeout=240)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
        print(f"SKIPPED: {requirements} cannot be installed: {error}")
        sys.exit(SKIPPED)
    return {**os.environ, "PATH": f"{python.parent}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1"}


def main():
    program, source, scratch, renderer = Path(sys.argv[1]).resolve(), Path(sys.argv[2]), Path(sys.argv[3]), sys.argv[4]
    scratch.mkdir(parents=True, exist_ok=True)
    example = source / "examples" / "golden" / renderer
    environment = environment_with(example / "requirements.txt", scratch / f"{renderer}-venv")
    project = scratch / renderer
    shutil.rmtree(project, ignore_errors=True)
    shutil.copytree(example, project)

    def golden(*words):
        run = subprocess.run([program, "golden", *words], cwd=project, env=environment, capture_output=True, text=True)
        print(run.stdout + run.stderr)
        return run.returncode

    assert golden("run", "suite.json") == 0, "the goldens do not pass"
    script, right, wrong, failing = CHANGES[renderer]
    text = (project / script).read_text(encoding="utf-8")
    assert text.count(right) == 1, f"{script} has no {right} any more: mend this test"
    (project / script).write_text(text.replace(right, wrong), encoding="utf-8")
    assert golden("run", "suite.json") == 1, "a change of the picture passes"
    tests = json.loads((project / "golden-results/results.json").read_text(encoding="utf-8"))["tests"]
    assert {test["name"] for test in tests if test["outcome"] == "differs"} == failing, tests
    assert golden("approve", "suite.json") == 0 and golden("run", "suite.json") == 0, "the change cannot be approved"


if __name__ == "__main__":
    main()
