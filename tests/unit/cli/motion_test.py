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
        self.assertIn("####", self.render("a.png", "--turntable", "4").stderr)
        for arguments, words in ((("0:4",), "the last one is 3"), (("0:1", "--fps", "3"), "--fps")):
            result = self.render("a.#.png", "--turntable", "4", "--frames", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertIn(words, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_turntable_goes_once_around_a_scene_that_stands_still(self):
        result = self.render("t.#.exr", "--turntable", "4", "--camera", "eye=0,1,4;target=0,1,0;near=0.1;far=20", "--json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual([Path(name).name for name in json.loads(result.stdout)["outputs"]], [f"t.{n}.exr" for n in range(4)])
        bounds = json.loads(cli_test.run("info", SCENE, "--json").stdout)["bounds [m]"]
        middle = [0.5 * (bounds["min"][axis] + bounds["max"][axis]) for axis in (0, 2)]
        offsets = [[point[axis] - middle[axis] for axis in (0, 1)] for point in ((0, 4), (0, 0))]  # of eye and target: x and z
        for number in range(4):
            eye, target = (f"{middle[0] + x},1,{middle[1] + z}" for x, z in offsets)
            self.assertEqual(self.render("still.exr", "--camera", f"eye={eye};target={target};near=0.1;far=20").returncode, 0)
            self.assertLess(self.difference(self.folder / "still.exr", self.folder / f"t.{number}.exr"), 0.01, number)
            offsets = [[z, -x] for x, z in offsets]  # a quarter to the left, seen from above
        self.assertGreater(self.difference(self.folder / "t.0.exr", self.folder / "t.1.exr"), 0.1)
        self.assertIn(b"90 degrees", (self.folder / "t.1.exr").read_bytes())
        whole = (self.folder / "t.3.exr").read_bytes()
        (self.folder / "t.3.exr").unlink()
        self.assertEqual(self.render("t.#.exr", "--turntable", "4", "--frames", "3:", "--camera", "eye=0,1,4;target=0,1,0;near=0.1;far=20").returncode, 0)
        self.assertEqual((self.folder / "t.3.exr").read_bytes(), whole)

    def test_a_turning_camera_cuts_nothing_off(self):
        """The zoo is a long row, which is farther off from its front than from its ends."""
        view = "eye=0,0.5,9;target=0,0.5,0"
        for name, camera in (("own", view), ("deep", view + ";near=0.1;far=40"), ("flat", view + ";near=7;far=11")):
            result = cli_test.run("render", Path(SCENE).with_name("zoo.gltf"), "-o", self.folder / f"{name}.#.exr", "--turntable", 4, "--frames", "1:1",
                                  "--camera", camera, "--size", "48x32", "--samples", "4", "--exr-type", "half")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertLess(self.difference(self.folder / "own.1.exr", self.folder / "deep.1.exr"), 0.001)
        self.assertGreater(self.difference(self.folder / "flat.1.exr", self.folder / "deep.1.exr"), 0.01)

    def difference(self, one, other):
        """relMSE of two pictures"""
        return json.loads(cli_test.run("compare", one, other, "--json").stdout)["metrics"]["rel_mse"]

    def test_a_variant_changes_the_picture(self):
        self.assertEqual(self.render("a.exr").returncode + self.render("b.exr", "--variant", "gilded").returncode, 0)
        self.assertNotEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_an_interrupted_sequence_leaves_whole_frames(self):
        process = subprocess.Popen([cli_test.STERADIAN, "render", SCENE, "-o", str(self.folder / "f.####.exr"), "--size", "48x32",
                                    "--samples", "4", "--frames", "0:9999", "--fps", "10000"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 200.0
        while not (self.folder / "f.0001.exr").exists() and time.monotonic() < deadline:
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        _, stderr = process.communicate(timeout=200)
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
