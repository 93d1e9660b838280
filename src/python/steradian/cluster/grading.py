"""A class on workers: each submission is graded where there is room, and its files come back one by one."""
from __future__ import annotations

import argparse
import fcntl
import json
import os
import subprocess
from pathlib import Path
from typing import Any, Callable, Sequence

from . import work
from .failure import Failure
from .files import folder_bundle, submission_entries
from .tasks import Cluster

MOST_WITHOUT_VALUES = 3  # fewer submissions than that are not worth the values that all are compared with
LEAST_FOR_MISTAKES = 16  # as in src/assignment/grade.hpp


def local(program: str, words: Sequence[object]) -> str:
    run = subprocess.run([program, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")
    if run.returncode != 0:
        raise Failure(work.last_line(run))
    return run.stdout


def write_whole(file: Path, content: bytes) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    scratch = file.with_name(file.name + ".part")
    scratch.write_bytes(content)
    scratch.rename(file)


def write_result(out: Path, files: dict[str, bytes]) -> None:
    """results/KEY.json comes last: it says that the others are there."""
    for name in sorted(files, key=lambda name: name.startswith("results/")):
        write_whole(out / name, files[name])


def grade_all(cluster: Cluster, arguments: argparse.Namespace, listed: dict[str, Any]) -> None:
    assignment = ("bundle", cluster.share(folder_bundle(Path(listed["assignment"]))))
    hidden = ("bundle", cluster.share(folder_bundle(arguments.hidden))) if arguments.hidden else None
    waiting = listed["ungraded"]
    values = b""
    if len(waiting) >= MOST_WITHOUT_VALUES:  # a task of its own: workers take its result from each other
        values = cluster.submit(work.compute_references, arguments.program, assignment, hidden, len(waiting) >= LEAST_FOR_MISTAKES)
    options = ["--time-limit", str(arguments.time_limit), "--memory", str(arguments.memory)]

    def task(one: dict[str, Any]) -> tuple[str, Callable[[], Any]]:
        path = Path(one["path"])
        record = {**one, "file": os.fsencode(path.name)}
        return one["key"], lambda: cluster.submit(work.grade_one, arguments.program, assignment, hidden, values, submission_entries(path), record,
                                                  options)

    cluster.run("grading", map(task, waiting), len(waiting), lambda key, files: write_result(arguments.out, files))


def grade(arguments: argparse.Namespace) -> int:
    words = ["assignment", "grade", arguments.assignment, "--submissions", arguments.submissions, "--out", arguments.out,
             "--time-limit", arguments.time_limit, "--memory", arguments.memory]
    words += ["--hidden", arguments.hidden] if arguments.hidden else []
    arguments.out.mkdir(parents=True, exist_ok=True)
    with open(arguments.out / ".lock", "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise Failure(f"{arguments.out}: another process grades into this folder: wait for it, or name another folder") from None
        listed = json.loads(local(arguments.program, [*words, "--list"]))
        if listed["ungraded"]:
            cluster = Cluster(arguments.scheduler, arguments.program)
            try:
                grade_all(cluster, arguments, listed)
            finally:
                cluster.close()
    # With all results there, the command only writes what is made of them.
    return subprocess.run([arguments.program, *map(str, words)]).returncode
