#!/usr/bin/env python3
"""Writes f_r as Mitsuba's side of the export evaluates it, for directions and materials drawn at random.

    tools/truth/.venv/bin/python tools/truth/brdf_table.py > tests/truth/references/brdf.csv

The test truth.brdf.metallic_roughness evaluates shaders/brdf/f_r.glsl for the same rows: n is +Z, base colour (r, g, 0.5).
"""
import os
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
LLVM = "/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1"  # Debian's libllvm19
ROWS = 400


def directions(rng):
    """Over the hemisphere, a third of them near grazing."""
    z = np.where(np.arange(ROWS) % 3 == 0, rng.uniform(0.01, 0.2, ROWS), rng.uniform(0.02, 1.0, ROWS))
    phi = rng.uniform(0, 2 * np.pi, ROWS)
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], 1)


def rows():
    rng = np.random.default_rng(3)
    wo, wi = directions(rng), directions(rng)
    # Every other pair about the mirror direction, where the lobe has its peak.
    near = wo * [-1, -1, 1] + 0.1 * rng.standard_normal((ROWS, 3))
    near[:, 2] = np.abs(near[:, 2])
    near /= np.linalg.norm(near, axis=1, keepdims=True)
    wi = np.where((np.arange(ROWS) % 2 == 0)[:, None], near, wi)
    metallic = np.choose(rng.integers(0, 3, ROWS), [np.zeros(ROWS), np.ones(ROWS), rng.uniform(0, 1, ROWS)])
    alpha = rng.uniform(0.1, 1.0, ROWS) ** 2
    color, F0 = rng.uniform(0, 1, (ROWS, 2)), rng.uniform(0.0, 0.2, ROWS)
    specular = np.choose(rng.integers(0, 2, ROWS), [np.ones(ROWS), rng.uniform(0, 1, ROWS)])
    return np.concatenate([wi, metallic[:, None], wo, alpha[:, None], color, F0[:, None], specular[:, None]], 1)


def main():
    if Path(LLVM).exists():
        os.environ.setdefault("DRJIT_LIBLLVM_PATH", LLVM)
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    sys.path.insert(0, str(ROOT / "src/mitsuba/plugin"))
    import steradian_mitsuba  # noqa: F401: importing registers the plugins
    from steradian_mitsuba.microfacets import Microfacets

    table = rows().astype(np.float32)
    c = [mi.Float(np.ascontiguousarray(column)) for column in table.T]
    wi, wo, frame = mi.Vector3f(c[0], c[1], c[2]), mi.Vector3f(c[4], c[5], c[6]), mi.Frame3f(mi.Vector3f(0, 0, 1))
    x = SimpleNamespace(view=wo, n=frame.n, frame=frame, base_color=mi.Color3f(c[8], c[9], mi.Float(0.5)), metallic=c[3],
                        lobe=Microfacets(frame, c[7], c[7]), F0=mi.Color3f(c[10]), specular=c[11])
    f_r = np.array(mi.load_dict({"type": "steradian_metallic_roughness"}).f_r(x, wi)).T
    print("wi_x,wi_y,wi_z,metallic,wo_x,wo_y,wo_z,alpha,base_r,base_g,F0,specular,f_r,f_g,f_b")
    for inputs, outputs in zip(table, f_r):
        print(",".join(f"{value:.9g}" for value in [*inputs, *outputs]))


if __name__ == "__main__":
    main()
