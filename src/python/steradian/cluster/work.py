"""What workers do. It travels to them by value: they need the steradian program and the Python package distributed, nothing else.

A bundle is (digest, entries): files, each as (path, kind, content), which a worker writes down once.
"""
from __future__ import annotations

import ctypes
import json
import os
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Iterable, Sequence, TypeVar

if TYPE_CHECKING:  # on a worker there is no such module
    from .files import Bundle, Entry

Answer = TypeVar("Answer")
Files = dict[str, bytes]  # by their paths in a folder
Run = subprocess.CompletedProcess[str]


def die_with_parent() -> None:
    """Lets a program end with its worker, however that ends (Linux)."""
    try:
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG
    except (AttributeError, OSError):
        pass


def worker_place() -> tuple[Path, int]:
    """The worker's own folder, and how many tasks it runs at a time."""
    from distributed import get_worker

    worker = get_worker()
    place = Path(worker.local_directory) / "steradian"
    place.mkdir(parents=True, exist_ok=True)
    return place, worker.state.nthreads


def program_of(named: str) -> str:
    """The program as the client names it, or the one in this machine's PATH."""
    found = named if os.path.isfile(named) else shutil.which("steradian")
    if not found:
        raise RuntimeError(f"{named}: no such program here, and no steradian in PATH: install Steradian on each worker")
    return found


def version_of(named: str) -> str:
    try:
        return subprocess.run([program_of(named), "--version"], capture_output=True, text=True).stdout.strip()
    except (RuntimeError, OSError) as error:
        return f"ERROR {error}"


def write_entries(place: Path, entries: Iterable[Entry]) -> None:
    for path, kind, content in entries:
        target = os.path.join(os.fsencode(place), path)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        if kind == "folder":
            os.makedirs(target, exist_ok=True)
        elif kind == "link":
            os.symlink(content, target)
        elif kind == "other":
            os.mkfifo(target)
        else:
            with open(target, "wb") as stream:
                stream.write(content)
                if isinstance(kind, int):  # a size beyond what is read
                    stream.truncate(kind)


def unpacked(bundle: Bundle) -> Path:
    """The folder of a bundle, written once on each worker."""
    digest, entries = bundle
    place = worker_place()[0] / digest
    if not place.is_dir():
        scratch = Path(tempfile.mkdtemp(dir=place.parent))
        write_entries(scratch, entries)
        try:
            scratch.rename(place)
        except OSError:  # another thread of this worker was first
            shutil.rmtree(scratch)
    return place


def the_folder(bundle: Bundle) -> Path:
    """The one folder of a bundle, under its own name: an assignment's is its id."""
    return next(unpacked(bundle).iterdir())


def run(named: str, words: Iterable[object], folder: Path) -> Run:
    """Runs steradian with this task's share of the processors."""
    share = max(1, (os.cpu_count() or 1) // max(1, worker_place()[1]))
    environment = {**os.environ, "LP_NUM_THREADS": os.environ.get("LP_NUM_THREADS", str(share))}
    return subprocess.run([program_of(named), *map(str, words)], cwd=folder, env=environment, capture_output=True, text=True, errors="replace",
                          stdin=subprocess.DEVNULL, preexec_fn=die_with_parent)


def files_in(folder: Path) -> Files:
    """Paths within a folder → bytes."""
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def in_scratch(task: Callable[[Path], Answer]) -> Answer:
    """Calls task(folder) with a folder that goes when it returns."""
    folder = Path(tempfile.mkdtemp(dir=worker_place()[0]))
    try:
        return task(folder)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def last_line(run_result: Run) -> str:
    lines = [line for line in (run_result.stdout + "\n" + run_result.stderr).splitlines() if line.strip() and not line.startswith("Run with --help")]
    return lines[-1] if lines else f"exit status {run_result.returncode}"


def compute_references(program: str, assignment: Bundle, hidden: Bundle | None, mistakes: bool) -> bytes:
    """The values that submissions are compared with. They only save time, so a failure gives none."""
    def task(folder: Path) -> bytes:
        words: list[object] = ["assignment", "references", the_folder(assignment), folder / "values"]
        words += [f"--hidden={the_folder(hidden)}"] if hidden else []
        run(program, words + (["--mistakes"] if mistakes else []), folder)
        return (folder / "values").read_bytes() if (folder / "values").is_file() else b""

    return in_scratch(task)


def grade_one(program: str, assignment: Bundle, hidden: Bundle | None, values: bytes, submission: list[Entry], record: dict[str, Any],
              options: list[str]) -> Files:
    """The files of one submission's result."""
    def task(folder: Path) -> Files:
        write_entries(folder / "in", submission)
        place = folder / "in" / os.fsdecode(record["file"])
        words: list[object] = ["assignment", "grade-one", the_folder(assignment), place, "--out", folder / "out", *options]
        words += [f"--{name}={record[name]}" for name in ("key", "name", "id", "fingerprint") if record[name]]
        words += ["--hidden", the_folder(hidden)] if hidden else []
        if values:
            (folder / "values").write_bytes(values)
            words += ["--values", folder / "values"]
        done = run(program, words, folder)
        if done.returncode != 0:
            raise RuntimeError(last_line(done))
        return files_in(folder / "out")

    return in_scratch(task)


def render_frames(program: str, bundle: Bundle, folder: str, words: Sequence[str | tuple[str, str]], outputs: list[str], first: int,
                  last: int) -> tuple[Files, str, float | None]:
    """The pictures of frames first to last, what the program said, and the exposure of pictures for a screen (EV100, or None)."""
    def task(scratch: Path) -> tuple[Files, str, float | None]:
        root = unpacked(bundle)
        here = [str(root / word[1]) if isinstance(word, tuple) else word for word in words]
        for output in outputs:
            here += ["-o", str(scratch / output)]
        (root / folder).mkdir(parents=True, exist_ok=True)
        done = run(program, ["render", *here, "--frames", f"{first}:{last}", "--json"], root / folder)
        if done.returncode != 0:
            raise RuntimeError(last_line(done).replace(str(root) + os.sep, ""))
        return files_in(scratch), done.stderr.replace(str(root) + os.sep, ""), json.loads(done.stdout).get("ev100")

    return in_scratch(task)


def golden_shard(program: str, bundle: Bundle, suite: str, options: list[str], part: int, parts: int) -> Files:
    """The output folder of one part of a suite."""
    def task(scratch: Path) -> Files:
        file = unpacked(bundle) / suite
        done = run(program, ["golden", "run", file.name, "--shard", f"{part}/{parts}", "-o", scratch / "out", *options], file.parent)
        if not (scratch / "out" / "results.json").is_file():
            raise RuntimeError(last_line(done))
        return files_in(scratch / "out")

    return in_scratch(task)
