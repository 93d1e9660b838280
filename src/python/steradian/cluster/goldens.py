"""A golden suite on workers: parts of it run where there is room, and are merged here."""
from __future__ import annotations

import argparse
import json
import os
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Callable

from . import work
from .failure import Failure
from .files import bundle_of, json_of, named_files
from .grading import local
from .tasks import Cluster


def files_of(suite: Path, also: list[Path]) -> set[Path]:
    """The suite, its goldens, its scenes with their textures, and what else its commands need."""
    files = named_files(suite)
    content = json_of(suite)
    goldens = suite.parent / (content.get("goldens", "goldens") if isinstance(content, dict) else "goldens")
    folders = [goldens, *also]
    texts = [t for t in (content.get("tests", []) if isinstance(content, dict) else [])]
    for test in texts:
        words = test.get("arguments", []) if isinstance(test, dict) else []
        folders += [suite.parent / after for word, after in zip(words, words[1:]) if word == "--shaders"]
    return files | {Path(os.path.abspath(folder)) for folder in folders if folder.exists()}


def golden(arguments: argparse.Namespace) -> int:
    suite = Path(os.path.abspath(arguments.suite))
    names = local(arguments.program, ["golden", "list", suite]).splitlines()  # an unreadable suite ends here, with its line
    cluster = Cluster(arguments.scheduler, arguments.program)
    try:
        files = files_of(suite, arguments.also) | {Path(os.path.abspath(folder)) for folder in arguments.shaders}
        root = Path(os.path.commonpath([suite.parent, *files]))
        bundle = ("bundle", cluster.share(bundle_of(root, files)))
        parts = arguments.parts or max(1, min(len(names), 4 * cluster.threads()))
        options = ["--retries", str(arguments.retries)]
        for folder in arguments.shaders:
            options += ["--shaders", os.path.relpath(os.path.abspath(folder), suite.parent)]
        with tempfile.TemporaryDirectory() as scratch:
            def keep(key: str, found: dict[str, bytes]) -> None:
                for name, content in found.items():
                    file = Path(scratch, key.replace("/", "-"), name)
                    file.parent.mkdir(parents=True, exist_ok=True)
                    file.write_bytes(content)

            relative = os.path.relpath(suite, root)

            def task(part: int) -> Callable[[], Any]:
                return lambda: cluster.submit(work.golden_shard, arguments.program, bundle, relative, options, part, parts)

            cluster.run("golden", ((f"part {part}/{parts}", task(part)) for part in range(1, parts + 1)), parts, keep)
            folders = sorted(Path(scratch).iterdir())
            if not folders:
                raise Failure(f"{suite}: no part came back: look at the workers' logs")
            return subprocess.run([arguments.program, "golden", "merge", suite, *folders, "-o", arguments.output]).returncode
    finally:
        cluster.close()
