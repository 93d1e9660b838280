#!/usr/bin/env python3
"""Writes f_r of every BRDF and layer as the exported plugins evaluate it, for directions and parameters drawn at random.

    tools/truth/.venv/bin/python tools/truth/brdf_models_table.py > tests/truth/references/brdf_models.csv

The tests truth.brdf.* evaluate shaders/brdf/ for the same rows. p0 to p7 are the parameters that PARAMETERS names; directions are
in degrees from the normal and around it from the tangent. The measured BRDF is that of tests/truth/ball_scenes.cpp, which
build/truth_export writes.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
LLVM = "/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1"  # Debian's libllvm19
ROWS = 100

# Largest and least of each parameter, as tests/truth/brdf_models_test.cpp reads them.
COLOR = {"r": (0, 1), "g": (0, 1)}  # blue is 0.5
PARAMETERS = {
    "lambert": COLOR,
    "oren_nayar": COLOR | {"roughness": (0, 1)},
    "phong": COLOR | {"exponent": (1, 200), "specular": (0, 1)},
    "blinn_phong": COLOR | {"exponent": (1, 500), "specular": (0, 1)},
    "ggx": COLOR | {"roughness": (0.2, 1)},
    "brushed": COLOR | {"roughness": (0.2, 1), "roughness_across": (0.2, 1)},
    "conductor": {"n_r": (0.1, 3), "n_g": (0.1, 3), "k_r": (1, 6), "k_g": (1, 6), "roughness": (0.2, 1)},
    "merl": COLOR,
    "anisotropy": COLOR | {"metallic": (0, 1), "roughness": (0.2, 1), "strength": (0.1, 1), "rotation": (-3.2, 3.2)},
    "clearcoat": COLOR | {"metallic": (0, 1), "roughness": (0.2, 1), "coat": (0.1, 1), "coat_roughness": (0.2, 1)},
    "sheen": COLOR | {"metallic": (0, 1), "roughness": (0.2, 1), "sheen": (0.1, 1), "sheen_roughness": (0.2, 1)},
    "thin_film": COLOR | {"metallic": (0, 1), "roughness": (0.2, 1), "film": (0.1, 1), "ior": (1, 2.5), "thickness": (0, 1000)},
    "layers": COLOR | {"roughness": (0.3, 1), "strength": (0.1, 1), "coat": (0.1, 1), "sheen": (0.1, 1), "film": (0.1, 1),
                       "thickness": (100, 800)},
}


def plugin_of(brdf, p, measured):
    """The element that `steradian export` writes for such a material."""
    base = {"base_color": [p.get("r", 1), p.get("g", 1), 0.5], "roughness": p.get("roughness", 1)}
    along = {"vertex_normal": {"type": "rawconstant", "value": [0, 0, 1]},
             "vertex_tangent": {"type": "rawconstant", "value": [1, 0, 0]},
             "vertex_handedness": {"type": "rawconstant", "value": [1, 1, 1]}}
    anisotropy = {"anisotropy": p.get("strength"), "anisotropy_rotation": p.get("rotation", 0.4)} | along
    coat = {"clearcoat": p.get("coat"), "clearcoat_roughness": p.get("coat_roughness", 0.3)}
    sheen = {"sheen_color": [p.get("sheen", 0), 0.5, 0.3], "sheen_roughness": p.get("sheen_roughness", 0.5)}
    film = {"iridescence": p.get("film"), "film_ior": p.get("ior", 1.5), "max_film_thickness": p.get("thickness")}
    phong = {"exponent": p.get("exponent"), "specular_color": [p.get("specular", 0), 0.4, 0.2]}
    gltf = {"type": "steradian_metallic_roughness", "metallic": p.get("metallic", 0.6)} | base
    return {
        "lambert": {"type": "steradian_framed", "inner": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 1.0}}} | base,
        "oren_nayar": {"type": "steradian_oren_nayar"} | base,
        "phong": {"type": "steradian_phong"} | base | phong,
        "blinn_phong": {"type": "steradian_blinn_phong"} | base | phong,
        "ggx": {"type": "steradian_ggx"} | base,
        "brushed": {"type": "steradian_ggx", "roughness_across": p.get("roughness_across")} | base | along,
        "conductor": {"type": "steradian_conductor", "n": [p.get("n_r", 1), p.get("n_g", 1), 1.5],
                      "k": [p.get("k_r", 1), p.get("k_g", 1), 2.5]} | base,
        "merl": {"type": "steradian_merl", "filename": str(measured)} | base,
        "anisotropy": gltf | anisotropy,
        "clearcoat": gltf | coat,
        "sheen": gltf | sheen,
        "thin_film": gltf | film,
        "layers": gltf | anisotropy | coat | sheen | film,
    }[brdf]


def angles(rng):
    """Of wi and wo [degrees]: half of the pairs about the mirror direction, where peaks are; a third near grazing."""
    def direction():
        c = np.where(np.arange(ROWS) % 3 == 0, rng.uniform(0.02, 0.2, ROWS), rng.uniform(0.02, 1.0, ROWS))
        return np.degrees(np.arccos(c)), rng.uniform(0, 360, ROWS)

    (theta_i, phi_i), (theta_o, phi_o) = direction(), direction()
    is_near = np.arange(ROWS) % 2 == 0
    theta_i = np.where(is_near, np.clip(theta_o + 8 * rng.standard_normal(ROWS), 0, 88), theta_i)
    phi_i = np.where(is_near, (phi_o + 180 + 8 * rng.standard_normal(ROWS)) % 360, phi_i)
    return np.round(np.stack([theta_i, phi_i, theta_o, phi_o], 1), 2)


def unit(mi, theta, phi):
    t, p = np.radians(theta), np.radians(phi)
    return mi.Vector3f(*(float(v) for v in (np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t))))


def f_r(mi, bsdf, row):
    """By the function that Mitsuba's integrators call."""
    import drjit as dr

    si = dr.zeros(mi.SurfaceInteraction3f)
    si.n = mi.Normal3f(0, 0, 1)
    si.sh_frame = mi.Frame3f(mi.Vector3f(0, 0, 1))
    si.sh_frame.s, si.sh_frame.t = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    light, si.wi = unit(mi, *row[:2]), unit(mi, *row[2:])
    return np.array(bsdf.eval(mi.BSDFContext(), si, light) / light.z).ravel()


def write_tables(mi, measured):
    rng = np.random.default_rng(7)
    columns = [f"p{i}" for i in range(8)]
    print("brdf", *columns, "theta_i,phi_i,theta_o,phi_o,f_r,f_g,f_b", sep=",")
    for brdf, limits in PARAMETERS.items():
        for row in angles(rng):
            p = {name: float(np.round(rng.uniform(*limit), 3)) for name, limit in limits.items()}
            value = f_r(mi, mi.load_dict(plugin_of(brdf, p, measured)), row)
            stated = [f"{v:g}" for v in p.values()] + ["0"] * (8 - len(p))
            print(brdf, *stated, *(f"{a:.2f}" for a in row), *(f"{v:.7g}" for v in value), sep=",")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--export", type=Path, default=ROOT / "build/truth_export", help="the program that writes the scenes")
    arguments = parser.parse_args()
    if Path(LLVM).exists():
        os.environ.setdefault("DRJIT_LIBLLVM_PATH", LLVM)
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    sys.path.insert(0, str(ROOT / "src/mitsuba/plugin"))
    import steradian_mitsuba  # noqa: F401: importing registers the plugins

    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run([arguments.export, scratch, "balls.point"], check=True)
        write_tables(mi, Path(scratch) / "balls.point/merl/measured/0.binary")


if __name__ == "__main__":
    main()
