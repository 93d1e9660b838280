#!/usr/bin/env python3
"""How often the comparator calls equal pictures different, whose samples have other seeds.

    tools/golden/false_alarms.py build/steradian /tmp/seeds
    tools/golden/false_alarms.py build/steradian /tmp/others --scenes office,zoo --first-seed 5001 --pairs 276

Renders bundled scenes with 36 seeds each, makes the noise of the first 12 with `steradian golden noise`, and
compares pairs of the other seeds, with the noise given twice. Pictures that are already in the folder are
kept: give each first seed a folder of its own. Prints the pairs that fail, and their number. A scene has 276 pairs
of 24 seeds: they are not independent, since one seed with a rare sample is in 23 of them.
"""
import argparse
import itertools
import json
import subprocess
from pathlib import Path

SCENES = "cornell,default,veach,spheres,brdfs"
NOISE_SEEDS = range(1, 13)
PAIR_SEEDS = range(13, 37)
PAIRS = 60
RENDER = ("--size", "96x64", "--samples", "16")


def pairs(count):
    """Pairs with as many different seeds as there are: 12 that share none, then those at growing distances."""
    seeds = list(PAIR_SEEDS)
    return sorted(itertools.combinations(seeds, 2), key=lambda pair: (pair[1] - pair[0], pair[0] % 2))[:count]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("steradian", type=lambda name: str(Path(name).resolve()))
    parser.add_argument("folder", type=lambda name: Path(name).resolve(), help="keeps the pictures")
    parser.add_argument("--scenes", default=SCENES, help="bundled scenes, separated by commas (default: %(default)s)")
    parser.add_argument("--first-seed", type=int, default=1, help="of 36 that follow one another (default: %(default)s)")
    parser.add_argument("--pairs", type=int, default=PAIRS, help="of each scene, up to 276 (default: %(default)s)")
    options = parser.parse_args()
    steradian, folder, names = options.steradian, options.folder, options.scenes.split(",")
    scenes = Path(__file__).resolve().parents[2] / "assets" / "scenes"
    tests = []
    for scene in names:
        (folder / scene).mkdir(parents=True, exist_ok=True)
        for seed in (*NOISE_SEEDS, *PAIR_SEEDS):
            out = folder / scene / f"{seed}.exr"
            if not out.exists():
                subprocess.run([steradian, "render", scenes / f"{scene}.gltf", "-o", out, *RENDER, "--seed",
                                str(options.first_seed + seed - 1)], check=True)
        tests.append({"name": scene, "command": ["cp", f"{folder}/{scene}/{{seed}}.exr", "{out}"],
                      "noise": f"{scene}_noise.exr"})
    suite = folder / "suite.json"
    suite.write_text(json.dumps({"tests": tests}))
    subprocess.run([steradian, "golden", "noise", suite, "-o", folder / "results", "--seeds", str(len(NOISE_SEEDS))],
                   check=True, stdout=subprocess.DEVNULL)
    alarms = compared = 0
    for scene in names:
        noise = folder / f"{scene}_noise.exr"
        for a, b in pairs(options.pairs):
            ran = subprocess.run([steradian, "compare", folder / scene / f"{a}.exr", folder / scene / f"{b}.exr", "--noise",
                                  noise, "--noise", noise, "--json"], capture_output=True, text=True, check=False)
            compared += 1
            if ran.returncode == 0:
                continue
            alarms += 1
            print(scene, a, b, *[verdict["line"] for verdict in json.loads(ran.stdout)["verdicts"] if not verdict["passed"]])
    print(f"{alarms} of {compared} pairs of seeds fail")


if __name__ == "__main__":
    main()
