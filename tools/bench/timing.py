"""Commands measured as whole processes, in turns, with the machine's load."""
import os
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path


class Failed(Exception):
    """A command that cannot be measured, with the last line that it said."""


@dataclass
class Cost:
    seconds: float     # on the clock
    processors: float  # of all cores, user and system [s]
    memory_mib: float  # the largest of the process, or of one of its children
    output: str        # what it printed


def load() -> float:
    """Processes that ran or waited, mean of a minute."""
    return os.getloadavg()[0]


def measured(command: list, writes: Path | None = None, environment: dict | None = None, folder: Path | None = None) -> Cost:
    """Runs a command. @param writes a file that must be there then @throws Failed"""
    if writes:
        writes.unlink(missing_ok=True)
    with tempfile.TemporaryFile() as errors, tempfile.TemporaryFile() as output:
        begin = time.perf_counter()
        try:
            process = subprocess.Popen(list(map(str, command)), stdout=output, stderr=errors, env={**os.environ, **(environment or {})}, cwd=folder)
        except OSError as error:
            raise Failed(f"{command[0]}: {error.strerror}") from None
        try:
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:
            process.kill()
            process.wait()
            raise
        seconds = time.perf_counter() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        output.seek(0)
        last = (errors.read().decode(errors="replace").strip().splitlines() or [""])[-1]
        said = output.read().decode(errors="replace")
    if process.returncode < 0:
        raise Failed(f"ended by signal {-process.returncode}")
    if process.returncode:
        raise Failed(f"status {process.returncode}: {last}")
    if writes and not writes.exists():
        raise Failed(f"wrote no picture: {last}")
    return Cost(seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, said)


def in_turns(tasks: dict, turns: int, say=lambda text: None, warm: bool = True) -> tuple[dict, dict]:
    """
    Calls each task once a turn, A B A B. A task that fails is left out from then on.
    @param tasks functions by name, which raise Failed @param warm one more turn before, which fills caches and does not count
    @return the results of each by name; why others failed, by name
    """
    results, failures = {name: [] for name in tasks}, {}
    for turn in range(-1 if warm else 0, turns):
        for name in list(results):
            say(f"{'warm-up' if turn < 0 else f'turn {turn + 1} of {turns}'}: {name}")
            try:
                result = tasks[name]()
            except Failed as why:
                failures[name] = str(why)
                del results[name]
                continue
            if turn >= 0:
                results[name].append(result)
    return results, failures


@dataclass
class Spread:
    median: float
    low: float
    high: float

    def text(self, digits: int = 2) -> str:
        """The median, and the range unless one value was measured."""
        median, low, high = (f"{value:.{digits}f}" for value in (self.median, self.low, self.high))
        return median if self.low == self.high else f"{median} ({low} to {high})"


def spread(values) -> Spread:
    values = list(values)
    return Spread(statistics.median(values), min(values), max(values))


class Progress:
    """One line on standard error that is written over; lines of their own where that is no terminal."""

    def __init__(self):
        self.begin = time.monotonic()
        self.is_terminal = sys.stderr.isatty()

    def say(self, text: str):
        line = f"[{time.monotonic() - self.begin:4.0f} s] {text}"
        print(f"\r\033[K{line[:150]}" if self.is_terminal else line, end="" if self.is_terminal else "\n", file=sys.stderr, flush=True)

    def close(self):
        if self.is_terminal:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
