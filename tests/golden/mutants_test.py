#!/usr/bin/env python3
"""Our suite under a renderer with a mistake, made by a shader overlay: it must fail, and say why.

usage: mutants_test.py STERADIAN SOURCE_FOLDER SCRATCH_FOLDER MISTAKE
"""
import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

SRGB = """vec3 srgb(vec3 v) {
    return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, greaterThan(v, vec3(0.0031308)));
}

void main() {"""

# The shader, what is replaced in it; how many of the tests fail at least; the diagnosis, and how often it is given at
# least: a missing term where the golden has a channel of it, a light that is off where it was the only one or has a layer.
MISTAKES = {
    "pi_missing": ("brdf/lambert.glsl", {"return albedo / pi;": "return albedo;"}, 18, "pi_missing", 5),
    "cosine_missing": ("integrator/integrand.glsl", {" * cos_i, x,": ", x,"}, 17, "cosine_missing", 3),
    "srgb_twice": ("forward.frag", {"void main() {": SRGB, "outgoing(x, direction_to_viewer());": "srgb(outgoing(x, direction_to_viewer()));"},
                   18, "srgb_applied", 5),
    # The zoo's other booths are walled off from its last light.
    "light_off": ("integrator/reflected.glsl", {"k < end_light;": "k < end_light - 1;"}, 14, "black", 4),
    "shadow_off": ("visibility/visibility.glsl", {'#include "visibility/none.glsl"': '#include "visibility/none.glsl"\n'}, 10, "shadows_missing", 2),
}

# Those that take longest tell nothing that others do not.
FILTERS = [word for pattern in ("plane*", "cornell*", "spheres", "veach", "zoo*") for word in ("--filter", pattern)]


def make_overlay(source, folder, shader, replacements):
    text = (source / "shaders" / shader).read_text(encoding="utf-8")
    for right, wrong in replacements.items():
        assert text.count(right) == 1, f"{shader} has no line with {right} any more: mend this test"
        text = text.replace(right, wrong)
    (folder / shader).parent.mkdir(parents=True, exist_ok=True)
    (folder / shader).write_text(text, encoding="utf-8")


def main():
    program, source, scratch, mistake = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]) / sys.argv[4], sys.argv[4]
    shader, replacements, failing, name, count = MISTAKES[mistake]
    make_overlay(source, scratch / "shaders", shader, replacements)
    result = subprocess.run([program, "golden", "run", source / "tests/golden/suite.json", "-o", scratch / "out",
                             "--jobs", "2", "--shaders", scratch / "shaders", *FILTERS], capture_output=True, text=True)
    print(result.stdout + result.stderr)
    assert result.returncode == 1, f"exit status {result.returncode}"
    tests = json.loads((scratch / "out/results.json").read_text())["tests"]
    outcomes = Counter(test["outcome"] for test in tests)
    assert outcomes["broken"] == 0 and outcomes["missing"] == 0, outcomes
    diagnoses = Counter((test["comparison"]["diagnosis"] or {"name": "none"})["name"] for test in tests)
    print(f"{mistake}: {outcomes['differs']} of {len(tests)} fail, diagnosed as {dict(diagnoses)}")
    assert outcomes["differs"] >= failing, outcomes
    assert diagnoses[name] >= count, diagnoses
    assert mistake != "light_off" or diagnoses["light_missing"] == 1, "zoo has a layer for each light"
    assert name == "pi_missing" or diagnoses["pi_missing"] == 0, "another mistake was taken for a missing π"


if __name__ == "__main__":
    main()
