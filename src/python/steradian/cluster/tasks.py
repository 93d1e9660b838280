"""Tasks on workers: a few at a time for each, with progress, until each has its result."""
from __future__ import annotations

import sys
import time
from types import FunctionType
from typing import Any, Callable, Iterable

from .failure import Failure
from .files import Bundle

MOST_ATTEMPTS = 3  # of a task whose data was lost with its workers
AHEAD = 2  # tasks that wait on a worker for each that it runs: the scheduler never holds a whole class


class Progress:
    """A line on a terminal; elsewhere one every ten seconds."""

    def __init__(self, what: str, total: int):
        self.what, self.total, self.done = what, total, 0
        self.begin = self.last = time.monotonic()
        self.is_terminal = sys.stderr.isatty()

    def advance(self, count: int, state: str) -> None:
        self.done += count
        now = time.monotonic()
        is_end = self.done == self.total
        if not is_end and now - self.last < (0.2 if self.is_terminal else 10.0):
            return
        self.last = now
        left = (now - self.begin) / self.done * (self.total - self.done)
        line = f"{self.what}: {self.done} of {self.total}, {state}, " + (f"{now - self.begin:.0f} s" if is_end else f"{left:.0f} s left")
        print("\r\x1b[K" + line if self.is_terminal else line, end="\n" if is_end or not self.is_terminal else "", file=sys.stderr, flush=True)


class Cluster:
    """Workers of a scheduler, with bundles that lie on each of them."""

    def __init__(self, address: str, program: str):
        try:
            import distributed
        except ImportError:
            raise Failure("the Python package distributed is missing: python3 -m pip install distributed") from None
        from . import work

        for function in vars(work).values():  # found in no module by its name, a function travels by value
            if isinstance(function, FunctionType) and function.__module__ == work.__name__:
                function.__module__ = "__main__"
        self.distributed, self.program = distributed, program
        try:
            self.client = distributed.Client(address, timeout="10s", set_as_default=False)
        except (OSError, TimeoutError, ValueError) as error:
            raise Failure(f"{address}: no Dask scheduler answers ({type(error).__name__}): start one with: dask scheduler") from None
        self.bundles: dict[str, Bundle] = {}
        self.futures: dict[str, Any] = {}
        self.require_workers(address, work.version_of)

    def require_workers(self, address: str, version_of: Callable[[str], str]) -> None:
        """Each worker has the program, in this version: other versions may make other pictures."""
        own = version_of(self.program)
        try:
            self.client.wait_for_workers(1, timeout=60)
        except (TimeoutError, OSError):
            raise Failure(f"{address}: no worker within a minute: start some with: dask worker {address}") from None
        for worker, version in sorted(self.client.run(version_of, self.program).items()):
            if version.startswith("ERROR "):
                raise Failure(f"{worker}: {version[6:]}")
            if version != own:
                raise Failure(f"{worker}: has {version}, and here is {own}: install one version everywhere")

    def share(self, bundle: Bundle) -> str:
        """Sends a bundle to each worker once. @return its name for tasks"""
        self.bundles[bundle[0]] = bundle
        self.futures[bundle[0]] = self.client.scatter(bundle, broadcast=True, hash=False)
        return bundle[0]

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """A task, whose arguments may be ("bundle", name) or other tasks."""
        def is_bundle(argument: Any) -> bool:
            return isinstance(argument, tuple) and len(argument) == 2 and argument[0] == "bundle"

        given = [self.futures[a[1]] if is_bundle(a) else a for a in arguments]
        return self.client.submit(function, *given, pure=False, retries=0)

    def threads(self) -> int:
        return max(1, int(sum(self.client.nthreads().values())))

    def run(self, what: str, tasks: Iterable[tuple[str, Callable[[], Any]]], total: int, on_result: Callable[[str, Any], object],
            weight: Callable[[str], int] = lambda key: 1) -> None:
        """Runs (key, make) pairs, where make() submits a task, and calls on_result(key, result) for each. Tasks of workers that end are
        done by others, and bundles that were lost with them are sent again. @raises Failure for a task that fails"""
        progress = Progress(what, total)
        waiting: dict[Any, tuple[str, Callable[[], Any]]] = {}
        attempts: dict[str, int] = {}
        tasks = iter(tasks)
        completed = self.distributed.as_completed(loop=self.client.loop)

        def fill() -> None:
            while len(waiting) < (1 + AHEAD) * self.threads():
                task = next(tasks, None)
                if task is None:
                    return
                start(*task)

        def start(key: str, make: Callable[[], Any]) -> None:
            future = make()
            waiting[future] = key, make
            completed.add(future)

        fill()
        while waiting:
            future = next(completed)
            key, make = waiting.pop(future)
            if future.status == "finished":
                on_result(key, future.result())
                progress.advance(weight(key), f"{len(self.client.nthreads())} workers")
            elif future.status in ("cancelled", "lost"):
                attempts[key] = attempts.get(key, 0) + 1
                if self.client.status != "running" or attempts[key] > MOST_ATTEMPTS:
                    raise Failure(f"{key}: the scheduler or all workers are gone: start them, and the same command goes on")
                for bundle in list(self.bundles.values()):
                    self.share(bundle)
                start(key, make)
            else:
                raise Failure(self.reason(key, future.exception()))
            del future
            fill()

    def reason(self, key: str, error: BaseException) -> str:
        if isinstance(error, self.distributed.scheduler.KilledWorker):
            return f"{key}: each worker that took it ended: look at the workers' memory and logs"
        return f"{key}: {error}"

    def close(self) -> None:
        self.client.close(timeout=2)
