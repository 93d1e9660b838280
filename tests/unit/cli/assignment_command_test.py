#!/usr/bin/env python3
"""`steradian assignment` as a student meets it.

usage: assignment_command_test.py STERADIAN ASSIGNMENTS_FOLDER TEST_NAME     (a method of Student below)
"""
import json
import re
import subprocess
import sys
import tempfile
import unittest
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
        self.assertEqual(len(re.findall(r"return not_implemented\(\)", text)), 5)
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
        self.assertEqual({id for id, task in result.items() if id != "percent" and task["status"] != "passed"}, {"A3.2"})

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
        self.edit("phong.glsl", "vec3 r =", "float s = 0.0;\n    for (int i = 0; i < 60000; ++i) s += sin(s + float(i) * k);\n"
                                            "    if (s == 12345.0) return s;\n    vec3 r =")
        result = self.checked(1, "--time-limit", "0.5")
        self.assertEqual(result["A3.1"]["status"], "broken")
        self.assertIn("longer than 0.5 s", result["A3.1"]["problems"][0]["text"])

    def test_what_is_no_students_folder_is_one_line(self):
        for words in (["check", self.scratch.name], ["new", "a9", self.scratch.name + "/x"], ["new", "a3", str(self.folder)]):
            run = self.run_steradian(*words, status=3)
            self.assertEqual(run.stdout, "")
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], f"Student.test_{sys.argv[3]}"])
