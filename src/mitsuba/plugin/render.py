#!/usr/bin/env python3
"""Renders the Mitsuba scene in this folder, direct light only.

    python render.py -o picture.exr --spp 256

Needs the package `mitsuba` (README.md). The values of the picture are radiances in the scene's unit, cd/m² for glTF.
"""
import argparse
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


def load(variant="llvm_ad_rgb"):
    """The scene, with the plugins that it needs registered."""
    import mitsuba as mi

    mi.set_variant(variant)
    sys.path.insert(0, str(FOLDER))
    import steradian_mitsuba  # noqa: F401: importing registers the plugins

    return mi.load_file(str(FOLDER / "scene.xml"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", required=True, help="an .exr file")
    parser.add_argument("--spp", type=int, default=64, help="samples a pixel (default: 64)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--variant", default="llvm_ad_rgb",
                        help="llvm_ad_rgb (default), cuda_ad_rgb, or scalar_rgb, which is slow and needs no LLVM; never a "
                             "spectral one, since the scene is in linear RGB")
    arguments = parser.parse_args()
    scene = load(arguments.variant)
    import mitsuba as mi

    mi.Bitmap(mi.render(scene, spp=arguments.spp, seed=arguments.seed)).write(arguments.output)


if __name__ == "__main__":
    main()
