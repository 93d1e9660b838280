#!/usr/bin/env python3
"""Renders the references of the truth tests with Mitsuba 3 and stores them.

    tools/truth/setup                                     # Mitsuba, into tools/truth/.venv
    cmake --build build --target truth_export
    tools/truth/.venv/bin/python tools/truth/references.py               # all, some ten minutes on two cores
    tools/truth/.venv/bin/python tools/truth/references.py --only tube   # those whose name begins so

The scenes come from build/truth_export. A picture holds its parts side by side (SHAPE.VIEW.exr a square a material,
balls.LIGHT.exr a ball a BRDF): R G B, the mean of independent batches, and noise.R noise.G noise.B, the standard error of
that mean. index.json says how each was made.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
LLVM = "/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1"  # Debian's libllvm19


def pooled(variances):
    """The mean over the 3×3 pixels around, as tests/truth/comparison.cpp has it."""
    height, width = variances.shape[:2]
    padded = np.pad(variances, ((1, 1), (1, 1), (0, 0)), constant_values=np.nan)
    return np.nanmean([padded[y:y + height, x:x + width] for y in range(3) for x in range(3)], axis=0)


def measured(mi, scene, spp, batches, seed, is_smooth):
    """Mean and standard error of the mean, which neighbours share where the picture `is_smooth`."""
    pictures = np.array([np.array(mi.render(scene, spp=spp, seed=seed + i), np.float64) for i in range(batches)])
    if not np.isfinite(pictures).all():
        raise ValueError("a pixel is not finite")
    variance = pictures.var(0, ddof=1) / batches
    return pictures.mean(0), np.sqrt(pooled(variance) if is_smooth else variance)


def rounded(values, bits):
    """Floats with so many bits of mantissa: zeros compress."""
    dropped = np.uint32(23 - bits)
    whole = values.astype(np.float32).view(np.uint32) + (np.uint32(1) << (dropped - np.uint32(1)))
    return (whole >> dropped << dropped).view(np.float32)


def store(mi, file, means, noises, entry, bits):
    """Mean and noise, rounded to so many bits each. What rounding does to the mean is a part of the noise."""
    mean, noise = np.concatenate(means, 1), np.concatenate(noises, 1)
    noise = np.hypot(noise, mean * 2.0**-(bits[0] + 1) / np.sqrt(3))
    picture = np.concatenate([rounded(mean, bits[0]), rounded(noise, bits[1])], 2)
    bitmap = mi.Bitmap(np.ascontiguousarray(picture), pixel_format=mi.Bitmap.PixelFormat.MultiChannel,
                       channel_names=["R", "G", "B", "noise.R", "noise.G", "noise.B"])
    for key in ("made_by", "integrator", "variant", "spp", "seed"):
        bitmap.metadata()["truth:" + key] = str(entry[key])
    bitmap.write(str(file))


def parts_of(folder):
    """What stands side by side in the picture."""
    return (folder / "parts").read_text().split()


def make(mi, folder, file, arguments):
    begin = time.time()
    means, noises, cells = [], [], {}
    is_plane = not folder.name.startswith(("balls.", "shadow."))  # radiance varies slowly over it, and so does its noise
    # Of means, 3·10⁻⁵ are lost at most, which no pixel's noise is below; of balls, whose noise is four times that, 10⁻⁴.
    bits = (12, 5) if folder.name.startswith("balls.") else (14, 8)
    for i, part in enumerate(parts_of(folder)):
        scene = mi.load_file(str(folder / part / "scene.xml"))
        mean, noise = measured(mi, scene, arguments.spp, arguments.batches, arguments.seed + 1000 * i, is_plane)
        means.append(mean)
        noises.append(noise)
        lit = mean > 0
        cells[part] = {"relative_noise_of_a_pixel_median": round(float(np.median(noise[lit] / mean[lit])), 6),
                           "relative_noise_of_the_sum": round(float((np.sqrt((noise**2).sum((0, 1))) / mean.sum((0, 1))).max()), 7)}
    entry = {"made_by": f"Mitsuba {version('mitsuba')}", "integrator": "direct", "variant": mi.variant(),
             "spp": arguments.spp * arguments.batches, "batches": arguments.batches, "seed": arguments.seed, "cells": cells}
    store(mi, file, means, noises, entry, bits)
    print(f"{file.name}: {time.time() - begin:.0f} s, a pixel's noise {100 * max(c['relative_noise_of_a_pixel_median'] for c in cells.values()):.2f} % "
          f"at most (median of a cell), of the sum {100 * max(c['relative_noise_of_the_sum'] for c in cells.values()):.3f} %", file=sys.stderr)
    return entry


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--export", type=Path, default=ROOT / "build/truth_export", help="the program that writes the scenes")
    parser.add_argument("--to", type=Path, default=ROOT / "tests/truth/references")
    parser.add_argument("--only", default="", help="pictures whose name begins so, e.g. tube or mesh.grazing")
    parser.add_argument("--spp", type=int, default=4096, help="samples a pixel in a batch")
    parser.add_argument("--batches", type=int, default=16)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--variant", default="llvm_ad_rgb", help="or scalar_rgb, without LLVM but slow")
    arguments = parser.parse_args()
    if Path(LLVM).exists():
        os.environ.setdefault("DRJIT_LIBLLVM_PATH", LLVM)
    import mitsuba as mi

    mi.set_variant(arguments.variant)
    arguments.to.mkdir(parents=True, exist_ok=True)
    index = arguments.to / "index.json"
    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run([arguments.export, scratch, arguments.only], check=True)
        folders = [f for f in sorted(Path(scratch).iterdir()) if f.is_dir()]
        if not folders:
            sys.exit(f"references.py: no picture begins with '{arguments.only}': the names are SHAPE.VIEW, photograph.VIEW, balls.LIGHT and shadow.SCENE")
        sys.path.insert(0, str(folders[0] / parts_of(folders[0])[0]))
        import steradian_mitsuba  # noqa: F401: importing registers the plugins

        for folder in folders:
            entry = make(mi, folder, arguments.to / f"{folder.name}.exr", arguments)
            entries = json.loads(index.read_text()) if index.exists() else {}  # others may have written meanwhile
            entries[folder.name] = entry
            index.write_text(json.dumps(dict(sorted(entries.items())), indent=1) + "\n")


if __name__ == "__main__":
    main()
