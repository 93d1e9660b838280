#!/usr/bin/env python3
"""tools/test itself: its status, its presets and what it hands to ctest, with stand-ins for cmake and ctest.

usage: test_script_test.py SOURCE_FOLDER
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path


class TestScript(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "tools").mkdir()
        for name in ("common.sh", "test"):
            shutil.copy(SOURCES / "tools" / name, self.folder / "tools" / name)
        self.stand_in("tools/setup", "exit 0")
        self.stand_in("tools/lint", "exit 0")
        self.stand_in("bin/cmake", "exit 0")
        self.stand_in("bin/ctest", "exit 0")

    def stand_in(self, name, body):
        file = self.folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(f'#!/bin/sh\necho "{file.name} $*" >>"{self.folder}/calls"\n{body}\n')
        file.chmod(0o755)

    def run_it(self, *arguments):
        """The status, and the calls of ctest."""
        path = f"{self.folder / 'bin'}{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run([self.folder / "tools" / "test", *arguments], env={**os.environ, "PATH": path},
                              capture_output=True, text=True, timeout=60, check=False)
        log = self.folder / "calls"
        calls = log.read_text().splitlines() if log.exists() else []
        return done.returncode, [call for call in calls if call.startswith("ctest")]

    def test_passes_when_every_test_passes(self):
        status, calls = self.run_it()
        self.assertEqual(status, 0)
        self.assertEqual([call.split()[2] for call in calls], ["release", "sanitize"])

    def test_fails_when_a_test_fails_and_still_runs_the_other_preset(self):
        self.stand_in("bin/ctest", 'case "$*" in *release*) exit 8 ;; esac')
        status, calls = self.run_it()
        self.assertEqual(status, 1)
        self.assertEqual(len(calls), 2)

    def test_fails_when_the_build_fails(self):
        self.stand_in("bin/cmake", 'case "$*" in *--build*) exit 1 ;; esac')
        status, calls = self.run_it("--no-sanitize")
        self.assertNotEqual(status, 0)
        self.assertEqual(calls, [])

    def test_fails_when_the_form_is_wrong_and_still_runs_the_tests(self):
        self.stand_in("tools/lint", "exit 1")
        status, calls = self.run_it()
        self.assertEqual(status, 1)
        self.assertEqual(len(calls), 2)

    def test_refuses_what_it_does_not_know(self):
        for arguments in (["--nonsense"], ["law"], ["-L"]):
            status, calls = self.run_it(*arguments)
            self.assertEqual((status, calls), (2, []), arguments)

    def test_hands_its_arguments_to_ctest(self):
        status, calls = self.run_it("--no-sanitize", "-L", "law")
        self.assertEqual(status, 0)
        self.assertEqual(len(calls), 1)
        self.assertTrue(calls[0].endswith("-L law"), calls[0])


if __name__ == "__main__":
    SOURCES = Path(sys.argv.pop())
    unittest.main()
