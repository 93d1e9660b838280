#!/usr/bin/env python3
"""Renders surfaces under scaled, sheared and mirrored nodes with Mitsuba 3: tests/truth/references/nodes.exr.

    tools/truth/.venv/bin/python tools/truth/nodes.py

No code of Steradian is used: vertices, normals and maps are made here, in world space, and Mitsuba's own `diffuse` and `normalmap`
evaluate them. tests/truth/node_test.cpp has the same surfaces with node transforms. A square with a normal map and a smooth
ball show each transform, side by side.
"""
from pathlib import Path

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")
SIZE, SPP, BATCHES = 16, 4096, 4

# The node's linear part, row by row, and half of what the camera sees.
NODES = [
    ([[0.01, 0, 0], [0, 0.01, 0], [0, 0, 0.01]], 0.004),
    ([[3, 0, 0], [0, 0.5, 0], [0, 0, 4]], 0.2),
    ([[-1, 0, 0], [0, 1, 0], [0, 0, 1]], 0.4),
    ([[1, 0.5, 0], [0, 0.8, 0], [0.3, 0, 0.5]], 0.3),
    ([[-2, 0.4, 0], [0, 1, 0], [0.2, -0.1, 3]], 0.3),
]


def texel(i, j):
    n = np.array([0.4 * np.sin(1 + 3 * i + 5 * j), 0.4 * np.cos(2 * i + 7 * j), 1.0])
    return n / np.linalg.norm(n)


def normal_map(is_mirrored):
    """Mitsuba's bitangent is n × dp/du; under a mirror the map's own is the other way round."""
    picture = np.array([[texel(i, j) for i in range(4)] for j in range(4)])
    if is_mirrored:
        picture[:, :, 1] *= -1
    bitmap = mi.Bitmap((0.5 + 0.5 * picture).astype(np.float32))
    return {"type": "bitmap", "bitmap": bitmap, "raw": True, "wrap_mode": "repeat", "filter_type": "bilinear"}


def square():
    positions = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
    uv = np.stack([0.5 + 0.5 * positions[:, 0], 0.5 - 0.5 * positions[:, 1]], 1)
    return positions, np.tile([0.0, 0.0, 1.0], (4, 1)), uv, np.array([[0, 1, 2], [0, 2, 3]])


def ball(cells=64):
    """The half of a ball that faces +Z, where it is z = sqrt(1 - x² - y²), over a square within."""
    at = np.linspace(-0.68, 0.68, cells + 1)
    x, y = np.meshgrid(at, at)
    positions = np.stack([x, y, np.sqrt(1 - x * x - y * y)], 2).reshape(-1, 3)
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)[None, :]).ravel()
    a, b, c, d = first, first + 1, first + cells + 2, first + cells + 1
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return positions, positions.copy(), 0.5 + 0.5 * positions[:, :2], faces


def mesh_of(shape, matrix, bsdf):
    positions, normals, uv, faces = shape
    positions = positions @ matrix.T
    normals = normals @ np.linalg.inv(matrix)  # rows: the inverse transpose applied to each
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    if np.linalg.det(matrix) < 0:
        faces = faces[:, ::-1]
    props = mi.Properties()
    props["bsdf"] = mi.load_dict(bsdf)
    mesh = mi.Mesh("surface", len(positions), len(faces), has_vertex_normals=True, has_vertex_texcoords=True, props=props)
    parameters = mi.traverse(mesh)
    for name, values in (("vertex_positions", positions), ("vertex_normals", normals), ("vertex_texcoords", uv)):
        parameters[name] = values.astype(np.float32).ravel()
    parameters["faces"] = faces.astype(np.uint32).ravel()
    parameters.update()
    return mesh


def scene_of(shape, matrix, half, bsdf):
    far = 40 * half + 10 * np.abs(matrix).max()
    transform = mi.ScalarTransform4f().look_at(origin=[0, 0, far], target=[0, 0, 0], up=[0, 1, 0])
    height = matrix[2, 2] if shape is not SQUARE else 0.0
    return mi.load_dict({
        "type": "scene", "integrator": {"type": "direct"}, "surface": mesh_of(shape, matrix, bsdf),
        "sensor": {"type": "orthographic", "near_clip": 0.01 * half, "far_clip": 2 * far,
                   "to_world": transform @ mi.ScalarTransform4f().scale([half, half, 1]),
                   "film": {"type": "hdrfilm", "width": SIZE, "height": SIZE, "pixel_format": "rgb",
                            "component_format": "float32", "rfilter": {"type": "box"}}},
        "lamp": {"type": "point", "position": [0.5 * half, 0.7 * half, 3 * half + height],
                 "intensity": {"type": "rgb", "value": [float(v * half * half) for v in (20, 16, 10)]}}})


SQUARE, BALL = square(), ball()


def main():
    means, noises = [], []
    for number, shape in enumerate((SQUARE, BALL)):
        for rows, half in NODES:
            matrix = np.array(rows, float)
            bsdf = {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.5, 0.4, 0.3]}}
            if number == 0:
                bsdf = {"type": "normalmap", "normalmap": normal_map(np.linalg.det(matrix) < 0), "nested": bsdf,
                        "use_shadowing_function": False, "flip_invalid_normals": False}
            scene = scene_of(shape, matrix, half, bsdf)
            pictures = np.array([np.array(mi.render(scene, spp=SPP, seed=i), float) for i in range(BATCHES)])
            means.append(pictures.mean(0))
            noises.append(pictures.std(0, ddof=1) / np.sqrt(BATCHES))
            print(number, rows, means[-1].mean((0, 1)), noises[-1].max())
    picture = np.concatenate([np.concatenate(means, 1), np.concatenate(noises, 1)], 2).astype(np.float32)
    bitmap = mi.Bitmap(np.ascontiguousarray(picture), pixel_format=mi.Bitmap.PixelFormat.MultiChannel,
                       channel_names=["R", "G", "B", "noise.R", "noise.G", "noise.B"])
    for key, value in (("made_by", f"Mitsuba {mi.__version__}"), ("integrator", "direct"), ("spp", SPP * BATCHES), ("seed", 0)):
        bitmap.metadata()["truth:" + key] = str(value)
    bitmap.write(str(Path(__file__).resolve().parents[2] / "tests/truth/references/nodes.exr"))


if __name__ == "__main__":
    main()
