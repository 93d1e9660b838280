#!/usr/bin/env python3
"""The mutants before other comparators: idiff (OpenImageIO) and the FLIP package alone.

    python3 -m venv venv && venv/bin/pip install flip-evaluator==1.7 tifffile
    build/golden_mutants /tmp/mutants > /tmp/mutants.json
    venv/bin/python tools/golden/others.py /tmp/mutants /tmp/mutants.json

Prints the Markdown table of src/compare/README.md and the counts under it. Development only. Each tool gets a fair
setting: idiff the relative tolerance and share of pixels that `steradian compare` has by default, FLIP a mean of
0.01, with its own exposures for images of light. A mutant whose verdict rests on an option that the other tool
lacks (noise, region, mask, other limits) is judged without it, marked *.
"""
import json
import math
import subprocess
import sys
from pathlib import Path

import flip_evaluator
import numpy as np
import tifffile

FLIP_LIMIT = 0.01
NEEDS_AN_OPTION = ("noise", "wrong_outside_region", "wrong_inside_region", "wrong_behind_mask", "scattered",
                   "clustered", "nan_in_both_allowed", "all_nan_allowed")


def rgb(file):
    """R, G and B of an EXR as an array, or None if it has no such channels."""
    plain = "/tmp/rgb.tif"
    ran = subprocess.run(["oiiotool", file, "--ch", "R,G,B", "-d", "float", "--compression", "none", "-o", plain],
                         capture_output=True, text=True, check=False)
    return None if "Unknown channel" in ran.stdout + ran.stderr else tifffile.imread(plain).astype(np.float32)


def idiff_passes(folder, name):
    """Whether idiff accepts 0.1 % of the pixels beyond 1 % relative, of the picture without its layers."""
    files = []
    for role in ("test", "reference"):
        source, picture = f"{folder}/{name}.{role}.exr", f"/tmp/idiff_{role}.exr"
        info = subprocess.run(["oiiotool", "--info", "-v", source], capture_output=True, text=True, check=False).stdout
        channels = "R,G,B,A" if "R, G, B" in info or "A, B, G, R" in info else "Y"
        subprocess.run(["oiiotool", source, "--ch", channels, "-o", picture], check=False, capture_output=True)
        files.append(picture)
    ran = subprocess.run(["idiff", "-failrelative", "0.01", "-failpercent", "0.1", "-warn", "1e9", *files],
                         capture_output=True, text=True, check=False)
    return ran.returncode in (0, 1)  # 1 warns


def flip_mean(folder, name, are_codes):
    test, reference = rgb(f"{folder}/{name}.test.exr"), rgb(f"{folder}/{name}.reference.exr")
    if test is None or reference is None or test.shape != reference.shape:
        return math.inf
    kind = "LDR" if are_codes else "HDR"
    return float(flip_evaluator.evaluate(reference, np.maximum(test, 0), kind, applyMagma=False)[1])


def word(passes):
    return "pass" if passes else "fail"


def cell(passes, wanted):
    return word(passes) if passes == wanted else f"**{word(passes)}**"


def main():
    folder, rows = sys.argv[1], json.loads(Path(sys.argv[2]).read_text())
    wrong = {"idiff": [], "FLIP": []}
    print("| mutant | must | steradian | cause | idiff | FLIP |\n|---|---|---|---|---|---|")
    for row in rows:
        name, wanted = row["name"], row["passes"]
        idiff = idiff_passes(folder, name)
        mean = flip_mean(folder, name, row["are_codes"])
        flip = not mean > FLIP_LIMIT  # a NaN passes, as in any script that asks whether the limit is exceeded
        star = "*" if name.startswith(NEEDS_AN_OPTION) else ""
        cause = row["diagnosis"] + (f" ({row['layer']})" if row["layer"] else "")
        if not star:
            wrong["idiff"] += [name] if idiff != wanted else []
            wrong["FLIP"] += [name] if flip != wanted else []
        print(f"| {name}{star} | {word(wanted)} | {cell(row['steradian'], wanted)} | {cause} | "
              f"{cell(idiff, wanted)} | {cell(flip, wanted)} {mean:.3f} |")
    judged = sum(not row["name"].startswith(NEEDS_AN_OPTION) for row in rows)
    ours = sum(row["passes"] != row["steradian"] for row in rows)
    print(f"\nWrong verdicts: steradian {ours} of {len(rows)}; of the {judged} without a star "
          f"idiff {len(wrong['idiff'])}, FLIP {len(wrong['FLIP'])}.")
    for tool, names in wrong.items():
        print(f"{tool}: {', '.join(names)}")


if __name__ == "__main__":
    main()
