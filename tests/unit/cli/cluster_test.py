#!/usr/bin/env python3
"""Classes, frames and golden suites on two workers of a Dask scheduler, one of which is killed: as on one machine.

usage: cluster_test.py STERADIAN SOURCE_FOLDER TEST_NAME     (a method of Workers below)
Needs the Python package distributed; exit status 77 (skipped) without it.
"""
import filecmp
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

try:
    import distributed  # noqa: F401
except ImportError:
    print("SKIPPED: the Python package distributed is not installed")
    sys.exit(77)

STERADIAN, SOURCE = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
CLUSTER = STERADIAN.parent / "cluster"
ASSIGNMENT = SOURCE / "assets/assignments/a3-brdf"
PATIENCE = 240  # seconds


class Workers(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = Path(scratch.name)
        file = self.scratch / "scheduler.json"
        self.start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", file)
        self.wait_for(lambda: file.is_file() and file.read_text().rstrip().endswith("}"))  # it is there before its text is
        self.address = json.loads(file.read_text())["address"]
        self.workers = [self.start("distributed.cli.dask_worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard", "--name", name,
                                   "--local-directory", self.scratch / name) for name in ("a", "b")]
        client = distributed.Client(self.address, set_as_default=False)
        client.wait_for_workers(2, timeout=PATIENCE)
        client.close()

    def start(self, module: str, *words) -> subprocess.Popen:
        process = subprocess.Popen([sys.executable, "-m", module, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, condition):
        end = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), end, "it takes too long")
            time.sleep(0.02)

    def begin(self, command: str, *words, address: str = "") -> subprocess.Popen:
        process = subprocess.Popen([sys.executable, CLUSTER, command, *map(str, words[:1]), "--scheduler", address or self.address, "--program",
                                    STERADIAN, *map(str, words[1:])], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=self.scratch)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def end(self, process: subprocess.Popen, status: int = 0) -> str:
        output = process.communicate(timeout=PATIENCE)[0]
        self.assertEqual(process.returncode, status, output)
        return output

    def kill_a_worker_after(self, is_begun):
        self.wait_for(is_begun)
        self.workers[0].kill()

    def class_of(self, count: int) -> tuple[Path, Path]:
        """A copy of a3 with two tasks, and submissions."""
        assignment, submissions = self.scratch / "assignments/a3-brdf", self.scratch / "submissions"
        shutil.copytree(ASSIGNMENT, assignment)
        manifest = json.loads((assignment / "assignment.json").read_text())
        manifest["files"] = ["phong.glsl", "microfacets.glsl"]
        manifest["tasks"] = [task for task in manifest["tasks"] if task["id"] in ("A3.1", "A3.5")]
        (assignment / "assignment.json").write_text(json.dumps(manifest))
        for i in range(count):
            shutil.copytree(assignment / "shaders", submissions / f"s{i}")
            (submissions / f"s{i}/assignment.json").write_text(json.dumps({"assignment": "a3-brdf", "student": f"{i}"}))
            text = (submissions / f"s{i}/microfacets.glsl").read_text()
            if i % 2:
                (submissions / f"s{i}/microfacets.glsl").write_text(text.replace("return D(dot(n, h)", "return pi * D(dot(n, h)"))
        (submissions / "s0/link.glsl").symlink_to("/etc/passwd")
        (submissions / "s0/large.glsl").write_bytes(bytes(2 << 20))
        os.mkfifo(submissions / "s0/pipe.glsl")
        return assignment, submissions

    def assert_same_files(self, one: Path, other: Path):
        names = {str(f.relative_to(one)) for f in one.rglob("*") if f.is_file()}
        self.assertEqual(names, {str(f.relative_to(other)) for f in other.rglob("*") if f.is_file()})
        different = [name for name in sorted(names) if not filecmp.cmp(one / name, other / name, shallow=False)]
        self.assertEqual(different, [])

    def test_a_class_loses_nothing_with_a_worker(self):
        assignment, submissions = self.class_of(6)
        hidden = self.scratch / "hidden"
        hidden.mkdir()
        (hidden / "hidden.json").write_text(json.dumps({"tasks": {"A3.1": [
            {"name": "elsewhere", "points": 1, "unit": "1", "value": "1.0", "inputs": [{"x": {"from": 0, "to": 1}}]}]}}))
        words = ["--submissions", submissions, "--hidden", hidden, "--time-limit", "200"]  # a busy machine must not decide marks
        grading = self.begin("grade", assignment, *words, "--out", self.scratch / "marks")
        self.kill_a_worker_after(lambda: list((self.scratch / "marks").glob("results/*.json")))
        self.end(grading)
        subprocess.run([STERADIAN, "assignment", "grade", assignment, *words, "--out", self.scratch / "alone"], check=True, stdout=subprocess.DEVNULL)
        self.assert_same_files(self.scratch / "marks", self.scratch / "alone")
        self.assertEqual(len(list((self.scratch / "marks/results").iterdir())), 6)

    def test_a_class_goes_on_after_the_client_was_killed(self):
        assignment, submissions = self.class_of(6)
        words = ["--submissions", submissions, "--out", self.scratch / "marks"]
        results = self.scratch / "marks/results"
        grading = self.begin("grade", assignment, *words)
        self.wait_for(lambda: len(list(results.glob("*.json"))) > 1)
        grading.kill()
        grading.wait()
        before = {f.name: f.stat().st_mtime_ns for f in results.glob("*.json")}
        run = subprocess.run([STERADIAN, "assignment", "grade", assignment, *words, "--dask", self.address], capture_output=True, text=True,
                             env={**os.environ, "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"})
        self.assertEqual(run.returncode, 0, run.stderr)
        after = {f.name: f.stat().st_mtime_ns for f in results.glob("*.json")}
        self.assertEqual(len(after), 6)
        self.assertEqual({name: after[name] for name in before}, before, "nothing is graded twice")

    def test_frames_are_those_of_one_machine(self):
        scene = self.scratch / "scenes/motion.gltf"
        scene.parent.mkdir()
        gltf = json.loads((SOURCE / "assets/scenes/motion.gltf").read_text())
        self.assertTrue(gltf["buffers"][0]["uri"].startswith("data:"))
        import base64
        (scene.parent / "motion.bin").write_bytes(base64.b64decode(gltf["buffers"][0]["uri"].split(",")[1]))
        gltf["buffers"][0]["uri"] = "motion.bin"
        scene.write_text(json.dumps(gltf))
        options = ["--size", "48x32", "--samples", "2", "--fps", "5"]
        for folder in ("apart", "alone"):
            (self.scratch / folder).mkdir()
        rendering = self.begin("render", "scenes/motion.gltf", "--frames", "0:9", "-o", "apart/f.####.exr", "-o", "apart/f.####.png", "--", *options)
        self.kill_a_worker_after(lambda: list((self.scratch / "apart").glob("*.exr")))
        self.end(rendering)
        subprocess.run([STERADIAN, "render", "scenes/motion.gltf", "--frames", "0:9", "-o", "alone/f.####.exr", "-o", "alone/f.####.png", *options],
                       check=True, cwd=self.scratch)
        self.assert_same_files(self.scratch / "apart", self.scratch / "alone")
        self.assertEqual(len(list((self.scratch / "apart").iterdir())), 20)
        unpacked = {name: len(list((self.scratch / name).rglob("motion.bin"))) for name in ("a", "b")}
        self.assertEqual(unpacked["b"], 1, "the scene comes once to each worker, with its buffer")
        self.assertLessEqual(unpacked["a"], 1, "it may have ended before")
        (self.scratch / "apart/f.0003.exr").unlink()
        before = {f.name: f.stat().st_mtime_ns for f in (self.scratch / "apart").iterdir() if ".0003." not in f.name}
        self.end(self.begin("render", "scenes/motion.gltf", "--frames", "0:9", "-o", "apart/f.####.exr", "-o", "apart/f.####.png", "--resume", "--",
                            *options))
        self.assert_same_files(self.scratch / "apart", self.scratch / "alone")
        self.assertEqual({name: (self.scratch / "apart" / name).stat().st_mtime_ns for name in before}, before, "frames that are there stay")

    def test_a_turntable_is_that_of_one_machine(self):
        for folder in ("apart", "alone"):
            (self.scratch / folder).mkdir()
        options = ["--size", "48x32", "--samples", "2", "--at", "0.5"]
        scene = SOURCE / "assets/scenes/motion.gltf"
        rendering = self.begin("render", scene, "--turntable", "10", "-o", "apart/t.##.exr", "-o", "apart/t.##.png", "--", *options)
        self.kill_a_worker_after(lambda: list((self.scratch / "apart").glob("*.exr")))
        self.end(rendering)
        subprocess.run([STERADIAN, "render", scene, "--turntable", "10", "-o", "alone/t.##.exr", "-o", "alone/t.##.png", *options], check=True,
                       cwd=self.scratch)
        self.assert_same_files(self.scratch / "apart", self.scratch / "alone")
        self.assertEqual(len({file.read_bytes() for file in (self.scratch / "apart").glob("*.exr")}), 10, "ten pictures, all different")

    def test_a_suite_has_the_results_of_one_machine(self):
        suite = json.loads((SOURCE / "tests/golden/suite.json").read_text())
        chosen = [test for test in suite["tests"] if test["name"].startswith("plane_")][:4]
        self.assertEqual(len(chosen), 4)
        folder = self.scratch / "golden"
        shutil.copytree(SOURCE / "tests/golden/scenes", folder / "scenes")
        shutil.copytree(SOURCE / "tests/golden/goldens", folder / "goldens")
        (folder / "suite.json").write_text(json.dumps({**{k: v for k, v in suite.items() if k != "$schema"}, "tests": chosen}))
        (folder / f"goldens/{chosen[0]['name']}.exr").unlink()  # one test has no golden
        testing = self.begin("golden", folder / "suite.json", "-o", self.scratch / "apart", "--parts", "4")
        self.end(testing, status=1)
        subprocess.run([STERADIAN, "golden", "run", folder / "suite.json", "-o", self.scratch / "alone"], stdout=subprocess.DEVNULL)
        self.assertEqual((self.scratch / "apart/results.json").read_bytes(), (self.scratch / "alone/results.json").read_bytes())
        self.assert_same_files(self.scratch / "apart/candidates", self.scratch / "alone/candidates")

    def test_what_is_wrong_is_one_line(self):
        def line(process, words: str):
            lines = self.end(process, status=3).splitlines()
            self.assertEqual(len(lines), 1, lines)
            self.assertRegex(lines[0], words)

        scene = SOURCE / "assets/scenes/cornell.gltf"
        frames = ["--frames", "0:1", "-o", "f.####.png"]
        line(self.begin("render", scene, *frames, address="tcp://127.0.0.1:1"), "no Dask scheduler answers")
        line(self.begin("render", scene, "--frames", "0:1", "-o", "f.png"), "would have this name")
        line(self.begin("render", "none.gltf", *frames), "none.gltf: no file")
        line(self.begin("render", scene, *frames, "--", "--size", "0x0"), "size")
        line(self.begin("render", scene, "-o", "f.####.png"), "write --frames FIRST:LAST .* or --turntable")
        line(self.begin("render", scene, *frames, "--turntable", "1"), "beyond the 1 pictures")
        line(self.begin("grade", "a3", "--submissions", self.scratch / "none", "--out", self.scratch / "out"), "no folder")
        (self.scratch / "broken.json").write_text("{")
        line(self.begin("golden", self.scratch / "broken.json"), "broken.json:1")
        help_text = subprocess.run([sys.executable, CLUSTER, "--help"], capture_output=True, text=True, check=True).stdout
        self.assertRegex(re.sub(r"\s+", " ", help_text), "dask scheduler .* Examples:")

    def test_ctrl_c_ends_it(self):
        rendering = self.begin("render", SOURCE / "assets/scenes/motion.gltf", "--frames", "0:500", "-o", "f.####.png", "--", "--size", "32x32", "--fps", "400")
        self.wait_for(lambda: list(self.scratch.glob("f.*.png")))
        rendering.send_signal(signal.SIGINT)
        self.assertIn("goes on from there", self.end(rendering, status=130))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], f"Workers.test_{sys.argv[3]}"])
