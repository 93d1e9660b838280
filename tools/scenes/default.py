"""The default scene: a robot with a lantern, a globe with one steradian in gold, and neon over polished tiles."""
import math

from . import textures
from .geometry import arc, box, cylinder, floor, lathe, rectangle, sphere, torus
from .gltf import Document
from .robot import Robot
from .spectrum import with_luminance
from .vector import cross, looking, normalized, rotation_about, rotation_from_axes

FILE = "default.gltf"

GLOBE, GLOBE_RADIUS, PLINTH_HEIGHT = (0.16, 0.38, -0.12), 0.2, 0.18
# A cone of one steradian: 2π (1 - cos σ) = 1.
STERADIAN_HALF_ANGLE = math.acos(1 - 1 / (2 * math.pi))

# Neon: position of the middle, turn about y [deg], colour, luminance [cd/m²].
NEON_SIZE = (0.06, 0.94)  # [m]
NEON = (("magenta neon", (-0.98, 0.53, -0.5), 24, (1.0, 0.05, 0.4), 110.0),
        ("amber neon", (-0.74, 0.53, -0.66), 16, (1.0, 0.36, 0.03), 190.0),
        ("cyan neon", (0.78, 0.53, -0.66), -16, (0.03, 0.7, 1.0), 190.0),
        ("violet neon", (1.02, 0.53, -0.5), -24, (0.34, 0.1, 1.0), 80.0))

# The row of balls: colour, metalness, roughness.
BALLS = (("gold", (1.0, 0.77, 0.34), 1, 0.35), ("copper", (0.95, 0.58, 0.45), 1, 0.5),
         ("teal glaze", (0.01, 0.3, 0.3), 0, 0.08), ("raspberry satin", (0.55, 0.03, 0.12), 0, 0.4),
         ("chalk", (0.82, 0.8, 0.76), 0, 1.0))
BALL_RADIUS = 0.062  # [m]


def add_room(document):
    tiled = document.material("terrazzo tiles", (0.8, 0.8, 0.8), roughness=1,
                              base_color_texture=document.texture("terrazzo", textures.terrazzo()),
                              metallic_roughness_texture=document.texture("tile roughness", textures.tiles()))
    padded = document.material("quilted wall", (0.13, 0.14, 0.2), roughness=0.55,
                               normal_texture=document.texture("quilt", textures.quilt()), normal_scale=0.6)
    ground = document.mesh("floor", (floor(6, 4.2, tiles=(12, 8.4)), tiled))
    document.node("floor", mesh=ground, translation=(0, 0, 1))
    document.node("wall", mesh=document.mesh("wall", (rectangle(6, 3, tiles=(30, 15)), padded)),
                  translation=(0, 1.5, -1.1))


def add_neon(document):
    casing = document.material("neon casing", (0.02, 0.02, 0.02), roughness=0.5)
    tube = rectangle(*NEON_SIZE)
    case = document.mesh("neon casing", (box(NEON_SIZE[0] + 0.016, NEON_SIZE[1] + 0.016, 0.03), casing))
    for name, place, turn, color, luminance in NEON:
        glow = document.material(name, (0, 0, 0), roughness=1, lambert=True, emission=with_luminance(color, luminance))
        lamp = document.node(name, mesh=document.mesh(name, (tube, glow)), translation=place,
                             rotation=rotation_about((0, 1, 0), turn))
        document.node(f"{name} casing", lamp, mesh=case, translation=(0, -NEON_SIZE[1] / 2 - 0.008, -0.018))


def add_globe(document, ball):
    brushed = document.texture("brushed", textures.brushed())
    steel = document.material("brushed steel", (0.5, 0.5, 0.53), metallic=1, roughness=1,
                              metallic_roughness_texture=brushed)
    ivory = document.material("ivory glaze", (0.78, 0.74, 0.66), roughness=0.16)
    gold = document.material("gold leaf", (1.0, 0.72, 0.28), metallic=1, roughness=0.28)
    plinth = cylinder(0.17, PLINTH_HEIGHT, 0.012, 44, is_textured=True)
    document.node("plinth", mesh=document.mesh("plinth", (plinth, steel)), translation=(GLOBE[0], 0, GLOBE[2]))
    globe = document.node("globe", translation=GLOBE)
    document.node("ivory", globe, mesh=document.mesh("ivory", (ball, ivory)), scale=(GLOBE_RADIUS,) * 3)
    angle = math.degrees(STERADIAN_HALF_ANGLE)
    cap = lathe(arc((0, 0), GLOBE_RADIUS * 1.006, 90 - angle, 90, 9), segments=44)
    ring = torus(GLOBE_RADIUS * math.sin(STERADIAN_HALF_ANGLE), 0.006, 44, 6)
    axis = normalized((-0.5, 0.42, 0.76))
    right = normalized(cross(axis, (0, 0, 1)))
    tilt = document.node("one steradian", globe, rotation=rotation_from_axes(right, axis, cross(right, axis)),
                         mesh=document.mesh("one steradian", (cap, gold)))
    document.node("rim", tilt, mesh=document.mesh("rim", (ring, gold)),
                  translation=(0, GLOBE_RADIUS * math.cos(STERADIAN_HALF_ANGLE), 0))


def add_balls(document, ball):
    for i, (name, color, metallic, roughness) in enumerate(BALLS):
        material = document.material(name, color, metallic=metallic, roughness=roughness)
        place = (-0.12 + 0.165 * i, BALL_RADIUS, 0.34 - 0.012 * i * i)
        document.node(name, mesh=document.mesh(name, (ball, material)), translation=place, scale=(BALL_RADIUS,) * 3)


def add_hidden_lights(document):
    """A softbox above the camera, and a strip behind the stage that washes the wall."""
    document.light("EXT_lights_area", {"name": "softbox", "type": "rect", "color": [1.0, 0.93, 0.84], "intensity": 280.0,
                                       "size": 0.7, "rect": {"aspect": 1.6}}, **looking((-0.5, 1.75, 1.3), (0, 0.2, 0)))
    document.light("EXT_lights_area", {"name": "wall wash", "type": "rect", "color": [0.25, 0.32, 1.0],
                                       "intensity": 170.0, "size": 0.16, "rect": {"aspect": 11.0}},
                   **looking((0, 0.05, -0.72), (0, 0.45, -1.1)))


def make():
    document = Document("CC0")
    add_room(document)
    add_neon(document)
    ball = sphere(1.0, 36)
    add_globe(document, ball)
    Robot(document, ball).add(translation=(-0.42, 0, 0.12), rotation=rotation_about((0, 1, 0), 22))
    add_balls(document, ball)
    add_hidden_lights(document)
    document.camera("main", 0.43, 16 / 9, 0.01, **looking((0.0, 0.66, 2.5), (0.0, 0.3, 0.0)))
    return document.text()
