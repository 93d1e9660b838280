#!/usr/bin/env python3
"""`steradian assignment` as a student meets it.

usage: assignment_command_test.py STERADIAN ASSIGNMENTS_FOLDER TEST_NAME     (a method of Student below)
"""
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
import zipfile
from pathlib import Path

STERADIAN, ASSIGNMENTS = sys.argv[1], Path(sys.argv[2])


def reference(file: str) -> str:
    return (ASSIGNMENTS / "a3-brdf" / "shaders" / file).read_text()


class Student(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name, "my-a3")
        self.run_steradian("new", "a3", str(self.folder), "--student", "12345", status=0)

    def run_steradian(self, *words: str, status: int) -> subprocess.CompletedProcess:
        run = subprocess.run([STERADIAN, "assignment", *words], capture_output=True, text=True)
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return run

    def checked(self, status: int, *words: str) -> dict:
        result = json.loads(self.run_steradian("check", str(self.folder), "--json", *words, status=status).stdout)
        return {task["id"]: task for task in result["tasks"]} | {"percent": result["percent"]}

    def write_solution(self):
        for file in ("phong.glsl", "microfacets.glsl"):
            (self.folder / file).write_text(reference(file))

    def edit(self, file: str, old: str, new: str):
        text = (self.folder / file).read_text()
        self.assertIn(old, text)
        (self.folder / file).write_text(text.replace(old, new, 1))

    def test_nothing_written_is_nothing_earned(self):
        result = self.checked(1)
        self.assertEqual(result.pop("percent"), 0)
        self.assertEqual({task["status"] for task in result.values()}, {"not implemented"})

    def test_the_folder_gives_nothing_away(self):
        text = "".join(file.read_text() for file in self.folder.glob("*.glsl"))
        self.assertNotIn("solution", text)
        self.assertEqual(len(re.findall(r"return not_implemented\(\)", text)), 9)
        self.assertTrue((self.folder / "README.md").is_file())
        self.assertIn("*.glsl", (self.folder / ".vscode" / "settings.json").read_text())

    def test_scenes_have_the_students_numbers(self):
        folder = Path(self.scratch.name, "my-a5")
        self.run_steradian("new", "a5", str(folder), "--student", "12345", status=0)
        width = re.search(r"lamp_width = ([0-9.]+);", (folder / "parameters.glsl").read_text())[1]
        scene = json.loads((folder / "scenes" / "lamps.gltf").read_text())
        lamp = next(node for node in scene["nodes"] if node["name"] == "lamp")
        self.assertEqual(lamp["extras"]["steradian"]["width"], float(width))

    def test_a_solution_gets_everything(self):
        self.write_solution()
        self.assertEqual(self.checked(0)["percent"], 100)

    def test_a_mistake_costs_its_own_task_alone(self):
        self.write_solution()
        self.edit("microfacets.glsl", "a2 / (pi * d * d)", "a2 / (d * d)")
        result = self.checked(1)
        self.assertEqual(result["A3.2"]["checks"][0]["diagnosis"]["name"], "pi_missing")
        not_passed = {id: task["status"] for id, task in result.items() if id != "percent" and task["status"] != "passed"}
        extra = {"A3.6": "not implemented", "A3.7": "not implemented"}  # which write_solution() leaves alone
        self.assertEqual(not_passed, {"A3.2": "failed"} | extra)

    def test_a_factor_that_nobody_listed_is_named(self):
        self.write_solution()
        self.edit("microfacets.glsl", "return F0 + (1.0 - F0) * c", "return 2.0 * F0 + (1.0 - F0) * 2.0 * c")
        self.assertIn("× 2", self.checked(1)["A3.4"]["checks"][0]["diagnosis"]["text"])

    def test_an_error_stands_at_the_students_line(self):
        self.write_solution()
        self.edit("microfacets.glsl", "float a2 = alpha * alpha;", "float a2 = alpha * alpa;")
        result = self.checked(1)
        problem = result["A3.2"]["problems"][0]
        line = (self.folder / "microfacets.glsl").read_text().splitlines()[problem["line"] - 1]
        self.assertEqual((line, problem["source"]), (problem["source"], "    float a2 = alpha * alpa;"))
        self.assertEqual(Path(problem["file"]).name, "microfacets.glsl")
        self.assertIn("not declared", problem["hint"])
        self.assertEqual(result["A3.3"]["status"], "passed")

    def test_a_terminal_gets_no_commands_from_a_students_line(self):
        self.write_solution()
        self.edit("microfacets.glsl", "float a2 = alpha * alpha;", "float a2 = alpha * alpa; // \x1b[2J")
        text = self.run_steradian("check", str(self.folder), status=1).stdout
        self.assertIn("alpa; // \\x1b[2J", text)
        self.assertNotIn("\x1b", text)

    def test_a_bracket_that_is_open_is_found(self):
        self.write_solution()
        self.edit("microfacets.glsl", "    return a2 / (pi * d * d);\n}", "    if (d > 0.0) {\n    return a2 / (pi * d * d);\n}")
        result = self.checked(1)
        self.assertEqual(result["A3.2"]["status"], "broken")
        self.assertEqual(result["A3.3"]["status"], "passed")

    def test_a_marker_that_is_gone_is_told(self):
        self.write_solution()
        self.edit("phong.glsl", "// begin solution A3.1", "// here")
        result = self.checked(1)
        self.assertIn("// begin A3.1", result["A3.1"]["problems"][0]["text"])
        self.assertEqual(result["A3.5"]["status"], "passed")

    def test_directives_that_do_not_belong_there_cost_their_own_task(self):
        self.write_solution()
        for line in ('#include "/etc/passwd"', '#include "../secret.glsl"', '#include "none.glsl"',
                     '#include "microfacets.glsl"', "#version 410", "/* without an end"):
            with self.subTest(line):
                self.write_solution()
                self.edit("microfacets.glsl", "float D(", line + "\nfloat D(")
                result = self.checked(1)
                self.assertEqual(result["A3.2"]["status"], "broken")
                self.assertIn("microfacets.glsl:", json.dumps(result["A3.2"]["problems"]))
                self.assertEqual(result["A3.3"]["status"], "passed")

    def test_work_without_an_end_costs_its_own_task_alone(self):
        self.write_solution()
        self.edit("phong.glsl", "vec3 r =", "float s = 0.0;\n    for (int i = 0; i < 32000; ++i)\n"
                                            "        s += sin(s + float(i) * k) + exp(cos(s)) + pow(sin(2.0 * s), 2.0) + atan(s, exp(sin(3.0 * s)));\n"
                                            "    if (s == 12345.0) return s;\n    vec3 r =")
        result = self.checked(1, "--time-limit", "0.5")
        self.assertEqual(result["A3.1"]["status"], "broken")
        self.assertIn("longer than 0.5 s", result["A3.1"]["problems"][0]["text"])

    def test_a_loop_that_is_stopped_fails_its_checks_at_its_line(self):
        self.write_solution()
        self.edit("microfacets.glsl", "    vec3 h = normalize(wi + wo);\n", "    vec3 h = normalize(wi + wo);\n    if (alpha > 0.0) while (true) h += wi;\n")
        line = (self.folder / "microfacets.glsl").read_text().split("while (true)")[0].count("\n") + 1
        task = self.checked(1)["A3.5"]
        self.assertEqual((task["status"], task["points"], task["problems"]), ("failed", 0, []))
        self.assertEqual([check["name"] for check in task["checks"]], ["values", "reciprocity", "picture"])
        for check in task["checks"]:
            self.assertIn(f"microfacets.glsl:{line}: this loop was stopped", check["message"])

    def test_long_loops_that_end_are_right(self):
        self.write_solution()
        self.edit("phong.glsl", "vec3 r =", "float one = 0.0;\n    for (int i = 0; i < 32000; ++i) one += 1.0 / 32000.0;\n    vec3 r = floor(one + 0.5) *")
        self.assertEqual(self.checked(0)["A3.1"]["status"], "passed")

    def test_what_is_no_students_folder_is_one_line(self):
        for words in (["check", self.scratch.name], ["new", "a9", self.scratch.name + "/x"], ["new", "a3", str(self.folder)]):
            run = self.run_steradian(*words, status=3)
            self.assertEqual(run.stdout, "")
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)

    def test_a_report_stands_alone(self):
        self.write_solution()
        self.edit("phong.glsl", "// begin solution A3.1", "// </script><b>&")
        page = Path(self.scratch.name, "report.html")
        result = self.checked(1, "--report", str(page))
        self.assertNotIn("pictures", json.dumps(result))
        html = page.read_text()
        self.assertEqual(html.count("</script>"), 2)
        for outside in ("http:", "https:", 'src="', "<b>"):
            self.assertNotIn(outside, html)

    def test_watching_checks_again_on_save(self):
        log = Path(self.scratch.name, "log")
        with log.open("w") as stream:
            watch = subprocess.Popen([STERADIAN, "assignment", "check", str(self.folder), "--watch", "--json"], stdout=stream,
                                     stderr=subprocess.DEVNULL)
        self.addCleanup(watch.kill)
        self.wait_for(lambda: log.read_text().count("\n") == 1)
        self.write_solution()
        self.wait_for(lambda: log.read_text().count("\n") >= 2 and self.last_percent(log) == 100)
        watch.send_signal(signal.SIGINT)
        self.assertEqual(watch.wait(10), 0)

    def last_percent(self, log: Path) -> float:
        return json.loads(log.read_text().splitlines()[-1])["percent"]

    def wait_for(self, condition):
        end = time.monotonic() + 200
        while not condition():
            self.assertLess(time.monotonic(), end, "it does not happen")
            time.sleep(0.05)

    def packed(self) -> Path:
        archive = Path(self.scratch.name, "mine.zip")
        run = self.run_steradian("pack", str(self.folder), "-o", str(archive), status=0)
        self.assertIn("of 17 points", run.stdout)
        return archive

    def test_a_packed_folder_is_worth_what_the_folder_is(self):
        self.write_solution()
        archive = self.packed()
        with zipfile.ZipFile(archive) as packed:
            self.assertEqual(set(packed.namelist()), {"assignment.json", "phong.glsl", "microfacets.glsl", "extra.glsl", "result.json"})
            self.assertEqual(json.loads(packed.read("result.json"))["points"], 17)
        again = archive.read_bytes()
        self.assertEqual(self.packed().read_bytes(), again)
        self.folder = archive
        self.assertEqual(self.checked(0)["percent"], 100)
        with zipfile.ZipFile(archive, "w") as packed:  # as a file manager packs the folder
            for file in ("phong.glsl", "microfacets.glsl"):
                packed.writestr("my-a3/" + file, reference(file))
            packed.writestr("my-a3/assignment.json", json.dumps({"assignment": "a3-brdf", "student": "7"}))
        self.assertEqual(self.checked(0)["percent"], 100)

    def test_archives_do_no_harm(self):
        self.folder = Path(self.scratch.name, "bad.zip")
        label = json.dumps({"assignment": "a3-brdf", "student": "7"})
        with zipfile.ZipFile(self.folder, "w", zipfile.ZIP_DEFLATED) as packed:
            packed.writestr("assignment.json", label)
            packed.writestr("../escaped.glsl", "x")
            packed.writestr("phong.glsl", bytes(1 << 25))
            packed.writestr("microfacets.glsl", reference("microfacets.glsl"))
        result = self.checked(1)
        self.assertIn("larger than 1 MiB", result["A3.1"]["problems"][0]["text"])
        self.assertEqual(result["A3.2"]["status"], "passed")
        self.assertFalse(Path(self.scratch.name).parent.joinpath("escaped.glsl").exists())
        whole = self.folder.read_bytes()
        for bytes_of_archive in (b"PK no archive", whole[:200], b""):
            self.folder.write_bytes(bytes_of_archive)
            run = self.run_steradian("check", str(self.folder), status=3)
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)

    def test_a_label_names_no_other_place(self):
        shutil.copytree(ASSIGNMENTS / "a3-brdf", Path(self.scratch.name, "a3-brdf"))
        for name in (str(Path(self.scratch.name, "a3-brdf")), "../a3-brdf", "."):
            (self.folder / "assignment.json").write_text(json.dumps({"assignment": name, "student": "7"}))
            run = self.run_steradian("check", str(self.folder), status=3)
            self.assertIn("no assignment", run.stderr)

    def test_the_id_changes_checks_handout_and_scene(self):
        """Another student's numbers are wrong in one's own folder."""
        own = Path(self.scratch.name, "assignments", "b1-wall")
        (own / "shaders").mkdir(parents=True)
        (own / "variants").mkdir()
        (own / "scenes").mkdir()
        (own / "assignment.json").write_text(json.dumps({
            "title": "t", "summary": "s", "files": ["wall.glsl"],
            "parameters": {"rho": {"from": 0.1, "to": 0.9, "decimals": 3, "unit": "1", "about": "albedo"}},
            "tasks": [{"id": "B1.1", "title": "f_r", "functions": ["f_wall"], "hints": {}, "checks": [
                {"name": "values", "points": 1, "unit": "1/sr", "value": "f_wall(x)", "inputs": [{"x": {"from": 0, "to": 1}}]}]}]}))
        (own / "shaders" / "wall.glsl").write_text(
            '#include "parameters.glsl"\n#include "assignment/not_implemented.glsl"\n// begin solution B1.1\n// f_r\n'
            "float f_wall(float x) {\n    return rho * x / 3.14159265;\n}\n// end\n")
        (own / "README.md").write_text("Your wall has ρ = {{rho}}.\n")
        (own / "scenes" / "wall.gltf").write_text('{"asset": {"version": "2.0"}, "extras": {"rho": "{{rho}}"}}')
        environment = dict(os.environ, STERADIAN_ASSIGNMENTS=str(own.parent))
        seen = {}
        for student in ("ann", "bob", "ann"):
            folder = Path(self.scratch.name, f"{student}-{len(seen)}")
            subprocess.run([STERADIAN, "assignment", "new", "b1", folder, "--student", student], env=environment, check=True)
            rho = json.loads((folder / "scenes" / "wall.gltf").read_text())["extras"]["rho"]
            self.assertIn(f"ρ = {rho}.", (folder / "README.md").read_text())
            self.assertEqual(seen.setdefault(student, rho), rho)
            for number, status in ((rho, 0), (rho + 0.01, 1)):
                text = (own / "shaders" / "wall.glsl").read_text().replace("rho * x", f"{number} * x")
                (folder / "wall.glsl").write_text(text)
                check = subprocess.run([STERADIAN, "assignment", "check", folder], env=environment, capture_output=True, text=True)
                self.assertEqual(check.returncode, status, check.stdout + check.stderr)
        self.assertNotEqual(seen["ann"], seen["bob"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], f"Student.test_{sys.argv[3]}"])
