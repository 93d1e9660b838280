#!/usr/bin/env python3
"""The mutants before other comparators: idiff (OpenImageIO), pixelmatch, odiff and FLIP.

    build/golden_mutants /tmp/mutants > /tmp/mutants.json              # the small picture's
    build/golden_mutants /tmp/mutants 256x256 > /tmp/mutants.json      # those of the three bases, at any sizes
    tools/golden/others.py /tmp/mutants /tmp/mutants.json

Prints the Markdown table of src/compare/README.md and the counts under it. What the other tools measure is
kept in FOLDER/TOOL.json: delete it after the mutants changed. Development only. The packages are
installed outside the tree, in ~/.cache/steradian-others; a tool that cannot be had is named and left out.

Each tool gets a fair setting: the tolerance of a value that `steradian compare` has by default (pixelmatch and odiff
their own threshold of 0.1), and of the limits in LIMITS, on the share of differing pixels or on mean FLIP, the one
with the fewest wrong verdicts over all mutants. Light is shown to pixelmatch and odiff as FLIP shows it: through a
tone curve, at the reference's exposure. A mutant whose verdict rests on an option that other tools lack (noise, region,
mask, other limits) is judged without it, marked *.
"""
import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path

HOME = Path.home() / ".cache" / "steradian-others"
LIMITS = {"idiff": (0, 1e-4, 1e-3), "pixelmatch": (0, 1e-4, 1e-3), "odiff": (0, 1e-4, 1e-3),
          "FLIP": (1e-6, 1e-4, 1e-3, 3e-3, 1e-2)}
NEEDS_AN_OPTION = ("noise_a", "noise_in_both", "noise_hides", "wrong_outside_region", "wrong_inside_region",
                   "wrong_behind_mask", "scattered", "clustered", "nan_in_both_allowed", "all_nan_allowed")
PIXELMATCH = """
import fs from 'fs'; import pixelmatch from 'pixelmatch'; import {PNG} from 'pngjs';
for (const line of fs.readFileSync(0, 'utf8').trim().split('\\n')) {
  const [a, b] = line.split('\\t').map((file) => PNG.sync.read(fs.readFileSync(file)));
  if (a.width !== b.width || a.height !== b.height) { console.log('inf'); continue; }
  console.log(pixelmatch(a.data, b.data, null, a.width, a.height, {threshold: 0.1}) / (a.width * a.height));
}
"""


def ran(*words, **options):
    return subprocess.run(words, capture_output=True, text=True, check=False, **options)


def install():
    """Installs what is missing, and names what cannot be had. Returns the tools that are there."""
    HOME.mkdir(parents=True, exist_ok=True)
    python = HOME / "venv" / "bin" / "python"
    if not python.exists():
        ran(sys.executable, "-m", "venv", HOME / "venv")
        ran(python, "-m", "pip", "install", "-q", "flip-evaluator==1.7", "tifffile", "numpy")
    if not (HOME / "node_modules").exists():
        (HOME / "package.json").write_text('{"type": "module", "private": true}')
        ran("npm", "install", "--silent", "odiff-bin@4.5.0", "pixelmatch@7.2.0", "pngjs", cwd=HOME)
    (HOME / "pixelmatch.mjs").write_text(PIXELMATCH)
    there = {"idiff": ran("sh", "-c", "command -v idiff").returncode == 0,
             "pixelmatch": (HOME / "node_modules" / "pixelmatch").exists(),
             "odiff": (HOME / "node_modules" / ".bin" / "odiff").exists(),
             "FLIP": ran(python, "-c", "import flip_evaluator, tifffile").returncode == 0}
    for tool in (name for name, is_there in there.items() if not is_there):
        print(f"{tool} cannot be had here and is left out", file=sys.stderr)
    if there["FLIP"] and Path(sys.executable) != python and "OTHERS_INSIDE" not in os.environ:
        os.execve(python, [str(python), *sys.argv], {**os.environ, "OTHERS_INSIDE": "1"})
    return [name for name, is_there in there.items() if is_there]


def idiff_share(folder, row):
    """The share of pixels beyond the tolerance, of the picture without its layers."""
    files = []
    for role in ("test", "reference"):
        source, picture = f"{folder}/{row['name']}.{role}.exr", f"/tmp/idiff_{role}.exr"
        info = ran("oiiotool", "--info", "-v", source).stdout
        names = re.search(r"channel list: (.*)", info)
        names = [name.split(" ")[0] for name in names[1].split(", ")] if names else ["Y"]
        channels = [name for name in ("R", "G", "B", "A") if name in names] or ["Y"]
        ran("oiiotool", source, "--ch", ",".join(channels), "-o", picture)
        files.append(picture)
    limit = ("-fail", "0.0079") if row["are_codes"] else ("-failrelative", "0.01")
    result = ran("idiff", *limit, "-warn", "1e9", *files)
    over = re.search(r"\(([\d.e+-]+)%\) over", result.stdout)
    if over:
        return float(over[1]) / 100
    return 0.0 if result.returncode in (0, 1) else math.inf


