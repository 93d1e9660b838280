#!/usr/bin/env python3
"""Moments of an animation, sequences of pictures, and variants, from the command line.

usage: motion_test.py STERADIAN SCENES_FOLDER TEST_NAME     (TEST_NAME is a method of Motion below)
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
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

    def test_a_turntable_goes_around_other_axes(self):
        camera = "near=0.1;far=20;eye=0,1,4;target=0,1,0"
        turn = "--turntable", "4", "--frames", "1:1", "--camera", camera, "--turn-axis"
        bounds = json.loads(cli_test.run("info", SCENE, "--json").stdout)["bounds [m]"]
        x, y, z = (0.5 * (bounds["min"][axis] + bounds["max"][axis]) for axis in range(3))
        eye, target = (f"{p[0]},{y - (p[2] - z)},{z + (p[1] - y)}" for p in ((0, 1, 4), (0, 1, 0)))  # by 90 degrees around x
        self.assertEqual(self.render("still.exr", "--camera", f"near=0.1;far=20;eye={eye};target={target};up=0,0,1").returncode, 0)
        for axis in "x", "y", "z", "camera":
            result = self.render(f"{axis}.#.exr", *turn, axis)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertLess(self.difference(self.folder / "still.exr", self.folder / "x.1.exr"), 0.01)
        self.assertLess(self.difference(self.folder / "y.1.exr", self.folder / "camera.1.exr"), 0.01)  # it stands upright
        for one, other in ("x", "y"), ("x", "z"), ("y", "z"):
            self.assertGreater(self.difference(self.folder / f"{one}.1.exr", self.folder / f"{other}.1.exr"), 0.1)
        self.assertEqual(self.render("a.png", "--turn-axis", "x").returncode, 2)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is missing: tools/setup")
    def test_a_video_has_the_pictures_of_its_frames(self):
        result = cli_test.run("render", SCENE, *(word for name in ("v.mp4", "v.webm", "v.#.png") for word in ("-o", self.folder / name)),
                              "--turntable", "3", "--fps", "5", "--size", "95x63", "--samples", "2", "--tone-curve", "agx", "--json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        names = ["v.0.png", "v.1.png", "v.2.png", "v.mp4", "v.webm"]
        self.assertEqual([Path(name).name for name in json.loads(result.stdout)["outputs"]], names)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), names)
        self.assertGreater(self.difference(self.folder / "v.0.png", self.folder / "v.1.png"), 0.1)
        for kind in "mp4", "webm":
            subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / f"v.{kind}", "-vf", "scale=in_color_matrix=bt709:in_range=tv,format=rgb24,crop=95:63:0:0",
                            "-start_number", "0", self.folder / f"{kind}.%d.png"], check=True)
            self.assertEqual(len(list(self.folder.glob(f"{kind}.*.png"))), 3)
            for number in range(3):  # agx against aces is 0.024; the pictures of two frames differ by 0.17
                compared = cli_test.run("compare", self.folder / f"v.{number}.png", self.folder / f"{kind}.{number}.png", "--json")
                self.assertLess(json.loads(compared.stdout)["metrics"]["mean_abs"], 0.014, (kind, number))

    def test_a_video_without_its_encoder_is_one_line(self):
        video = "render", SCENE, "-o", self.folder / "v.mp4", "--turntable", "3"
        self.assert_refused(cli_test.run(*video, env={**os.environ, "PATH": str(self.folder)}), "v.mp4", "ffmpeg", "apt-get install")
        self.assertEqual(list(self.folder.iterdir()), [])

    def encoder(self, body):
        """The environment of a shell script in place of ffmpeg."""
        program = self.folder / "bin" / "ffmpeg"
        program.parent.mkdir(exist_ok=True)
        program.write_text(f"#!/bin/sh\n{body}\n")
        program.chmod(0o755)
        return {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}

    def test_an_encoder_that_fails_leaves_no_video(self):
        video = "render", SCENE, "-o", self.folder / "v.mp4", "--turntable", "3", "--size", "48x32", "--samples", "1"
        result = cli_test.run(*video, env=self.encoder("echo 'Unknown encoder' >&2; exit 1"))
        self.assert_refused(result, "v.mp4", "Unknown encoder")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["bin"])
        single = cli_test.run("render", SCENE, "-o", self.folder / "v.webm", env=self.encoder("exit 0"))
        self.assertEqual(single.returncode, 2)
        self.assertIn("--turntable", single.stderr)

    def interrupt(self, file, said, *arguments, env=None):
        """Presses Ctrl-C once a render has made this file in the folder. It says so, and has the status of an interruption."""
        process = subprocess.Popen([cli_test.STERADIAN, "render", SCENE, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True, env=env)
        deadline = time.monotonic() + 200.0
        while not (self.folder / file).exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, stderr = process.communicate(timeout=200)
        self.assertEqual(process.returncode, 130, stderr)
        self.assertIn(said, stderr)

    def test_an_interrupted_video_is_not_written(self):
        """The encoder never ends: the render waits for it, and Ctrl-C ends both."""
        environment = self.encoder(f"echo $$ > {self.folder}/pid; exec sleep 100")
        self.interrupt("pid", "no video is written", "-o", self.folder / "v.mp4", "--turntable", "2", "--size", "48x32", "--samples", "1",
                       env=environment)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["bin", "pid"])
        self.assertFalse(Path("/proc", (self.folder / "pid").read_text().strip()).exists(), "the encoder still runs")

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
        self.interrupt("f.0001.exr", "the frames before are written", "-o", self.folder / "f.####.exr", "--size", "48x32", "--samples", "4",
                       "--frames", "0:9999", "--fps", "10000")
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
