"""One light of each kind, each over its own booth with the same three objects. Pips on the front step count booths."""
import math

from .geometry import box, floor, lathe, merged, rectangle, rounded_box, sphere
from .gltf import Document
from .vector import looking, rotation_about, rotation_facing

FILE = "zoo.gltf"

PITCH = 1.5  # between the middles of two booths [m]
WIDTH, HEIGHT, DEPTH, WALL = 1.1, 1.1, 0.9, 0.04  # of a booth [m]
BOOTHS = ("point", "spot", "directional", "rectangle", "emissive quad")
LIGHT_HEIGHT = 0.85  # [m]


def shifted(geometry, offset):
    geometry.positions = [tuple(a + b for a, b in zip(position, offset)) for position in geometry.positions]
    return geometry


def booth_walls(has_roof):
    """Back, sides and roof. The sun's booth has no roof."""
    parts = [shifted(box(WIDTH + 2 * WALL, HEIGHT, WALL), (0, 0, -DEPTH / 2 - WALL / 2))]
    for side in (-1, 1):
        parts.append(shifted(box(WALL, HEIGHT, DEPTH), (side * (WIDTH + WALL) / 2, 0, 0)))
    if has_roof:
        parts.append(shifted(box(WIDTH + 2 * WALL, WALL, DEPTH + WALL), (0, HEIGHT, -WALL / 2)))
    return merged(*parts)


class Furniture:
    """The meshes that every booth has."""

    def __init__(self, document):
        self.document = document
        paint = document.material("booth", (0.55, 0.55, 0.55), roughness=0.9)
        glossy = document.material("glossy ball", (0.02, 0.02, 0.025), roughness=0.12)
        matte = document.material("matte block", (0.75, 0.75, 0.75), roughness=1, lambert=True)
        metal = document.material("metal cone", (0.95, 0.93, 0.88), metallic=1, roughness=0.35)
        self.pip_material = document.material("pip", (0.9, 0.9, 0.9), roughness=0.6)
        self.pip = document.mesh("pip", (sphere(0.022, 12), self.pip_material))
        self.roofed = document.mesh("booth", (booth_walls(True), paint))
        self.open = document.mesh("open booth", (booth_walls(False), paint))
        self.ground = document.mesh("ground", (floor(WIDTH + 0.2, DEPTH + 0.5), paint))
        self.ball = document.mesh("ball", (sphere(0.13, 32), glossy))
        self.block = document.mesh("block", (rounded_box(0.22, 0.3, 0.22, 0.01), matte))
        self.cone = document.mesh("cone", (lathe([(0.15, 0), (0.0, 0.36)], segments=40), metal))

    def place(self, number, x, has_roof):
        document = self.document
        booth = document.node(f"booth {number}", translation=(x, 0, 0))
        document.node(f"walls {number}", booth, mesh=self.roofed if has_roof else self.open)
        document.node(f"ground {number}", booth, mesh=self.ground, translation=(0, 0, 0.2))
        document.node(f"ball {number}", booth, mesh=self.ball, translation=(-0.27, 0.13, 0.12))
        document.node(f"block {number}", booth, mesh=self.block, translation=(0.05, 0.15, -0.2),
                      rotation=rotation_about((0, 1, 0), 28))
        document.node(f"cone {number}", booth, mesh=self.cone, translation=(0.3, 0, 0.1))
        for pip in range(number):
            document.node(f"pip {number}.{pip + 1}", booth, mesh=self.pip,
                          translation=(0.09 * (pip - (number - 1) / 2), 0.022, 0.5))


def booth_x(name):
    return PITCH * (BOOTHS.index(name) - (len(BOOTHS) - 1) / 2)


def add_lights(document):
    down = rotation_facing((0, -1, 0), up=(0, 0, -1))
    document.light("KHR_lights_punctual", {"name": "point", "type": "point", "color": [1.0, 0.62, 0.28], "intensity": 14.0},
                   translation=(booth_x("point"), LIGHT_HEIGHT, 0.1))
    document.light("KHR_lights_punctual",
                   {"name": "spot", "type": "spot", "color": [0.4, 1.0, 0.45], "intensity": 40.0,
                    "spot": {"innerConeAngle": math.radians(18), "outerConeAngle": math.radians(27)}},
                   **looking((booth_x("spot"), 1.0, 0.35), (booth_x("spot"), 0.1, -0.02)))
    document.light("KHR_lights_punctual", {"name": "directional", "type": "directional", "color": [0.5, 0.68, 1.0],
                                           "intensity": 12.0}, rotation=rotation_facing((-0.25, -1.0, -0.45)))
    document.light("EXT_lights_area", {"name": "rectangle", "type": "rect", "color": [1.0, 0.4, 0.75], "intensity": 120.0,
                                       "size": 0.3, "rect": {"aspect": 2.0}},
                   translation=(booth_x("rectangle"), LIGHT_HEIGHT, 0.1), rotation=down)
    glow = document.material("emissive quad", (0, 0, 0), roughness=1, lambert=True, emission=(130.0, 125.0, 95.0))
    quad = document.mesh("emissive quad", (rectangle(0.5, 0.36), glow))
    document.node("emissive quad", mesh=quad, translation=(booth_x("emissive quad"), 0.78, -0.3),
                  rotation=rotation_about((1, 0, 0), 50))


def make():
    document = Document("CC0")
    furniture = Furniture(document)
    for number, name in enumerate(BOOTHS, 1):
        furniture.place(number, booth_x(name), has_roof=name != "directional")
    add_lights(document)
    document.camera("main", 0.275, 4.0, 0.01, **looking((0, 1.55, 7.6), (0, 0.5, 0)))
    for name in BOOTHS:
        document.camera(name, 0.5, 1.0, 0.01, **looking((booth_x(name), 0.95, 2.9), (booth_x(name), 0.5, 0)))
    return document.text()
