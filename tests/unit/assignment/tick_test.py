#!/usr/bin/env python3
"""The answers of `assignment tick` hold when each change is really made: a line replaced in the student's file and checked, a number
changed in the scene and rendered, a pixel probed.

usage: tick_test.py STERADIAN ASSIGNMENTS_FOLDER SCRATCH_FOLDER [ASSIGNMENT...]
One assignment and one of its mistakes. With STERADIAN_TICK=all every assignment and every mistake, 353 in all (some hours); with
STERADIAN_TICK=N every assignment and N of its mistakes, evenly spread over its tasks.
"""
import functools
import json
import os
import re
import shutil
import subprocess
import sys
import traceback
from pathlib import Path

STERADIAN, ASSIGNMENTS, SCRATCH = (Path(argument).resolve() for argument in sys.argv[1:4])
STUDENT = "12345"


def steradian(*arguments, statuses=(0,)):
    run = subprocess.run([STERADIAN, *map(str, arguments)], capture_output=True, text=True, timeout=3600)
    assert run.returncode in statuses, (arguments, run.returncode, run.stdout, run.stderr)
    return run.stdout


def variants(assignment: str):
    """(task, name, code) of each mistake."""
    for file in sorted((ASSIGNMENTS / assignment / "variants").glob("*.glsl")):
        parts = re.split(r"^// (mistake|solution) (\w+)\s*$", file.read_text(), flags=re.M)
        for kind, name, code in zip(parts[1::3], parts[2::3], parts[3::3]):
            if kind == "mistake":
                yield file.stem, name, code


def make_folder(assignment: str, name: str, task="", code="") -> Path:
    """A student's folder with the reference's files, and the mistake in its region."""
    folder = SCRATCH / f"{assignment}-{name}"
    steradian("assignment", "new", assignment, folder, "--student", STUDENT)
    for file in (ASSIGNMENTS / assignment / "shaders").glob("*.glsl"):
        text = file.read_text()
        if task:
            text = re.sub(rf"(// begin solution {re.escape(task)}\b[^\n]*\n).*?(^// end)", lambda m: m[1] + code.strip("\n") + "\n" + m[2],
                          text, flags=re.M | re.S)
        (folder / file.name).write_text(text)
    return folder


def with_line(folder: Path, line: dict) -> Path:
    """A copy of the folder in which a line is replaced."""
    changed = folder.with_name(folder.name + "-changed")
    shutil.rmtree(changed, ignore_errors=True)
    shutil.copytree(folder, changed)
    lines = (changed / line["file"]).read_text().split("\n")
    old = lines[line["line"] - 1]
    assert line["from"] in old.strip(), (line, old)
    lines[line["line"] - 1] = old.replace(line["from"], line["to"])
    (changed / line["file"]).write_text("\n".join(lines))
    return changed


def marks_of(folder: Path) -> dict:
    return json.loads(steradian("assignment", "check", folder, "--json", "--time-limit", "600", statuses=(0, 1)))


marks_of_unchanged = functools.cache(marks_of)


def checks(marks: dict, task: str) -> dict:
    found = next(t for t in marks["tasks"] if t["id"] == task)
    return {check["name"]: check["passed"] for check in found["checks"]}


def render(folder: Path, scene: Path, facts: dict, output: Path, own_shaders=True):
    """A picture as `render` makes it, which knows nothing of the sheet."""
    name = json.loads((folder / "assignment.json").read_text())["assignment"]
    shaders = [folder if own_shaders else ASSIGNMENTS / name / "shaders", ASSIGNMENTS / name / "overlay"]
    words = [word for path in shaders if path.is_dir() for word in ("--shaders", path)]
    if not own_shaders and (folder / "parameters.glsl").exists():
        parameters = SCRATCH / "parameters"
        parameters.mkdir(exist_ok=True)
        shutil.copy(folder / "parameters.glsl", parameters)
        words += ["--shaders", parameters]
    steradian("render", scene, "-o", output, "--size", "{}x{}".format(*facts["size"]), "--samples", facts["samples"], "--visibility",
              facts["visibility"], "--camera", "0", "--rig", "none", *words)


def mean(picture: Path) -> float:
    stats = subprocess.run(["oiiotool", picture, "--ch", "R,G,B", "--printstats"], capture_output=True, text=True).stdout
    red, green, blue = map(float, re.search(r"Stats Avg: +(\S+) (\S+) (\S+)", stats).groups())
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def pixel(picture: Path, place) -> list:
    text = subprocess.run(["oiiotool", picture, "--ch", "R,G,B", "--cut", "1x1+{}+{}".format(*place), "--printstats"],
                          capture_output=True, text=True).stdout
    return list(map(float, re.search(r"Stats Avg: +(\S+) (\S+) (\S+)", text).groups()))


def near(a: float, b: float, absolute=1e-4) -> bool:
    return abs(a - b) <= 2e-3 * max(abs(a), abs(b)) + absolute


def prove_pixel(folder: Path, facts: dict):
    """The picture has the probe's L_o at the pixel, and each deciding line changes it."""
    scene, picture = next((folder / "scenes").glob("*.gltf")), SCRATCH / "pixel.exr"
    render(folder, scene, facts, picture)
    own = pixel(picture, facts["pixel"])
    L_o = facts["terms"]["L_o"]
    absolute = max(1e-3 * max(L_o), 1e-6)  # [cd/m²]: the picture's mean is about 1, and rounding leaves 1e-24 in its shadows
    assert all(near(a, b, absolute) for a, b in zip(own, L_o)), (own, L_o)
    lights = facts["terms"]["lights"]
    if "light" in facts:
        dark = lights[facts["light"]]
        assert max(map(abs, dark["L_r"])) <= absolute, dark
    for line in facts["lines"]:
        render(with_line(folder, line), scene, facts, picture)
        changed = pixel(picture, facts["pixel"])
        # Of one light alone the change is known; the other lights may change as well.
        assert not all(near(a, b, 0) for a, b in zip(changed, own)), (line, own, changed)
        if len(lights) < 2 or "light" not in facts:
            assert all(near(a, b, absolute) for a, b in zip(changed, line["value"])), (changed, line)


