#!/usr/bin/env python3
"""Moments of an animation, sequences of pictures, and variants, from the command line.

usage: motion_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of Motion below)
"""
import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import cli_test

SCENE = None


class Motion(cli_test.CommandLine):
    def render(self, output, *arguments):
        return cli_test.run("render", SCENE, "-o", self.folder / output, "--size", "48x32", "--samples", "2", "--exr-type", "half",
                            "--gl-debug", *arguments)

    def test_a_frame_is_the_still_of_its_time(self):
        result = self.render("f.###.exr", "--frames", "2:4", "--fps", "4", "--json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        files = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(files, ["f.002.exr", "f.003.exr", "f.004.exr"])
        self.assertEqual([Path(name).name for name in json.loads(result.stdout)["outputs"]], files)
        for frame in (2, 4):
            self.assertEqual(self.render("still.exr", "--at", frame / 4).returncode, 0)
            self.assertEqual((self.folder / "still.exr").read_bytes(), (self.folder / f"f.00{frame}.exr").read_bytes())
        self.assertNotEqual((self.folder / "f.002.exr").read_bytes(), (self.folder / "f.004.exr").read_bytes())
        self.assertIn(b"steradian:time", (self.folder / "f.003.exr").read_bytes())

    def test_a_sequence_goes_up_to_the_end_of_its_animation(self):
        result = self.render("f%02d.png", "--frames", "3:", "--fps", "2")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["f03.png", "f04.png"])  # 2 s

    def test_a_moment_beyond_the_end_is_one_line(self):
        self.assert_refused(self.render("a.png", "--at", "2.5"), "motion.gltf", "2.5 s is beyond", "ends at 2 s")
        self.assert_refused(self.render("a.#.png", "--frames", "0:9", "--fps", "4"), "2.25 s is beyond")
        self.assert_refused(self.render("a.png", "--at", "1", "--animation", "Walk"), '"Walk"', '0 "all"')
        self.assert_refused(self.render("a.png", "--variant", "rusty"), '"rusty"', '"gilded"')
        self.assert_refused(cli_test.run("render", cli_test.SCENE, "-o", self.folder / "a.png", "--at", "0"), "no animation")

    def test_a_sequence_needs_a_place_for_its_numbers(self):
        for arguments in (("--frames", "0:1"), ("--frames", "1"), ("--fps", "3"), ("--frames", "0:1", "--at", "1")):
            result = self.render("a.png", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
        self.assertIn("####", self.render("a.png", "--frames", "0:1").stderr)

    def test_a_variant_changes_the_picture(self):
        self.assertEqual(self.render("a.exr").returncode + self.render("b.exr", "--variant", "gilded").returncode, 0)
        self.assertNotEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_an_interrupted_sequence_leaves_whole_frames(self):
        process = subprocess.Popen([cli_test.STERADIAN, "render", SCENE, "-o", str(self.folder / "f.####.exr"), "--size", "48x32",
                                    "--samples", "4", "--frames", "0:9999", "--fps", "10000"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60.0
        while not (self.folder / "f.0001.exr").exists() and time.monotonic() < deadline:
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        _, stderr = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, stderr)
        self.assertIn("the frames before are written", stderr)
        for file in self.folder.iterdir():
            self.assertNotIn(b"steradian:interrupted", file.read_bytes())

    def test_info_lists_what_moves(self):
        contents = json.loads(cli_test.run("info", SCENE, "--json").stdout)
        self.assertEqual(contents["animations"], [{"name": "all", "duration [s]": 2.0, "channels": 6}])
        self.assertEqual((contents["skins"], contents["morph_targets"], contents["variants"]), (1, 2, ["gilded"]))
        self.assertIn({"name": "KHR_animation_pointer", "required": False, "honoured": True}, contents["extensions"])


if __name__ == "__main__":
    SCENE = str(Path(sys.argv[2], "motion.gltf"))
    sys.exit(cli_test.main(Motion))
