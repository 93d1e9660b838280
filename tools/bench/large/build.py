"""Makes one large scene as .glb: build.py atrium|million|thousand|textures8k|heights QUADS|hall KIND COUNT|globe TEXELS OUTPUT"""
import sys
from pathlib import Path

import numpy
from glb import Glb, binary, fractal_noise, normal_map, surface

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from atrium import atrium  # noqa: E402
from hall import hall  # noqa: E402


def textured(glb, size, seed):
    """Stone with veins: a base colour and a normal map of size² texels, in bands so that the largest fit into memory."""
    noise = fractal_noise(size, 8, 8, seed).astype(numpy.float32)
    base = numpy.empty((size, size, 3), numpy.uint8)
    normals = numpy.empty((size, size, 3), numpy.uint8)
    for start in range(0, size, 512):
        rows = numpy.arange(start - 1, min(start + 512, size) + 1) % size
        veins = numpy.abs(numpy.sin(24 * noise[rows]))
        inner = slice(1, -1)
        tint = numpy.array((0.75, 0.60, 0.45), numpy.float32) * veins[inner, :, None] + numpy.array((0.10, 0.14, 0.22), numpy.float32)
        base[start:start + 512] = (255 * tint).clip(0, 255)
        normals[start:start + 512] = normal_map(veins, size / 512)[inner]
    return glb.texture(base), glb.texture(normals)


def heights(quads):
    """A height field of 2 quads² triangles, 12 m wide."""
    size = quads + 1
    noise = fractal_noise(size, 6, 6, 1) ** 1.5
    fine = fractal_noise(size, 64, 3, 9)
    ground = (3.2 * noise + 0.12 * fine - 1.6).astype(numpy.float32)
    ground[-1], ground[:, -1] = ground[-2], ground[:, -2]  # The noise repeats there.
    glb = Glb()
    positions, _, texcoords, indices = surface(lambda u, v: numpy.stack((12 * u - 6, 0 * u, 6 - 12 * v), -1), quads, quads, (8, 8))
    positions[:, 1] = ground.reshape(-1)
    slope_z, slope_x = numpy.gradient(ground, 12 / quads)
    normals = numpy.stack((-slope_x, numpy.ones_like(ground), slope_z), -1)
    normals /= numpy.linalg.norm(normals, axis=-1, keepdims=True)
    material = glb.material(textured(glb, 512, 3)[0], roughness=0.8)
    glb.node(glb.mesh(positions, normals.reshape(-1, 3), texcoords, indices, material))
    return glb.data()


def globe(size):
    """A globe of 65,536 triangles, 1 m in radius, with two textures of size² texels."""
    glb = Glb()
    base, normal = textured(glb, size, 5)

    def place(u, v):
        turn, up = 2 * numpy.pi * u, numpy.pi * (v - 0.5)
        return numpy.stack((numpy.cos(up) * numpy.sin(turn), numpy.sin(up), numpy.cos(up) * numpy.cos(turn)), -1)
    glb.node(glb.mesh(*surface(place, 128, 256), glb.material(base, normal, 0.0, 0.4)))
    return glb.data()


def lit_hall(kind, count):
    document = hall(kind, count)
    return binary(document.json, bytes(document.binary))


def main():
    name, *words, output = sys.argv[1:]
    makers = {"atrium": atrium, "million": lambda: heights(707), "thousand": lambda: lit_hall("point", 1000),
              "textures8k": lambda: globe(8192), "heights": lambda quads: heights(int(quads)),
              "hall": lambda kind, count: lit_hall(kind, int(count)), "globe": lambda size: globe(int(size))}
    if name not in makers:
        sys.exit(f"{name}: is none of {', '.join(makers)}")
    Path(output).write_bytes(makers[name](*words))


if __name__ == "__main__":
    main()
