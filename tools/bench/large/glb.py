"""Writes glTF binaries from NumPy arrays."""
import io
import json
import struct

import numpy
from PIL import Image

FLOAT, UNSIGNED_INT, REPEAT = 5126, 5125, 10497
TRILINEAR, LINEAR = 9987, 9729


def binary(document: dict, buffer: bytes) -> bytes:
    """A glTF document and its buffer as one .glb."""
    buffer += b"\0" * (-len(buffer) % 4)
    text = json.dumps({**document, "buffers": [{"byteLength": len(buffer)}]}).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer)) + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


class Glb:
    """A file in the making. Methods return the index of what they add."""

    def __init__(self):
        self.json = {"asset": {"version": "2.0", "generator": "Steradian tools/bench/large"}, "scene": 0, "scenes": [{"nodes": []}],
                     "samplers": [{"magFilter": LINEAR, "minFilter": TRILINEAR, "wrapS": REPEAT, "wrapT": REPEAT}]}
        self.buffer = bytearray()

    def add(self, kind, item):
        self.json.setdefault(kind, []).append(item)
        return len(self.json[kind]) - 1

    def view(self, data):
        self.buffer.extend(b"\0" * (-len(self.buffer) % 4))
        start = len(self.buffer)
        self.buffer.extend(data)
        return self.add("bufferViews", {"buffer": 0, "byteOffset": start, "byteLength": len(data)})

    def accessor(self, rows, kind):
        rows = numpy.ascontiguousarray(rows, numpy.uint32 if kind == "SCALAR" else numpy.float32)
        item = {"bufferView": self.view(rows.tobytes()), "componentType": UNSIGNED_INT if kind == "SCALAR" else FLOAT,
                "count": len(rows), "type": kind}
        if kind == "VEC3":
            item.update(min=rows.min(0).tolist(), max=rows.max(0).tolist())
        return self.add("accessors", item)

    def texture(self, pixels):
        """@param pixels rows of 8-bit RGB; stored as JPEG"""
        data = io.BytesIO()
        Image.fromarray(pixels).save(data, "JPEG", quality=88)
        image = self.add("images", {"mimeType": "image/jpeg", "bufferView": self.view(data.getvalue())})
        return self.add("textures", {"sampler": 0, "source": image})

    def material(self, base_color, normal=None, metallic=0.0, roughness=0.6):
        """Textures by their index."""
        item = {"pbrMetallicRoughness": {"baseColorTexture": {"index": base_color}, "metallicFactor": metallic,
                                         "roughnessFactor": roughness}, "doubleSided": True}
        if normal is not None:
            item["normalTexture"] = {"index": normal}
        return self.add("materials", item)

    def mesh(self, positions, normals, texcoords, indices, material):
        attributes = {"POSITION": self.accessor(positions, "VEC3"), "NORMAL": self.accessor(normals, "VEC3"),
                      "TEXCOORD_0": self.accessor(texcoords, "VEC2")}
        return self.add("meshes", {"primitives": [{"attributes": attributes, "indices": self.accessor(indices, "SCALAR"),
                                                   "material": material}]})

    def node(self, mesh, **placement):
        node = self.add("nodes", {"mesh": mesh, **placement})
        self.json["scenes"][0]["nodes"].append(node)
        return node

    def data(self):
        return binary(self.json, bytes(self.buffer))


def surface(place, rows, columns, tiles=(1.0, 1.0)):
    """
    A grid of rows × columns quads over the unit square. @param place maps arrays u, v to positions, whose last axis is 3
    @return positions, unit normals along ∂/∂u × ∂/∂v, texture coordinates, indices: the arguments of Glb.mesh
    """
    v, u = numpy.meshgrid(numpy.linspace(0, 1, rows + 1), numpy.linspace(0, 1, columns + 1), indexing="ij")
    step = 1e-4
    normals = numpy.cross(place(u + step, v) - place(u - step, v), place(u, v + step) - place(u, v - step))
    lengths = numpy.linalg.norm(normals, axis=-1, keepdims=True)
    normals = numpy.where(lengths > 1e-12, normals / numpy.maximum(lengths, 1e-12), (0.0, 1.0, 0.0))
    corner = (numpy.arange(rows)[:, None] * (columns + 1) + numpy.arange(columns)[None, :]).reshape(-1, 1)
    indices = corner + numpy.array([0, 1, columns + 2, 0, columns + 2, columns + 1])
    texcoords = numpy.stack((u * tiles[0], v * tiles[1]), -1)
    return place(u, v).reshape(-1, 3), normals.reshape(-1, 3), texcoords.reshape(-1, 2), indices.reshape(-1)


def lattice_noise(size, cells, seed):
    """Smooth noise in [0, 1) that repeats at the edges: random numbers at cells², interpolated. @return size × size"""
    grid = numpy.random.default_rng(seed).random((cells, cells), numpy.float32)
    at = numpy.arange(size, dtype=numpy.float32) * (cells / size)
    low = at.astype(int) % cells
    share = at - numpy.floor(at)
    share = share * share * (3 - 2 * share)
    across = grid[:, low] * (1 - share) + grid[:, (low + 1) % cells] * share
    return across[low, :] * (1 - share[:, None]) + across[(low + 1) % cells, :] * share[:, None]


def fractal_noise(size, cells, octaves, seed):
    total = sum(lattice_noise(size, cells * 2**i, seed + i) * 0.5**i for i in range(octaves))
    return total / sum(0.5**i for i in range(octaves))


def normal_map(heights, strength):
    """The normals of a height field that repeats at its edges, as 8-bit RGB."""
    slope_x = (numpy.roll(heights, -1, 1) - numpy.roll(heights, 1, 1)) * strength
    slope_y = (numpy.roll(heights, -1, 0) - numpy.roll(heights, 1, 0)) * strength
    scale = 1 / numpy.sqrt(1 + slope_x**2 + slope_y**2)
    return (numpy.stack((-slope_x * scale, slope_y * scale, scale), -1) * 127.5 + 127.5).astype(numpy.uint8)
