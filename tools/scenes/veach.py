"""Four glossy plates that mirror four lights of equal power: the scene that made multiple importance sampling famous."""
import math

from .geometry import floor, rectangle, rounded_box
from .gltf import Document
from .spectrum import with_luminance
from .vector import cross, looking, minus, normalized, plus, rotation_from_axes

FILE = "veach.gltf"

EYE, TARGET = (0.0, 1.3, 5.2), (0.0, 0.78, 0.0)

# Each light three times the size of the one before, and so a ninth of its luminance.
FLUX = 360.0  # Φ of each light [lm]
LIGHT_SIZES = (0.03, 0.09, 0.27, 0.81)  # edge of the square [m]
LIGHT_COLORS = ((0.4, 0.58, 1.0), (0.42, 1.0, 0.5), (1.0, 0.8, 0.36), (1.0, 0.45, 0.36))
LIGHT_X = (-1.38, -0.76, -0.02, 1.0)
LIGHT_Y, LIGHT_Z = 1.62, -1.0

# From the far plate to the near one: position of the middle, roughness (alpha = roughness²).
PLATES = (((0.0, 0.74, -0.42), 0.08), ((0.0, 0.44, 0.0), 0.16), ((0.0, 0.2, 0.5), 0.24), ((0.0, 0.03, 1.05), 0.34))
PLATE_SIZE = (3.0, 0.02, 0.44)  # [m]


def mirror_rotation(position):
    """Turns +y into the direction that mirrors the eye into the row of lights."""
    to_eye = normalized(minus(EYE, position))
    to_light = normalized(minus((0.0, LIGHT_Y, LIGHT_Z), position))
    up = normalized(plus(to_eye, to_light))
    right = (1.0, 0.0, 0.0)
    return rotation_from_axes(right, up, cross(right, up))


def add_lights(document):
    for size, color, x in zip(LIGHT_SIZES, LIGHT_COLORS, LIGHT_X):
        emission = with_luminance(color, FLUX / (math.pi * size * size))
        name = f"light {round(size * 1000)} mm"
        material = document.material(name, (0, 0, 0), roughness=1, lambert=True, emission=emission)
        mesh = document.mesh(name, (rectangle(size, size), material))
        document.node(name, mesh=mesh, translation=(x, LIGHT_Y, LIGHT_Z))


def make():
    document = Document("CC0; after the scene of Veach & Guibas 1995, figure 2")
    add_lights(document)
    plate = rounded_box(*PLATE_SIZE, radius=0.008)
    for i, (position, roughness) in enumerate(PLATES, 1):
        material = document.material(f"plate {i}", (0.46, 0.46, 0.48), metallic=1, roughness=roughness)
        document.node(f"plate {i}", mesh=document.mesh(f"plate {i}", (plate, material)), translation=position,
                      rotation=mirror_rotation(position))
    grey = document.material("wall", (0.3, 0.3, 0.32), roughness=1, lambert=True)
    document.node("floor", mesh=document.mesh("floor", (floor(12, 8), grey)), translation=(0, -0.2, 0))
    document.node("back wall", mesh=document.mesh("back wall", (rectangle(12, 6), grey)), translation=(0, 2.8, -1.6))
    document.light("KHR_lights_punctual", {"name": "fill", "type": "point", "color": [1.0, 1.0, 1.0], "intensity": 900.0},
                   translation=(0, 3.2, 2.2))
    document.camera("main", 0.5, 4 / 3, 0.01, **looking(EYE, TARGET))
    return document.text()
