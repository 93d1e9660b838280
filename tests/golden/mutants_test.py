#!/usr/bin/env python3
"""Our suite under a renderer with a mistake (mutants/MISTAKE is a shader overlay): it must fail, and say why.

usage: mutants_test.py STERADIAN GOLDEN_FOLDER SCRATCH_FOLDER MISTAKE
"""
import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

# What must be found: how many tests fail at least, which diagnosis is given and how often at least. No mistake of a
# missing cosine can be named from an image alone; a light that is off is named where it was the only one.
EXPECTED = {
    "pi_missing": (20, "pi_missing", 6),
    "cosine_missing": (19, None, 0),
    "srgb_twice": (20, "srgb_applied", 10),
    "light_off": (20, "black", 4),
}


def main():
    program, folder, scratch, mistake = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]), sys.argv[4]
    out = scratch / mistake
    result = subprocess.run([program, "golden", "run", folder / "suite.json", "-o", out, "--jobs", "2",
                             "--shaders", folder / "mutants" / mistake], capture_output=True, text=True)
    print(result.stdout + result.stderr)
    assert result.returncode == 1, f"exit status {result.returncode}"
    tests = json.loads((out / "results.json").read_text())["tests"]
    outcomes = Counter(test["outcome"] for test in tests)
    assert outcomes["broken"] == 0 and outcomes["missing"] == 0, outcomes
    failing, name, count = EXPECTED[mistake]
    assert outcomes["differs"] >= failing, outcomes
    diagnoses = Counter((test["comparison"]["diagnosis"] or {"name": "none"})["name"] for test in tests)
    print(f"{mistake}: {outcomes['differs']} of {len(tests)} fail, diagnosed as {dict(diagnoses)}")
    assert name is None or diagnoses[name] >= count, diagnoses
    assert name == "pi_missing" or diagnoses["pi_missing"] == 0, "another mistake was taken for a missing π"


if __name__ == "__main__":
    main()
