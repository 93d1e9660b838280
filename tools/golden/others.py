#!/usr/bin/env python3
"""The mutants before other comparators: idiff (OpenImageIO), pixelmatch, odiff and FLIP.

    tools/golden/others.py build/golden_mutants /tmp/mutants                          # the small picture's, as a table
    tools/golden/others.py build/golden_mutants /tmp/mutants 256x256 1280x720         # those of the three bases
    tools/golden/others.py build/golden_mutants /tmp/mutants 3840x2160 --base interface --every 4

Prints Markdown: the table of the small picture, or for sizes the counts of wrong verdicts and their names. The pictures
are written a few at a time and removed again. The measures of the other tools are kept in FOLDER/TOOL.json: delete it
after the mutants changed. Development only. The packages are installed outside the tree, in ~/.cache/steradian-others;
a tool that cannot be had is named and left out.

Each tool gets a fair setting: the tolerance of a value that `steradian compare` has by default (pixelmatch and odiff
their own threshold of 0.1), and of the limits in LIMITS, on the share of differing pixels or on mean FLIP, the one
with the fewest wrong verdicts over all mutants of the call. idiff gets the channels of the reference. Light is shown to
pixelmatch and odiff as FLIP shows it: through a tone curve, at the reference's exposure. A mutant whose verdict rests
on an option that other tools lack (noise, region, mask, other limits) is judged without it, marked *, and not counted.
"""
import argparse
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

HOME = Path.home() / ".cache" / "steradian-others"
LIMITS = {"idiff": (0, 1e-5, 1e-4, 1e-3), "pixelmatch": (0, 1e-5, 1e-4, 1e-3), "odiff": (0, 1e-5, 1e-4, 1e-3),
          "FLIP": (1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2)}
NEEDS_AN_OPTION = re.compile(r"(.*\.)?(noise_(a|in_both|hides|of_seeds)|wrong_(out|in)side_region|wrong_behind_mask|scattered|clustered"
                             r"|nan_in_both_allowed|all_nan_allowed|hole_beside_a_mask|layer_square_of_a_share)")
