#!/usr/bin/env python3
"""The installed package as another project uses it: examples/golden by CMake and by pytest.

usage: package_test.py CMAKE BUILD_FOLDER SOURCE_FOLDER SCRATCH_FOLDER
"""
import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path


def run(*words, **options):
    print("+", *words, flush=True)
    subprocess.run(list(map(str, words)), check=True, **options)


def check_install(cmake, prefix, project):
    """The installed program knows its name, and a project without a language finds the package."""
    version = subprocess.run([prefix / "bin/steradian", "--version"], check=True, capture_output=True, text=True).stdout
    assert re.fullmatch(r"Steradian \d+\.\d+\.\d+( \(commit [0-9a-f]+\))?\n", version), version
    for file in ("share/doc/steradian/copyright", "share/steradian/extras.schema.json", "share/steradian/scenes/default.gltf",
                 "share/doc/steradian/manual.html", "share/bash-completion/completions/steradian", "share/zsh/site-functions/_steradian",
                 "share/fish/vendor_completions.d/steradian.fish", "share/applications/steradian.desktop",
                 "share/icons/hicolor/scalable/apps/steradian.svg", "share/mime/packages/steradian.xml"):
        assert (prefix / file).is_file(), file
    pages = {page.name.removesuffix(".gz") for page in (prefix / "share/man/man1").iterdir()}
    assert {"steradian.1", "steradian-render.1", "steradian-golden-run.1"} <= pages, pages
    sample = subprocess.run([prefix / "bin/steradian", "samples", "emitters"], check=True, capture_output=True, text=True).stdout.strip()
    assert Path(sample) == (prefix / "share/steradian/scenes/emitters.gltf").resolve(), sample
    assert Path(sample).with_name("downlight.ies").is_file(), "emitters.gltf names downlight.ies"
    listed = subprocess.run([prefix / "bin/steradian", "assignment", "list"], check=True, capture_output=True, text=True).stdout
    assert "a3-brdf" in listed, listed
    project.mkdir(parents=True)
    (project / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(x NONE)\nfind_package(Steradian REQUIRED)\n")
    run(cmake, "-G", "Ninja", "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={prefix}")


def check_paths(prefix, *folders):
    """No installed file names a folder of the machine that built it. Debug information does, and is left out."""
    for file in sorted(path for path in prefix.rglob("*") if path.is_file()):
        content = file.read_bytes()
        if b".debug_info" in content:
            print(f"{file}: has debug information: its paths are not looked at")
            continue
        for folder in folders:
            assert str(folder).encode() not in content, f"{file} names {folder}"


def main():
    cmake, build, source, scratch = sys.argv[1], *map(Path, sys.argv[2:5])
    shutil.rmtree(scratch, ignore_errors=True)
    prefix, ours = scratch / "prefix", scratch / "build"
    run(cmake, "--install", build, "--prefix", prefix)
    check_install(cmake, prefix, scratch / "no_language")
    check_paths(prefix, source, build)
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