def pixelmatch_shares(folder, rows):
    pairs = "\n".join(f"{folder}/{row['name']}.test.png\t{folder}/{row['name']}.reference.png" for row in rows)
    return [float(line) for line in ran("node", HOME / "pixelmatch.mjs", cwd=HOME, input=pairs).stdout.split()]


def odiff_share(folder, row):
    result = ran(HOME / "node_modules" / ".bin" / "odiff", f"{folder}/{row['name']}.reference.png",
                 f"{folder}/{row['name']}.test.png", "--parsable-stdout")
    if result.returncode == 0:
        return 0.0
    numbers = result.stdout.strip().split(";")
    return float(numbers[1]) / 100 if len(numbers) > 1 else math.inf


def flip_mean(folder, row):
    import flip_evaluator
    import numpy as np
    import tifffile

    images = []
    for role in ("test", "reference"):
        plain = "/tmp/rgb.tif"
        result = ran("oiiotool", f"{folder}/{row['name']}.{role}.exr", "--ch", "R,G,B", "-d", "float", "--compression",
                     "none", "-o", plain)
        if "Unknown channel" in result.stdout + result.stderr:
            return math.inf
        images.append(tifffile.imread(plain).astype(np.float32))
    test, reference = images
    if test.shape != reference.shape:
        return math.inf
    kind = "LDR" if row["are_codes"] else "HDR"
    return float(flip_evaluator.evaluate(reference, np.maximum(test, 0), kind, applyMagma=False)[1])


def needs_an_option(row):
    return row["name"].startswith(NEEDS_AN_OPTION)


def measures(tool, folder, rows):
    """What a tool measures of each mutant, from an earlier call where it is kept."""
    kept = Path(folder) / f"{tool}.json"
    known = json.loads(kept.read_text()) if kept.exists() else {}
    missing = [row for row in rows if row["name"] not in known]
    if tool == "pixelmatch":
        values = pixelmatch_shares(folder, missing) if missing else []
    else:
        one = {"idiff": idiff_share, "odiff": odiff_share, "FLIP": flip_mean}[tool]
        values = []
        for number, row in enumerate(missing, 1):
            values.append(one(folder, row))
            print(f"\r{tool}: {number} of {len(missing)}", end="", file=sys.stderr, flush=True)
    known |= {row["name"]: value for row, value in zip(missing, values)}
    kept.write_text(json.dumps(known))
    return [known[row["name"]] for row in rows]


def wrong_of(values, rows, limit):
    """The names of the mutants that this limit judges wrongly. A NaN passes, as in any script that asks whether the
    limit is exceeded."""
    return [row["name"] for value, row in zip(values, rows)
            if not needs_an_option(row) and (not value > limit) != row["passes"]]


def cell(passes, wanted):
    word = "pass" if passes else "fail"
    return word if passes == wanted else f"**{word}**"


def main():
    folder, rows = sys.argv[1], json.loads(Path(sys.argv[2]).read_text())
    tools = install()
    found = {tool: measures(tool, folder, rows) for tool in tools}
    limits = {tool: min(LIMITS[tool], key=lambda limit, tool=tool: len(wrong_of(found[tool], rows, limit)))
              for tool in tools}
    print("| mutant | must | steradian | cause |" + "".join(f" {tool} |" for tool in tools))
    print("|---|---|---|---|" + "---|" * len(tools))
    for i, row in enumerate(rows):
        star = "*" if needs_an_option(row) else ""
        cause = row["diagnosis"] + (f" ({row['layer']})" if row["layer"] else "")
        words = [cell(not found[tool][i] > limits[tool], row["passes"]) for tool in tools]
        print(f"| {row['name']}{star} | {'pass' if row['passes'] else 'fail'} | "
              f"{cell(row['steradian'], row['passes'])} | {cause} | " + " | ".join(words) + " |")
    judged = sum(not needs_an_option(row) for row in rows)
    ours = sum(row["passes"] != row["steradian"] for row in rows)
    others = ", ".join(f"{tool} {len(wrong_of(found[tool], rows, limits[tool]))} (limit {limits[tool]:g})" for tool in tools)
    print(f"\nWrong verdicts: steradian {ours} of {len(rows)}; of the {judged} without a star {others}.")


if __name__ == "__main__":
    main()