BATCH = 16  # mutants whose files lie on the disk at a time
PIXELMATCH = """
import fs from 'fs'; import pixelmatch from 'pixelmatch'; import {PNG} from 'pngjs';
for (const line of fs.readFileSync(0, 'utf8').trim().split('\\n')) {
  const [a, b] = line.split('\\t').map((file) => PNG.sync.read(fs.readFileSync(file)));
  if (a.width !== b.width || a.height !== b.height) { console.log('Infinity'); continue; }
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
        ran(python, "-m", "pip", "install", "-q", "flip-evaluator==1.7", "numpy")
    if not (HOME / "node_modules").exists():
        (HOME / "package.json").write_text('{"type": "module", "private": true}')
        ran("npm", "install", "--silent", "odiff-bin@4.5.0", "pixelmatch@7.2.0", "pngjs", cwd=HOME)
    (HOME / "pixelmatch.mjs").write_text(PIXELMATCH)
    there = {"idiff": ran("sh", "-c", "command -v idiff").returncode == 0,
             "pixelmatch": (HOME / "node_modules" / "pixelmatch").exists(),
             "odiff": (HOME / "node_modules" / ".bin" / "odiff").exists(),
             "FLIP": ran(python, "-c", "import flip_evaluator").returncode == 0}
    for tool in (name for name, is_there in there.items() if not is_there):
        print(f"{tool} cannot be had here and is left out", file=sys.stderr)
    if there["FLIP"] and Path(sys.executable) != python and "OTHERS_INSIDE" not in os.environ:
        os.execve(python, [str(python), *sys.argv], {**os.environ, "OTHERS_INSIDE": "1"})
    return [name for name, is_there in there.items() if is_there]


def files_of(folder, name):
    """The test and the reference: light and codes of 16 bits as .exr, codes of 8 bits as .png."""
    suffix = ".exr" if (folder / f"{name}.test.exr").exists() else ".png"
    return [folder / f"{name}.{role}{suffix}" for role in ("test", "reference")]


def pixels_of(row):
    return row["reference"]["width"] * row["reference"]["height"]


def idiff_share(folder, row):
    """The share of pixels that idiff counts as failing. It says two counts: those over the limit of warnings, which no
    pixel exceeds here, and then those over the limit of failures."""
    test, reference = files_of(folder, row["name"])
    wanted, given = (row[role]["channels"] for role in ("reference", "test"))
    if wanted and len(given) > len(wanted):
        chosen = folder / "idiff.exr"
        ran("oiiotool", test, "--ch", ",".join(wanted), "-o", chosen)
        test = chosen
    limit = ("-fail", "0.0079") if row["are_codes"] else ("-failrelative", "0.01")
    result = ran("idiff", *limit, "-warn", "1e9", test, reference)
    counts = re.findall(r"(\d+) pixels \([^)]*%\) over", result.stdout)
    if len(counts) == 2:
        return int(counts[1]) / pixels_of(row)
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
    if len(numbers) < 2:
        return math.inf
    return int(numbers[0]) / pixels_of(row)


def flip_mean(folder, row):
    import flip_evaluator
    import numpy as np

    if any(row["test"][edge] != row["reference"][edge] for edge in ("width", "height")):
        return math.inf
    shape = row["reference"]["height"], row["reference"]["width"], 3
    test, reference = (np.fromfile(folder / f"{row['name']}.{role}.rgb", np.float32).reshape(shape)
                       for role in ("test", "reference"))
    kind = "LDR" if row["are_codes"] else "HDR"
    return float(flip_evaluator.evaluate(reference, np.maximum(test, 0), kind, applyMagma=False)[1])


def each(measure):
    return lambda folder, rows: [measure(folder, row) for row in rows]


MEASURES = {"idiff": each(idiff_share), "pixelmatch": pixelmatch_shares, "odiff": each(odiff_share), "FLIP": each(flip_mean)}


class Measures:
    """The measures of each mutant by each tool, kept from one call to the next."""

    def __init__(self, folder, tools):
        self.files = {tool: folder / f"{tool}.json" for tool in tools}
        self.known = {tool: json.loads(f.read_text()) if f.exists() else {} for tool, f in self.files.items()}

    def lack(self, name, tools):
        return any(name not in self.known[tool] for tool in tools)

    def add(self, folder, tool, rows):
        missing = [row for row in rows if row["name"] not in self.known[tool]]
        if not missing:
            return
        self.known[tool] |= zip((row["name"] for row in missing), MEASURES[tool](folder, missing))
        kept = self.files[tool].with_suffix(".part")
        kept.write_text(json.dumps(self.known[tool]))
        kept.replace(self.files[tool])

    def of(self, tool, row):
        return self.known[tool].get(row["name"])


def mutants(program, size, *options):
    result = ran(program, *([size] if size else []), *options)
    if result.returncode != 0:
        raise SystemExit(result.stderr)
    return json.loads(result.stdout)


def measure(options, size, names, tools_of, measures):
    """Writes the mutants that a tool has not measured, measures them and removes them."""
    full = (lambda name: f"{size}.{name}") if size else (lambda name: name)
    missing = [name for name in names if measures.lack(full(name), tools_of(name))]
    for first in range(0, len(missing), BATCH):
        with tempfile.TemporaryDirectory(dir=options.folder) as scratch:
            batch = missing[first:first + BATCH]
            rows = mutants(options.program, size, "--write", scratch, "--only", ",".join(batch))
            for tool in MEASURES:
                measures.add(Path(scratch), tool,
                             [row for row in rows if tool in tools_of(row["name"].removeprefix(f"{size}."))])
        print(f"\r{size}: {min(first + BATCH, len(missing))} of {len(missing)}", end="", file=sys.stderr, flush=True)
    if missing:
        print(file=sys.stderr)


def is_wrong(value, limit, row):
    """A NaN passes, as in any script that asks whether the limit is exceeded."""
    return (not value > limit) != row["passes"]


def counted(tool, rows, measures):
    return [row for row in rows if not NEEDS_AN_OPTION.match(row["short"]) and measures.of(tool, row) is not None]


def wrong_of(tool, rows, measures, limit):
    return [row for row in counted(tool, rows, measures) if is_wrong(measures.of(tool, row), limit, row)]


def cell(passes, wanted):
    word = "pass" if passes else "fail"
    return word if passes == wanted else f"**{word}**"


def print_each(rows, tools, measures, limits):
    print("| mutant | must | steradian | cause |" + "".join(f" {tool} |" for tool in tools))
    print("|---|---|---|---|" + "---|" * len(tools))
    for row in rows:
        star = "*" if NEEDS_AN_OPTION.match(row["short"]) else ""
        cause = row["diagnosis"] + (f" ({row['layer']})" if row["layer"] else "")
        words = [cell(not measures.of(tool, row) > limits[tool], row["passes"]) for tool in tools]
        print(f"| {row['name']}{star} | {'pass' if row['passes'] else 'fail'} | "
              f"{cell(row['steradian'], row['passes'])} | {cause} | " + " | ".join(words) + " |")
    ours = sum(row["passes"] != row["steradian"] for row in rows)
    others = ", ".join(f"{tool} {len(wrong_of(tool, rows, measures, limits[tool]))} of "
                       f"{len(counted(tool, rows, measures))} (limit {limits[tool]:g})" for tool in tools)
    print(f"\nWrong verdicts: steradian {ours} of {len(rows)}; without those of a star {others}.")


def count_cell(wrong, judged):
    missed = sum(not row["passes"] for row in wrong)
    return f"{len(wrong)} of {len(judged)} ({missed} missed, {len(wrong) - missed} false)" if judged else "–"


def print_counts(rows, tools, measures, limits):
    print("| size | base | steradian |" + "".join(f" {tool} |" for tool in tools))
    print("|---|---|---|" + "---|" * len(tools))
    groups = list(dict.fromkeys((row["size"], row["base"]) for row in rows))
    for size, base in [*groups, ("all", "")]:
        group = [row for row in rows if size == "all" or (row["size"], row["base"]) == (size, base)]
        words = [count_cell([row for row in group if row["passes"] != row["steradian"]], group)]
        words += [count_cell(wrong_of(tool, group, measures, limits[tool]), counted(tool, group, measures)) for tool in tools]
        print(f"| {size} | {base} | " + " | ".join(words) + " |")
    print("\nLimits: " + ", ".join(f"{tool} {limits[tool]:g}" for tool in tools) + ".")
    print("\n| tool | limit | wrong |\n|---|---|---|")
    for tool in tools:
        for limit in LIMITS[tool]:
            print(f"| {tool} | {limit:g} | {count_cell(wrong_of(tool, rows, measures, limit), counted(tool, rows, measures))} |")
    for tool in ["steradian", *tools]:
        wrong = [row for row in rows if row["passes"] != row["steradian"]] if tool == "steradian" else \
            wrong_of(tool, rows, measures, limits[tool])
        names = Counter(("+ " if row["passes"] else "- ") + row["short"] for row in wrong)
        print(f"\n{tool} (- damage that passes, + harmless that fails; × sizes): "
              + ", ".join(f"{name} ×{count}" for name, count in sorted(names.items())))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], epilog="\n".join(__doc__.split("\n\n")[1:]),
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="golden_mutants")
    parser.add_argument("folder", type=Path, help="keeps the measures")
    parser.add_argument("sizes", nargs="*", help="WIDTHxHEIGHT; without it, the small picture")
    parser.add_argument("--base", action="append", choices=("render", "photo", "interface"), default=[])
    parser.add_argument("--every", type=int, default=1, metavar="N", help="of the mutants of a base only each Nth")
    parser.add_argument("--flip-every", type=int, default=1, metavar="N", help="the same for FLIP, which is slow")
    parser.add_argument("--tools", default=",".join(MEASURES), help="these other tools, separated by commas")
    return parser.parse_args()


def main():
    options = arguments()
    options.folder.mkdir(parents=True, exist_ok=True)
    tools = [tool for tool in install() if tool in options.tools.split(",")]
    measures, rows = Measures(options.folder, tools), []
    bases = [word for base in options.base for word in ("--base", base)]
    for size in options.sizes or [""]:
        names = [row["name"] for row in mutants(options.program, size, *bases)][::options.every]
        for_flip = set(names[::options.flip_every])
        measure(options, size, names, lambda name: [t for t in tools if t != "FLIP" or name in for_flip], measures)
        judged = mutants(options.program, size, "--verdicts" if size else "--diagnose", "--only", ",".join(names))
        for row in judged:
            name = row["name"].removeprefix(f"{size}.")
            rows.append({**row, "short": name, "size": size, "base": name.split(".")[0]})
    limits = {tool: min(LIMITS[tool], key=lambda limit, tool=tool: len(wrong_of(tool, rows, measures, limit)))
              for tool in tools}
    (print_counts if options.sizes else print_each)(rows, tools, measures, limits)


if __name__ == "__main__":
    main()
