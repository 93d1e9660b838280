#!/usr/bin/env python3
"""tools/setup for users who are not root, without a network, and in a checkout that cannot be written: it succeeds, or ends
with status 3 and one line. Debian's commands have stand-ins, and the checkout's path has a space.

usage: setup_script_test.py SOURCE_FOLDER
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

COMMANDS = ["bash", "cat", "cmp", "dirname", "env", "grep", "sed", "tail"]
NOBODY = 65534
NO_NETWORK = 'echo "E: Failed to fetch http://mirror/InRelease  Temporary failure resolving mirror" >&2; exit 100'


class SetupScript(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.checkout = self.folder / "a checkout"
        (self.checkout / "tools").mkdir(parents=True)
        for name in ("common.sh", "setup"):
            shutil.copy(SOURCES / "tools" / name, self.checkout / "tools" / name)
        (self.checkout / "tools/packages.txt").write_text("needed  why\nnice  optional  why\n")
        (self.checkout / "tools/requirements.txt").write_text("glad2\n")
        self.program(self.checkout / ".venv/bin/glad", "exit 0")
        shutil.copy(self.checkout / "tools/requirements.txt", self.checkout / ".venv/requirements.txt")
        (self.folder / "bin").mkdir()
        for name in COMMANDS:
            (self.folder / "bin" / name).symlink_to(shutil.which(name))
        self.program(self.folder / "bin/apt-cache", "exit 0")
        self.installed("needed", "nice")
        self.apt_get("exit 0")

    def program(self, file, body):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"#!/bin/sh\n{body}\n")
        file.chmod(0o755)

    def installed(self, *names):
        cases = "".join(f"*' {name}') echo installed ;; " for name in names)
        self.program(self.folder / "bin/dpkg-query", f'case "$*" in {cases}*) exit 1 ;; esac')

    def apt_get(self, body):
        self.program(self.folder / "bin/apt-get", f'echo "$*" >>"{self.folder}/calls"\n{body}')

    def sudo(self, body):
        self.program(self.folder / "bin/sudo", body)

    def run_it(self):
        """The status, the lines that are no headings, and whether apt-get was called."""
        for file in [self.folder, *self.folder.rglob("*")]:
            if not file.is_symlink():
                file.chmod(file.stat().st_mode | 0o055)
        self.folder.chmod(0o777) # apt-get's stand-in writes there
        user = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if os.geteuid() == 0 else {}
        done = subprocess.run([self.checkout / "tools/setup"], env={"PATH": str(self.folder / "bin")}, text=True,
                              capture_output=True, timeout=60, check=False, stdin=subprocess.DEVNULL, **user)
        lines = [line for line in (done.stdout + done.stderr).splitlines() if "\033[1m==" not in line]
        return done.returncode, lines, (self.folder / "calls").exists()

    def assert_one_line(self, outcome, *parts):
        status, lines, _ = outcome
        self.assertEqual((status, len(lines)), (3, 1), lines)
        for part in parts:
            self.assertIn(part, lines[0])

    def test_asks_nothing_where_everything_is_installed(self):
        self.assertEqual(self.run_it(), (0, [], False))

    def test_names_what_an_administrator_has_to_install(self):
        self.installed()
        self.assert_one_line(self.run_it(), "neither root nor sudo", "install: needed")

    def test_leaves_optional_packages_out_without_root(self):
        self.installed("needed")
        self.assertEqual(self.run_it(), (0, [], False))

    def test_says_that_sudo_refused(self):
        self.installed()
        self.sudo('echo "sudo: a password is required" >&2; exit 1')
        self.assert_one_line(self.run_it(), "sudo: a password is required")

    def test_says_that_nothing_can_be_fetched(self):
        self.installed()
        self.sudo('exec "$@"')
        self.apt_get(NO_NETWORK)
        self.assert_one_line(self.run_it(), "Failed to fetch", "run tools/setup again")

    def test_leaves_optional_packages_out_without_a_network(self):
        self.installed("needed")
        self.sudo('exec "$@"')
        self.apt_get(NO_NETWORK)
        self.assertEqual(self.run_it(), (0, [], True))

    def test_says_that_the_checkout_cannot_be_written(self):
        shutil.rmtree(self.checkout / ".venv")
        self.checkout.chmod(0o555)
        self.assert_one_line(self.run_it(), str(self.checkout), "cannot be written")


if __name__ == "__main__":
    SOURCES = Path(sys.argv.pop())
    unittest.main()
