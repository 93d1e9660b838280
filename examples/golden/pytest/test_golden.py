"""Each golden of a suite as a pytest test.

The suite runs once, for all tests; `steradian` must be in PATH, or its path in $STERADIAN.
"""
import json
import os
import subprocess
from pathlib import Path

import pytest

SUITE = Path(__file__).resolve().parent.parent / "suite.json"
STERADIAN = os.environ.get("STERADIAN", "steradian")


def names():
    listing = subprocess.run([STERADIAN, "golden", "list", SUITE], capture_output=True, text=True, check=True)
    return [line.split("  ")[0] for line in listing.stdout.splitlines()]


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    out = Path(os.environ.get("GOLDEN_RESULTS", tmp_path_factory.mktemp("golden-results")))
    run = subprocess.run([STERADIAN, "golden", "run", SUITE, "--output", out], capture_output=True, text=True)
    assert run.returncode in (0, 1), run.stderr  # 1: some test failed, which is told below; else nothing was run
    tests = json.loads((out / "results.json").read_text(encoding="utf-8"))["tests"]
    return {test["name"]: test for test in tests}, out


@pytest.mark.parametrize("name", names())
def test_golden(results, name):
    tests, out = results
    assert tests[name]["outcome"] == "passed", f"{tests[name]['message']} (see {out / 'report.html'})"
