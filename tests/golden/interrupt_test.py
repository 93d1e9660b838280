#!/usr/bin/env python3
"""A run that is ended in the middle, politely or not, leaves nothing half-written and nothing that could be approved.

usage: interrupt_test.py STERADIAN SOURCE_FOLDER SCRATCH_FOLDER
"""
import json
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path


def is_running(pid):
    try:
        return Path("/proc", pid, "stat").read_text().rsplit(")")[-1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def main():
    program, source, scratch = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    # The second test says when it runs, and would then run for ten minutes.
    suite = {"defaults": {"size": "16x16", "samples": 1}, "tests": [
        {"name": "quick", "scene": str(source / "tests/golden/scenes/sun.gltf")},
        {"name": "slow", "command": ["sh", "-c", "echo half > $0; sleep 600 & echo $$ $! > pids; touch started; wait", "{out}"]}]}
    file, out, started = scratch / "suite.json", scratch / "out", scratch / "started"
    file.write_text(json.dumps(suite))
    for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 130), (signal.SIGKILL, -signal.SIGKILL)):
        started.unlink(missing_ok=True)
        out.mkdir(exist_ok=True)
        (out / "results.json").write_text("of an earlier run")
        run = subprocess.Popen([program, "golden", "run", file, "-o", out], stderr=subprocess.PIPE, text=True)
        while not started.exists():
            assert run.poll() is None, "the run ended by itself"
            time.sleep(0.01)
        begin = time.monotonic()
        run.send_signal(number)
        _, error = run.communicate()
        assert run.returncode == status, (number, run.returncode)
        assert time.monotonic() - begin < 100, "it went on"
        for pid in (scratch / "pids").read_text().split():
            while is_running(pid):
                assert time.monotonic() - begin < 200, f"a child is left after {number!r}"
                time.sleep(0.01)
        left = sorted(path.name for path in out.iterdir())
        assert left == ["candidates", "logs"], left
        assert not (scratch / "goldens").exists()
        if status == 130:
            assert error == "interrupted: no results were written\n", error
            assert not (out / "candidates/slow.exr").exists(), "half an image was left"
        approve = subprocess.run([program, "golden", "approve", file, "-o", out], capture_output=True, text=True)
        assert approve.returncode == 3 and "no results of a run" in approve.stderr, approve


if __name__ == "__main__":
    main()
