"""What light goes through: three coloured panes in the sun, a bottle, a block that attenuates, a leaf lit from behind."""
import math

from .geometry import Geometry, arc, box, floor, grid_indices, lathe, rectangle
from .gltf import Document
from .vector import looking, normalized

FILE = "glass.gltf"

PANES = (("amber", (0.95, 0.55, 0.12)), ("green", (0.25, 0.85, 0.35)), ("blue", (0.15, 0.35, 0.95)))
PANE, GAP = 0.42, 0.04  # [m]


def glass(document, name, color, ior=1.5, **volume):
    number = document.material(name, color, roughness=0.05)
    document.use("KHR_materials_transmission")
    document.use("KHR_materials_ior")
    extensions = {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": ior}}
    if volume:
        document.use("KHR_materials_volume")
        extensions["KHR_materials_volume"] = volume
    document.json["materials"][number]["extensions"] = extensions
    return number


def add_window(document):
    wood = document.material("wood", (0.22, 0.13, 0.08), roughness=0.7)
    width = len(PANES) * PANE + (len(PANES) + 1) * GAP
    bar, post = box(width, GAP, GAP), box(GAP, PANE, GAP)
    z = -0.5
    for y in (0, GAP + PANE):
        document.node("frame", mesh=document.mesh("frame", (bar, wood)), translation=(0, y, z))
    for i in range(len(PANES) + 1):
        document.node("frame", mesh=document.mesh("post", (post, wood)),
                      translation=(-width / 2 + GAP / 2 + i * (PANE + GAP), GAP, z))
    pane = rectangle(PANE, PANE)
    for i, (name, color) in enumerate(PANES):
        number = glass(document, name, color)
        document.json["materials"][number]["doubleSided"] = True
        document.node(name, mesh=document.mesh(name, (pane, number)),
                      translation=((i - 1) * (PANE + GAP), GAP + PANE / 2, z))


def add_bottle(document):
    number = glass(document, "bottle", (0.55, 0.85, 0.6))
    document.json["materials"][number]["doubleSided"] = True
    outline = [(0.0, 0.012), (0.05, 0.004), *arc((0.062, 0.014), 0.01, -90, 0, 3), (0.072, 0.19),
               *arc((0.032, 0.19), 0.04, 10, 80, 5), (0.02, 0.26), (0.019, 0.3), (0.024, 0.302), (0.024, 0.316)]
    document.node("bottle", mesh=document.mesh("bottle", (lathe(outline, segments=48), number)),
                  translation=(-0.42, 0, 0.12))


def add_block(document):
    number = glass(document, "block", (1, 1, 1), thicknessFactor=0.14, attenuationDistance=0.1,
                   attenuationColor=[0.95, 0.45, 0.25])
    document.node("block", mesh=document.mesh("block", (box(0.14, 0.14, 0.14), number)), translation=(0.4, 0, 0.2),
                  rotation=(0, math.sin(0.3), 0, math.cos(0.3)))


def bent_leaf(length, width, rows=13, columns=7):
    """A leaf along +y that bends towards +z; its edge is a sine."""
    result = Geometry([], [], grid_indices(rows, columns))
    for row in range(rows):
        t = row / (rows - 1)
        half = width / 2 * math.sin(math.pi * min(max(t, 0.02), 0.98)) ** 0.8
        for column in range(columns):
            s = 2 * column / (columns - 1) - 1
            result.positions.append((s * half, t * length, 0.35 * length * t * t + 0.25 * half * s * s))
            result.normals.append(normalized((-0.5 * s, -0.7 * t, 1.0)))
    return result


def add_leaf(document):
    number = document.material("leaf", (0.12, 0.26, 0.05), roughness=0.6)
    document.use("KHR_materials_diffuse_transmission")
    document.json["materials"][number].update(
        doubleSided=True, extensions={"KHR_materials_diffuse_transmission": {
            "diffuseTransmissionFactor": 0.6, "diffuseTransmissionColorFactor": [0.5, 0.85, 0.12]}})
    leaf = document.mesh("leaf", (bent_leaf(0.3, 0.13), number))
    for i, turn in enumerate((-0.9, 0.15, 1.1)):
        document.node(f"leaf {i + 1}", mesh=leaf, translation=(0.02 + 0.02 * i, 0, 0.3),
                      rotation=(0, math.sin(turn / 2), 0, math.cos(turn / 2)))


def make():
    document = Document("CC0")
    stone = document.material("floor", (0.6, 0.6, 0.6), roughness=1, lambert=True)
    document.node("floor", mesh=document.mesh("floor", (floor(8, 8), stone)))
    add_window(document)
    add_bottle(document)
    add_block(document)
    add_leaf(document)
    document.light("KHR_lights_punctual", {"name": "sun", "type": "directional", "color": [1.0, 0.95, 0.88],
                                           "intensity": 12.0, "extras": {"steradian": {"angular_diameter": 0.02}}},
                   **looking((-0.5, 1.5, -2.0), (0, 0, 0)))
    document.light("EXT_lights_area", {"name": "sky", "type": "rect", "color": [0.75, 0.86, 1.0], "intensity": 1.2,
                                       "size": 2.0, "rect": {"aspect": 1.5}}, **looking((0.8, 2.2, 1.6), (0, 0.1, 0)))
    document.camera("main", 0.5, 1.5, 0.01, **looking((0.15, 0.85, 1.9), (0, 0.17, -0.02)))
    return document.text()
