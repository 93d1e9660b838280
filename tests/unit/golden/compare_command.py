#!/usr/bin/env python3
"""`steradian compare` as people and scripts call it: exit status, stdout, files.

    compare_command.py STERADIAN GOLDEN_MUTANTS FOLDER
"""
import json
import subprocess
import sys
from pathlib import Path

steradian, golden_mutants, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
failures = []


def check(claim, *args, status, out="", err=""):
    ran = subprocess.run([steradian, "compare", *map(str, args)], capture_output=True, text=True, check=False)
    if ran.returncode != status or out not in ran.stdout or err not in ran.stderr:
        failures.append(f"{claim}: status {ran.returncode}, wanted {status}\n{ran.stdout}{ran.stderr}")
    return ran


def files(name):
    return folder / f"{name}.test.exr", folder / f"{name}.reference.exr"


folder.mkdir(parents=True, exist_ok=True)
subprocess.run([golden_mutants, folder], check=True, stdout=subprocess.DEVNULL)

check("equal images agree", *files("identical"), status=0, out="PASS")
check("a difference is status 1", *files("pi_missing"), status=1, out="a division by π is missing")
check("NaN fails", *files("one_nan"), status=1, out="1 of the test")
check("NaN may be allowed", *files("one_nan"), "--allow-nonfinite", status=0)
check("an option before the files", "--max", "rel=0.02@99%", "--max", "energy=1", *files("identical"), status=0)
check("two noises", "--noise", "0.1", "--noise", files("noise_at_its_floor")[1], *files("noise_at_its_floor"), status=0)
check("a region", *files("clustered_0.9_percent"), "--region", "0,0,60x96", status=0)
check("no such file", files("identical")[0], folder / "none.exr", status=3, err="none.exr: no such file")
check("a region outside", *files("identical"), "--region", "90,0,10x10", status=3, err="not inside 96x96")
check("a wrong limit", *files("identical"), "--max", "rel=x", status=2, err="is not a number")
check("a heat map is a picture", *files("identical"), "--heat-map", folder / "heat.exr", status=2, err=".png")
check("no noise, no z", *files("identical"), "--max", "z=5", status=3, err="noise floor")
check("help has examples", "--help", status=0, out="Examples:")

heat, both = folder / "heat.png", folder / "both.png"
check("pictures are written", *files("moved_object"), "--heat-map", heat, "--side-by-side", both, status=1)
failures += [f"{picture} is missing" for picture in (heat, both) if not picture.exists()]
check("the same picture as .png", heat, heat, status=0, out="abs ≤ 0.0079")

told = json.loads(check("JSON alone on stdout", *files("key_missing"), "--json", status=1).stdout)
if told["diagnosis"]["name"] != "light_missing" or told["diagnosis"]["layer"] != "key" or told["passed"]:
    failures.append(f"JSON tells {told['diagnosis']}")

print("\n".join(failures) if failures else "all claims hold")
sys.exit(bool(failures))
