#!/usr/bin/env python3
"""`steradian assignment grade` as a teacher meets it, and what a hostile class cannot do to it.

usage: grade_command_test.py STERADIAN ASSIGNMENTS_FOLDER TEST_NAME     (a method of Class below)
"""
import base64
import csv
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
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "assignment"))
import hostile  # noqa: E402
import hostile_forms  # noqa: E402

STERADIAN, ASSIGNMENTS = sys.argv[1], Path(sys.argv[2])
REFERENCE = ASSIGNMENTS / "a3-brdf" / "shaders"

# F at another place than the public checks look, and a law.
HIDDEN = {"seed": 11, "tasks": {"A3.4": [
    {"name": "elsewhere", "points": 1, "unit": "SECRET_UNIT", "type": "vec3", "value": "F(0.123456, vec3(0.654321))",
     "inputs": [{"unused_secret": {"from": 0, "to": 1}}], "hint": "SECRET_HINT"}]}}
TASKS = ("A3.1", "A3.4")  # of a copy of a3: two tasks show what grading does, and seven take minutes
SECRETS = ("SECRET", "0.123456", "0.654321", "unused_secret")


class Class(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = Path(scratch.name)
        self.submissions, self.out, self.hidden = (self.scratch / name for name in ("submissions", "marks", "hidden"))
        self.assignment = self.scratch / "assignments" / "a3-brdf"
        shutil.copytree(ASSIGNMENTS / "a3-brdf", self.assignment)
        manifest = json.loads((self.assignment / "assignment.json").read_text())
        manifest["files"] = ["phong.glsl", "microfacets.glsl"]
        manifest["tasks"] = [task for task in manifest["tasks"] if task["id"] in TASKS]
        (self.assignment / "assignment.json").write_text(json.dumps(manifest))
        self.submissions.mkdir()
        self.hidden.mkdir()
        (self.hidden / "hidden.json").write_text(json.dumps(HIDDEN))

    def words(self, *more: str) -> list[str]:
        return [STERADIAN, "assignment", "grade", str(self.assignment), "--submissions", str(self.submissions), "--out", str(self.out), *more]

    def grade(self, *more: str, status: int = 0) -> subprocess.CompletedProcess:
        run = subprocess.run(self.words(*more), capture_output=True, text=True, errors="replace")
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return run

    def result(self, key: str) -> dict:
        return json.loads((self.out / "results" / f"{key}.json").read_text())

    def hand_in(self, name: str, student: str = "", **changed: str) -> Path:
        folder = self.submissions / name
        folder.mkdir(parents=True)
        for file in REFERENCE.glob("*.glsl"):
            (folder / file.name).write_text(changed.get(file.stem, file.read_text()))
        if student:
            (folder / "assignment.json").write_text(json.dumps({"assignment": "a3-brdf", "student": student}))
        return folder

    def pack(self, folder: Path, archive: Path):
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
            for file in folder.iterdir():
                packed.write(file, f"{folder.name}/{file.name}")
        shutil.rmtree(folder)

    def rows(self) -> dict[str, dict[str, str]]:
        with (self.out / "marks.csv").open(newline="") as stream:
            return {row["key"]: row for row in csv.DictReader(stream)}

    def test_layouts_of_platforms(self):
        self.pack(self.hand_in("Ann Example_4711_assignsubmission_file", "a"), self.scratch / "x.zip")
        (self.submissions / "Ann Example_4711_assignsubmission_file").mkdir()
        shutil.move(self.scratch / "x.zip", self.submissions / "Ann Example_4711_assignsubmission_file" / "my-a3.zip")
        self.pack(self.hand_in("Bob", "b"), self.submissions / "Bob Übel_4712_assignsubmission_file_a3.zip")
        (self.submissions / "Eve_4713_assignsubmission_onlinetext").mkdir()
        (self.submissions / "notes.txt").write_text("x")
        run = self.grade()
        self.assertIn("onlinetext: left out", run.stderr)
        self.assertIn("notes.txt: left out", run.stderr)
        rows = self.rows()
        self.assertEqual({row["name"]: row["percent"] for row in rows.values()}, {"Ann Example": "100.0", "Bob Übel": "100.0"})
        self.assertEqual({row["student"] for row in rows.values()}, {"a", "b"})
        self.assertEqual({row["remarks"] for row in rows.values()}, {""})
        shutil.rmtree(self.submissions)
        self.hand_in("submission_17")
        self.hand_in("submission_18", "other")
        self.hand_in("submission_19", "c1")
        (self.submissions / "submission_metadata.yml").write_text(
            "---\nsubmission_17:\n  :submitters:\n  - :name: Cleo\n    :sid: 'c1'\n    :email: c@example.org\n"
            "submission_18:\n  :submitters:\n  - :name: Dan\n    :sid: d1\n  :score: 1\n")
        self.out = self.scratch / "second"
        self.grade()
        rows = self.rows()
        self.assertEqual((rows["submission_17"]["name"], rows["submission_17"]["student"]), ("Cleo", "c1"))
        self.assertIn("submission_19 of the same student", rows["submission_17"]["remarks"])
        self.assertIn("submission_17 of the same student", rows["submission_19"]["remarks"])
        self.assertIn("submission_19 of the same student", (self.out / "overview.html").read_text())
        self.assertEqual(rows["submission_18"]["student"], "d1", "the platform's id, not the label's")
        self.assertIn("d1 handed in the folder of other", rows["submission_18"]["remarks"])

    def test_what_comes_out(self):
        phong = (REFERENCE / "phong.glsl").read_text()
        self.hand_in("right", "1")
        self.hand_in("wrong", "2", phong=phong.replace("(2.0 * pi)", "2.0"))
        self.hand_in("broken", "3", phong=phong.replace("vec3 r =", "vec3 r = nothing +"))
        self.grade("--hidden", str(self.hidden), "--jobs", "2")
        rows = self.rows()
        self.assertEqual([rows[key]["A3.1"] for key in ("right", "wrong", "broken")], ["4", "1", "0"])
        self.assertEqual(rows["right"]["A3.4"], "3", "two public points and a hidden one")
        suites = ElementTree.parse(self.out / "junit.xml").getroot()
        self.assertEqual({suite.get("name"): suite.get("failures") for suite in suites}, {"right": "0", "wrong": "1", "broken": "1"})
        page = (self.out / "overview.html").read_text()
        self.assertIn("A factor 1/π is missing", page)
        self.assertIn('href="students/wrong.html#A3.1"', page)
        for outside in ("http:", "https:", "<script", "src="):
            self.assertNotIn(outside, page)
        for key in rows:
            self.assertTrue((self.out / "students" / f"{key}.html").is_file())
            scope = json.loads((self.out / "gradescope" / f"{key}.json").read_text())
            self.assertEqual(scope["score"], float(rows[key]["points"]))
            self.assertEqual(scope["score"], sum(test["score"] for test in scope["tests"]))
        self.assertIn('"file": "phong.glsl"', json.dumps(self.result("broken")))
        self.assertNotIn(str(self.scratch), json.dumps(self.result("broken")))

    def test_gradescope_has_its_documented_form_and_pictures(self):
        try:
            import jsonschema
        except ImportError:
            print("SKIPPED: the Python package jsonschema is not installed")
            os._exit(77)
        manifest = json.loads((ASSIGNMENTS / "a3-brdf" / "assignment.json").read_text())
        manifest["tasks"] = [task for task in manifest["tasks"] if task["id"] in ("A3.4", "A3.5")]
        manifest["files"] = ["microfacets.glsl"]
        (self.assignment / "assignment.json").write_text(json.dumps(manifest))
        text = (REFERENCE / "microfacets.glsl").read_text()
        wrong = text.replace("return D(dot(n, h)", "return pi * D(dot(n, h)")
        self.assertNotEqual(wrong, text)
        self.hand_in("right", "1")
        self.hand_in("wrong", "2", microfacets=wrong)
        self.hand_in("<b>", "3", microfacets=wrong.replace("vec3 F(", "<script>&vec3 F(", 1))
        self.hand_in("nothing", "4", microfacets="")
        self.grade("--hidden", str(self.hidden), "--time-limit", "200")  # sanitizers take their time
        single = self.scratch / "results.json"
        subprocess.run([STERADIAN, "assignment", "check", self.submissions / "wrong", "--assignment", self.assignment, "--student", "2", "--hidden",
                        self.hidden, "--gradescope", single, "--time-limit", "200"], stdout=subprocess.DEVNULL)
        schema = json.loads((Path(__file__).resolve().parent.parent / "assignment" / "gradescope.schema.json").read_text())
        found = {file.stem: json.loads(file.read_text()) for file in (*(self.out / "gradescope").glob("*.json"), single)}
        self.assertEqual(len(found), 5)
        for name, scope in found.items():
            jsonschema.validate(scope, schema)
            self.assertLess(len(json.dumps(scope)), 1 << 20)
            self.assertEqual(json.dumps(scope).count("<img"), 2 if name in ("wrong", "_b_", "results") else 0, name)
            for test in scope["tests"]:
                self.assertTrue("<script" not in test["output"] or test["output_format"] == "text", "code becomes markup")
        self.assertEqual(found["results"]["tests"], found["wrong"]["tests"])
        picture = next(test["output"] for test in found["wrong"]["tests"] if "<img" in test["output"])
        yours, reference = (base64.b64decode(data) for data in re.findall(r'src="data:image/png;base64,([^"]+)"', picture))
        for png in (yours, reference):
            self.assertTrue(png.startswith(b"\x89PNG"))
        self.assertNotEqual(yours, reference)

    def test_hidden_checks_show_marks_alone(self):
        text = (REFERENCE / "microfacets.glsl").read_text()
        self.hand_in("right", "1")
        self.hand_in("wrong", "2", microfacets=text.replace("* c * c * c * c * c", "* c * c * c * c"))
        self.grade("--hidden", str(self.hidden))
        checks = {key: next(t for t in self.result(key)["tasks"] if t["id"] == "A3.4")["checks"][-1] for key in ("right", "wrong")}
        self.assertEqual((checks["right"]["passed"], checks["wrong"]["passed"]), (True, False))
        self.assertEqual({checks["wrong"][part] for part in ("got", "expected", "at", "unit", "hint")}, {""})
        self.assertIsNone(checks["wrong"]["diagnosis"])
        for file in (f for f in self.out.rglob("*") if f.is_file()):
            for secret in SECRETS:
                self.assertNotIn(secret.encode(), file.read_bytes(), file)

    def test_a_run_that_was_killed_goes_on(self):
        for i in range(6):
            self.hand_in(f"s{i}", str(i))
        run = subprocess.Popen(self.words("--jobs", "1"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        results = self.out / "results"
        end = time.monotonic() + 250
        while not (results.is_dir() and len(list(results.glob("*.json"))) >= 2) and time.monotonic() < end:
            time.sleep(0.02)
        run.kill()
        run.wait()
        before = {file.name: file.stat().st_mtime_ns for file in results.glob("*.json")}
        self.assertIn(len(before), range(2, 6))
        run = subprocess.Popen(self.words("--jobs", "1"), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while len(list(results.glob("*.json"))) <= len(before) and time.monotonic() < end:
            time.sleep(0.02)
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(60), 130)
        self.assertIn("goes on from there", run.stderr.read())
        self.grade()
        after = {file.name: file.stat().st_mtime_ns for file in results.glob("*.json")}
        self.assertEqual(len(after), 6)
        self.assertEqual({name: after[name] for name in before}, before, "nothing is graded twice")
        self.assertEqual(len(self.rows()), 6)
        changed = self.submissions / "s3" / "phong.glsl"
        times = changed.stat()
        changed.write_text(changed.read_text().replace("2.0 * dot", "3.0 * dot"))
        os.utime(changed, ns=(times.st_atime_ns, times.st_mtime_ns))  # as large and as old as before
        os.utime(self.submissions / "s4" / "phong.glsl")
        self.grade()
        changed = {f.name for f in results.glob("*.json") if f.stat().st_mtime_ns != after[f.name]}
        self.assertEqual(changed, {"s3.json"}, "what has changed is graded again")

    def test_single_submissions_for_platforms(self):
        folder = self.hand_in("mine", "", phong="// nothing\n")
        check = [STERADIAN, "assignment", "check", str(folder), "--assignment", str(self.assignment), "--student", "9", "--hidden", str(self.hidden)]
        results, junit = self.scratch / "results.json", self.scratch / "junit.xml"
        run = subprocess.run([*check, "--gradescope", results, "--junit", junit, "--vpl", "20"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertTrue(all(line.startswith(("Comment :=>>", "Grade :=>>")) for line in run.stdout.splitlines()), run.stdout)
        self.assertEqual(run.stdout.splitlines()[-1].split()[0], "Grade")
        scope = json.loads(results.read_text())
        self.assertEqual([test["status"] for test in scope["tests"]].count("failed"), 1)
        self.assertEqual(ElementTree.parse(junit).getroot().get("failures"), "1")
        result = json.loads(subprocess.run([*check, "--json"], capture_output=True, text=True).stdout)
        self.assertEqual(result["student"], "9")

    def test_two_graders_do_not_meet(self):
        for i in range(3):
            self.hand_in(f"s{i}", str(i))
        first = subprocess.Popen(self.words(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(first.wait)
        self.addCleanup(first.kill)
        end = time.monotonic() + 200
        while not (self.out / ".lock").exists() and time.monotonic() < end:
            time.sleep(0.01)
        time.sleep(0.2)
        run = self.grade(status=3)
        self.assertIn("another process grades", run.stderr)
        self.assertEqual(len(run.stderr.splitlines()), 1)

    def test_a_hostile_class_is_graded_to_its_end(self):
        musts = hostile.make_all(self.submissions, REFERENCE)
        self.assertGreaterEqual(len(musts), 60)
        self.hand_in("honest", "42")
        before = sorted(str(file) for file in self.scratch.rglob("*") if "marks" not in file.parts)
        run = self.grade("--hidden", str(self.hidden), "--jobs", str(os.cpu_count()), "--time-limit", "20")
        after = sorted(str(file) for file in self.scratch.rglob("*") if "marks" not in file.parts)
        self.assertEqual(after, before, "nothing is written beside the results")
        self.assertFalse(Path("/tmp/escaped.glsl").exists())
        self.assertEqual(self.result("honest")["percent"], 100.0)
        for key, words in musts.items():
            with self.subTest(key):
                result = self.result(key)
                lines = list(result["refused"])
                for task in result["tasks"]:
                    lines += [problem["text"] for problem in task["problems"]] + [check["message"] for check in task["checks"]]
                self.assertTrue(any(words in line for line in lines), lines)
                self.assertFalse(any("\n" in line or "\x1b" in line for line in lines), lines)
                self.assertNotIn("root:", json.dumps(result), "no other file is read")
        self.tell_of_code(musts)
        self.tell_of_outputs()
        for line in run.stdout.splitlines() + run.stderr.splitlines():
            self.assertNotIn("\x1b", line)

    def test_a_class_of_odd_forms_is_graded_to_its_end(self):
        musts = hostile_forms.make_all(self.submissions, REFERENCE)
        self.addCleanup((self.submissions / "closed").chmod, 0o700)
        self.assertGreaterEqual(len(musts), 60)
        self.grade("--hidden", str(self.hidden), "--jobs", str(os.cpu_count()))
        for key, words in musts.items():
            with self.subTest(key):
                result = self.result(key)
                lines = list(result["refused"])
                for task in result["tasks"]:
                    lines += [problem["text"] for problem in task["problems"]] + [check["message"] for check in task["checks"]]
                self.assertTrue(any(words in line for line in [*lines, ""]), lines)
                self.assertFalse(any("\n" in line or "\x1b" in line for line in lines), lines)
                ends = [task["id"] for task in result["tasks"] if task.get("ended_early")]
                # The driver divides by a processor's instruction, which traps.
                self.assertTrue(not ends or (key == "least_over_minus_one" and ends == ["A3.4"]), ends)
                if key in hostile_forms.RIGHT:
                    self.assertEqual(result["percent"], 100.0, lines)
        self.tell_of_outputs()
        for file in (f for f in self.out.rglob("*") if f.is_file()):
            text = file.read_bytes()
            self.assertNotIn(str(self.scratch).encode(), text, file)
            self.assertNotIn(b"<script>alert", text, file)

    def tell_of_code(self, musts: dict[str, str]):
        """What is wrong in A3.4 costs nothing elsewhere, and no code ends its process."""
        for key in (*hostile.BODIES, *hostile.HEADS):
            tasks = {task["id"]: task for task in self.result(key)["tasks"]}
            with self.subTest(key):
                self.assertFalse(any(task.get("ended_early") for task in tasks.values()), "a process ended")
                if key != "comment_without_end" and key not in ("answer_written", "hidden_answer", "leaves_the_function"):
                    self.assertLess(tasks["A3.4"]["points"], tasks["A3.4"]["of"])
                self.assertEqual(tasks["A3.1"]["status"], "passed")
                if "was stopped" in musts[key]:
                    self.assertEqual(tasks["A3.4"]["status"], "failed")
                    self.assertIn("microfacets.glsl:", tasks["A3.4"]["checks"][0]["message"])

    def tell_of_outputs(self):
        page = (self.out / "overview.html").read_text()
        for markup in ("<img", "<script", "javascript:"):
            self.assertNotIn(markup, page)
        for row in self.rows().values():
            for cell in row.values():
                self.assertNotIn(cell[:1], ("=", "+", "-", "@", "＝"), cell)
        for file in (f for f in self.out.rglob("*") if f.is_file()):
            for secret in SECRETS:
                self.assertNotIn(secret.encode(), file.read_bytes(), file)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], f"Class.test_{sys.argv[3]}"])
