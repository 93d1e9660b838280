"""The fixture `golden` of pytest: pictures are compared with approved ones, as `steradian golden` does.

    def test_lamp(golden):
        golden(steradian.load("lamp.glb").render(size=(64, 64)), limits=["rel=0.02@99.5%"])

A picture is a `Result`, a file or an array. Its golden is goldens/NAME.exr (or .png for sRGB codes) beside the test's file; the ini
option `golden_dir` names another folder. NAME is that of the test unless it is given. Where a picture differs or has no golden,
the session ends with golden-results/report.html and the command that approves it. Nothing is approved without a person.
"""
from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any, Sequence

import pytest

_LINES = pytest.StashKey[list[str]]()



def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("steradian")
    group.addoption("--golden-output", default="golden-results", metavar="DIR",
                    help="folder for candidates and the report of goldens (default: golden-results)")
    group.addoption("--golden-report", action="store_true", help="write the report where all goldens agree, too")
    parser.addini("golden_dir", "folder of the goldens, from the root folder on (default: goldens/ beside each test's file)")


def _output(config: pytest.Config) -> Path:
    return Path(config.invocation_params.dir, config.getoption("--golden-output"))


def _is_worker(config: pytest.Config) -> bool:
    return hasattr(config, "workerinput")  # of pytest-xdist


def pytest_configure(config: pytest.Config) -> None:
    if not _is_worker(config):
        shutil.rmtree(_output(config) / "pictures", ignore_errors=True)


class Golden:
    """Compares pictures of one test with their goldens."""

    def __init__(self, request: pytest.FixtureRequest) -> None:
        self._request = request
        self._names: set[str] = set()

    def __call__(self, picture: Any, name: str | None = None, limits: Sequence[str] | str = (), *,
                 region: Sequence[int] | None = None, allow_nonfinite: bool = False) -> None:
        """Fails the test unless the picture agrees with its golden.

        limits, region and allow_nonfinite are those of `steradian.compare`. name: of the golden, where a test has several.
        """
        import steradian

        name = name or self._request.node.name
        name = re.sub(r"[^A-Za-z0-9_.-]+", "-", name).strip("-.")
        if name in self._names:
            raise ValueError(f"name: '{name}' has two pictures in one test: give each a name")
        self._names.add(name)
        folder = self._folder()
        candidate = self._keep(picture, folder, name)
        golden = folder / candidate.name
        entry = {"name": name, "candidate": str(candidate), "goldens": str(folder), "format": candidate.suffix[1:],
                 "tolerance": [limits] if isinstance(limits, str) else list(limits), "region": list(region or ()),
                 "allow_nonfinite": allow_nonfinite, "passed": False}
        failure = f"{golden}: there is no golden"
        if golden.is_file():
            comparison = steradian.compare(candidate, golden, limits, region=region, allow_nonfinite=allow_nonfinite)
            entry["passed"] = comparison.passed
            failure = f"{name} differs from {golden}\n{comparison}"
        candidate.with_name(candidate.name + ".json").write_text(json.dumps(entry), encoding="utf-8")
        if not entry["passed"]:
            pytest.fail(failure, pytrace=False)

    def _folder(self) -> Path:
        config = self._request.config
        named = config.getini("golden_dir")
        return Path(config.rootpath, named) if named else self._request.path.parent / "goldens"

    def _keep(self, picture: Any, folder: Path, name: str) -> Path:
        """Writes the candidate beside those of the same folder of goldens."""
        import numpy as np
        import steradian

        from ._compare import native_image

        try:
            group = folder.relative_to(self._request.config.rootpath).as_posix().replace("/", "-")
        except ValueError:
            group = "goldens"
        place = _output(self._request.config) / "pictures" / group
        place.mkdir(parents=True, exist_ok=True)
        if isinstance(picture, (str, Path)):
            return Path(shutil.copy(picture, place / (name + Path(picture).suffix)))
        if isinstance(picture, steradian.Result):
            picture.save(place / f"{name}.exr")
            return place / f"{name}.exr"
        array = np.asarray(picture)
        is_code = array.dtype == np.uint8
        file = place / (name + (".png" if is_code else ".exr"))
        native_image(array).write(str(file), "8bit" if is_code else "float")
        return file


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Golden:
    """Compares a picture with its golden: golden(picture, name=None, limits=[])."""
    return Golden(request)


def _suites(config: pytest.Config) -> list[tuple[Path, list[dict[str, Any]]]]:
    """Writes a suite for each folder of goldens. Returns its file and its entries."""
    suites = []
    for folder in sorted((_output(config) / "pictures").glob("*/")):
        entries = [json.loads(file.read_text(encoding="utf-8")) for file in sorted(folder.glob("*.json"))]
        if not entries:
            continue
        tests = []
        for entry in entries:
            test = {"name": entry["name"], "command": ["cp", entry["candidate"], "{out}"], "format": entry["format"],
                    "allow_nonfinite": entry["allow_nonfinite"]}
            for key in ("tolerance", "region"):
                if entry[key]:
                    test[key] = entry[key]
            tests.append(test)
        suite = _output(config) / f"{folder.name}.suite.json"
        suite.write_text(json.dumps({"name": folder.name, "goldens": entries[0]["goldens"], "tests": tests}, indent=1),
                         encoding="utf-8")
        suites.append((suite, entries))
    return suites


def pytest_sessionfinish(session: pytest.Session) -> None:
    config = session.config
    if _is_worker(config) or not (_output(config) / "pictures").is_dir():
        return
    from . import program

    lines = []
    for suite, entries in _suites(config):
        failed = [entry["name"] for entry in entries if not entry["passed"]]
        if not failed and not config.getoption("--golden-report"):
            continue
        out = suite.with_name(suite.name.removesuffix(".suite.json"))
        run = subprocess.run([program(), "golden", "run", suite, "-o", out], capture_output=True, text=True)
        if run.returncode not in (0, 1):
            lines.append(f"no report of goldens: {run.stderr.strip()}")
            continue
        lines.append(f"report of goldens: {out / 'report.html'}")
        if failed:
            lines.append(f"once you have looked at them: steradian golden approve {suite} -o {out} {' '.join(failed)}")
    config.stash[_LINES] = lines




def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    lines = config.stash.get(_LINES, [])
    if lines:
        terminalreporter.section("goldens")
        for line in lines:
            terminalreporter.write_line(line)
