#!/usr/bin/env python3
"""The installed package as another project uses it: examples/golden by CMake and by pytest.

usage: package_test.py CMAKE BUILD_FOLDER SOURCE_FOLDER SCRATCH_FOLDER
"""
import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path


def run(*words, **options):
    print("+", *words, flush=True)
    subprocess.run(list(map(str, words)), check=True, **options)


def main():
    cmake, build, source, scratch = sys.argv[1], *map(Path, sys.argv[2:5])
    shutil.rmtree(scratch, ignore_errors=True)
    prefix, ours = scratch / "prefix", scratch / "build"
    run(cmake, "--install", build, "--prefix", prefix)
    run(cmake, "-G", "Ninja", "-S", source / "examples/golden/cmake", "-B", ours, f"-DCMAKE_PREFIX_PATH={prefix}")
    run(Path(cmake).with_name("ctest"), "--test-dir", ours, "--output-on-failure", "--no-tests=error", "-L", "pictures")
    assert (ours / "golden/golden.example/report.html").is_file()
    if importlib.util.find_spec("pytest") is None:
        print("pytest is not installed: its example was not run")
        return
    environment = {**os.environ, "STERADIAN": str(prefix / "bin/steradian"), "PYTHONDONTWRITEBYTECODE": "1"}
    run(sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", source / "examples/golden/pytest", env=environment)


if __name__ == "__main__":
    main()
