"""The fixture `golden` of pytest: a first picture fails, a person approves it, the same one passes, another one fails.

usage: plugin_test.py TEST_NAME     (a function below; PYTHONPATH names the folder of the package)
"""
import re
import shlex
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

import steradian

TESTS = textwrap.dedent("""
    import numpy as np
    import pytest
    import steradian

    def ramp():
        return np.linspace(0.5, FACTOR, 32 * 32 * 3, dtype=np.float32).reshape(32, 32, 3)

    def test_array(golden):
        golden(ramp(), limits="rel=0.001")

    @pytest.mark.parametrize("size", [16])
    def test_picture(golden, size):
        golden(steradian.load(steradian.sample("cornell")).render(size=(size, size), samples=2))

    def test_codes(golden):
        golden((ramp() * 100).astype(np.uint8), name="codes")
""")


def run_pytest(folder, *words):
    return subprocess.run([sys.executable, "-m", "pytest", "-p", "steradian.pytest_plugin", "-p", "no:cacheprovider", *words], cwd=folder,
                          capture_output=True, text=True)


def test_the_life_of_a_golden():
    with tempfile.TemporaryDirectory() as folder:
        tests = Path(folder, "test_ours.py")
        tests.write_text(TESTS.replace("FACTOR", "2"))
        first = run_pytest(folder)
        assert first.returncode == 1 and "3 failed" in first.stdout and first.stdout.count("there is no golden") >= 3, first.stdout
        assert "goldens" in first.stdout and Path(folder, "golden-results", "goldens", "report.html").is_file(), first.stdout
        words = shlex.split(re.search(r"steradian (golden approve .*)", first.stdout).group(1))
        approval = subprocess.run([steradian.program(), *words], cwd=folder, capture_output=True, text=True)
        assert approval.returncode == 0, approval.stderr
        assert {file.name for file in Path(folder, "goldens").iterdir()} >= {"test_array.exr", "test_picture-16.exr", "codes.png"}
        again = run_pytest(folder, "--golden-report")
        assert again.returncode == 0 and "3 passed" in again.stdout and "report of goldens" in again.stdout, again.stdout
        assert "approve" not in again.stdout
        tests.write_text(TESTS.replace("FACTOR", "2.5"))
        changed = run_pytest(folder)
        assert "2 failed, 1 passed" in changed.stdout and "rel ≤ 0.001" in changed.stdout, changed.stdout
        assert "test_array" in re.search(r"golden approve .*", changed.stdout).group(), changed.stdout


if __name__ == "__main__":
    globals()["test_" + sys.argv[1]]()
