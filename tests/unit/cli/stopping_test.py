#!/usr/bin/env python3
"""What ends a rendering, and what is left of it then.

usage: stopping_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of Stopping below)
"""
import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import cli_test


class Stopping(cli_test.CommandLine):
    def catches(self, pid, number):
        """Whether a process has a handler for the signal (proc(5), SigCgt): it has begun to draw."""
        status = Path(f"/proc/{pid}/status").read_text()
        caught = next(line for line in status.splitlines() if line.startswith("SigCgt:"))
        return int(caught.split()[1], 16) >> (number - 1) & 1

    def interrupted(self, *signals):
        """A rendering that would take for ever, after these signals; with what it said on stderr."""
        process = subprocess.Popen([cli_test.STERADIAN, "render", cli_test.SCENE, "-o", str(self.folder / "a.exr"), "--size", "32x32",
                                    "--samples", "10000000"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while not self.catches(process.pid, signal.SIGINT):
            self.assertIsNone(process.poll(), "it ended by itself")
            time.sleep(0.05)
        time.sleep(0.3)
        for number in signals:
            process.send_signal(number)
        _, stderr = process.communicate(timeout=200)
        return process.returncode, stderr, [path.name for path in self.folder.iterdir()]

    def test_ctrl_c_writes_what_there_is(self):
        status, stderr, files = self.interrupted(signal.SIGINT)
        self.assertEqual((status, files), (130, ["a.exr"]), stderr)
        self.assertIn("what there is was written", stderr)
        self.assertIn(b"steradian:interrupted", (self.folder / "a.exr").read_bytes())

    def test_asked_to_leave_it_writes_nothing(self):
        status, stderr, files = self.interrupted(signal.SIGTERM)
        self.assertEqual((status, files), (130, []), stderr)
        self.assertIn("nothing was written", stderr)

    def test_an_error_ends_a_rendering(self):
        for arguments, reason in ((("--error", "12%"), "error"), (("--error", "0.01%", "--samples", "12"), "samples"),
                                  (("--time", "0.01s"), "time")):
            result = cli_test.run("render", cli_test.SCENE, "-o", self.folder / "a.exr", "--size", "32x32", "--json", *arguments)
            self.assertEqual(result.returncode, 0, result.stderr)
            summary = json.loads(result.stdout)
            self.assertEqual(summary["stopped_by"], reason)
            self.assertEqual("not 0.01 %" in result.stderr, reason == "samples", result.stderr)
            attributes = (self.folder / "a.exr").read_bytes()
            self.assertIn(b"steradian:stopped_by", attributes)
            if reason == "error":
                self.assertLessEqual(summary["error"], 0.12)
                self.assertLess(summary["samples_min"], summary["samples"])
                self.assertIn(b"steradian:error", attributes)

    def test_what_does_not_go_together_is_refused(self):
        for arguments, word in ((("--view", "visibility", "--error", "1%"), "radiance"), (("--view", "beauty"), "beauty"),
                                (("--view", "cosine", "--estimator", "analytic"), "sampled"),
                                (("--denoise",), "analytic"), (("--denoise", "--estimator", "analytic", "--error", "1%"), "--error"),
                                (("--aov", "depth"), ".exr"), (("--aov", "deep"), "deep")):
            result = self.render("a.png", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertIn(word, result.stderr)
        self.assertEqual(self.render("a.png", "--view", "luminance").returncode, 0)


if __name__ == "__main__":
    sys.exit(cli_test.main(Stopping))