def prove_parameter(folder: Path, facts: dict):
    """The pictures of `render`, before and after, have the means and the pixel of the answer."""
    scene = next((folder / "scenes").glob("*.gltf"))
    changed, after = scene.with_name("changed.gltf"), folder
    gltf = json.loads(scene.read_text())
    if facts["pointer"]:
        *path, last = [int(p) if p.isdigit() else p for p in facts["pointer"].split("/")[1:]]
        part = gltf
        for key in path:
            part = part[key]
        if facts["from"] is not None:
            assert part[last] == facts["from"], (part[last], facts)
        part[last] = facts["to"]
    else:
        after = folder.with_name(folder.name + "-changed")
        shutil.rmtree(after, ignore_errors=True)
        shutil.copytree(folder, after)
        text = (after / "parameters.glsl").read_text()
        text, count = re.subn(rf"(\b{facts['parameter']} = )[^;]+;", lambda m: f"{m[1]}{float(facts['to'])!r};", text)
        assert count == 1, text
        (after / "parameters.glsl").write_text(text)
    changed.write_text(json.dumps(gltf))
    for own, numbers in ((True, facts["yours"]), (False, facts["reference"])):
        for source, place, prefix in ((folder, scene, "before"), (after, changed, "after")):
            picture = SCRATCH / f"{prefix}.exr"
            render(source, place, facts, picture, own)
            assert near(mean(picture), numbers[f"mean_{prefix}"]), (prefix, own, mean(picture), numbers)
            at = pixel(picture, numbers["pixel"])
            scale = max(map(abs, numbers["before"] + numbers["after"]))  # one of the two may be nearly 0
            assert all(near(a, b, 1e-3 * scale) for a, b in zip(at, numbers[prefix])), (prefix, at, numbers)
    changed.unlink()


def prove_law(folder: Path, task: str, facts: dict):
    before = checks(marks_of_unchanged(folder), task)
    assert before[facts["check"]] == facts["holds"], (before, facts)
    if facts["line"]:
        assert not checks(marks_of(with_line(folder, facts["line"])), task)[facts["check"]], facts


def prove_replacement(folder: Path, task: str, facts: dict):
    before, after = checks(marks_of_unchanged(folder), task), checks(marks_of(with_line(folder, facts["line"])), task)
    broken = [name for name, passed in after.items() if not passed and before.get(name)]
    assert sorted(broken) == sorted(facts["breaks"]), (broken, facts)
    assert sorted(name for name, passed in after.items() if passed) == sorted(facts["holds"]), (after, facts)


def prove(folder: Path, seed: str):
    sheet = folder.with_suffix(".html")
    ask = lambda: json.loads(steradian("assignment", "tick", folder, "--json", "-o", sheet, "--seed", seed, "--time-limit", "600"))
    examination = ask()  # a busy machine must not end it
    again = ask() if seed == "again" else examination
    assert examination == again, "the same seed asks other questions"
    kinds = [question["kind"] for question in examination["questions"]]
    for question in examination["questions"]:
        task, facts = question["task"], question["facts"]
        {"pixel": lambda: prove_pixel(folder, facts), "parameter": lambda: prove_parameter(folder, facts),
         "law": lambda: prove_law(folder, task, facts), "replacement": lambda: prove_replacement(folder, task, facts)}[question["kind"]]()
    text = sheet.read_text()
    assert "<script" not in text and "http" not in text.replace("http-equiv", ""), "the page needs something from outside"
    print(folder.name, seed, kinds, examination["missing"], flush=True)
    return kinds, examination["missing"]


def attempt(failures: list, folder: Path, seed: str):
    """Proves a folder's sheet; a failure is noted, and the others are still tried."""
    try:
        return prove(folder, seed)
    except Exception:  # whatever it is, it is this sheet that does not hold
        failures.append(f"{folder.name}: {traceback.format_exc()}")
        print(failures[-1], flush=True)


def main():
    if not shutil.which("oiiotool"):
        print("SKIPPED: oiiotool is not installed")
        sys.exit(77)
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    wanted = os.environ.get("STERADIAN_TICK", "")
    is_whole = wanted == "all" or wanted.isdigit()
    names = sys.argv[4:] or ([p.name for p in sorted(ASSIGNMENTS.glob("a*-*"))] if is_whole else ["a2-diffuse"])
    failures = []
    for name in names:
        whole_sheet = (["pixel", "parameter", "law", "replacement"], [])
        found = attempt(failures, make_folder(name, "reference"), "again" if not is_whole else STUDENT)
        if found and found != whole_sheet:
            failures.append(f"{name}-reference: {found}")
        mistakes = list(variants(name))
        step = 1 if wanted == "all" else max(1, len(mistakes) // int(wanted)) if is_whole else len(mistakes)
        for task, mistake, code in mistakes[::step]:
            attempt(failures, make_folder(name, f"{task}-{mistake}", task, code), mistake)
    for failure in failures:
        print("FAILED:", failure)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
