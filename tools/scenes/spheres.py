"""Twenty-one spheres: roughness along the rows, from dielectric to metal across them."""
from .geometry import box, rectangle, rounded_box, sphere
from .gltf import Document
from .vector import looking

FILE = "spheres.gltf"

ROUGHNESS = (0.05, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0)
ROWS = (("dielectric", 0.0), ("half", 0.5), ("metal", 1.0))  # front to back
COLOR = (0.72, 0.2, 0.06)
RADIUS, PITCH = 0.05, 0.125  # [m]
STEP_HEIGHT, STEP_DEPTH = 0.075, 0.15


def add_stairs(document):
    stone = document.material("stairs", (0.3, 0.32, 0.36), roughness=0.85)
    width = PITCH * len(ROUGHNESS) + 0.06
    for row in range(len(ROWS)):
        step = rounded_box(width, STEP_HEIGHT * (row + 1), STEP_DEPTH, radius=0.004, steps=1)
        document.node(f"step {row + 1}", mesh=document.mesh(f"step {row + 1}", (step, stone)),
                      translation=(0, STEP_HEIGHT * (row + 1) / 2, -STEP_DEPTH * row))
    wall = document.material("wall", (0.4, 0.42, 0.46), roughness=1)
    ground = box(6, 0.02, 4)
    document.node("ground", mesh=document.mesh("ground", (ground, wall)), translation=(0, -0.02, 0))
    document.node("wall", mesh=document.mesh("wall", (rectangle(6, 4), wall)), translation=(0, 1.5, -0.75))


def add_spheres(document):
    ball = sphere(RADIUS, 40)
    for row, (kind, metallic) in enumerate(ROWS):
        for column, roughness in enumerate(ROUGHNESS):
            name = f"{kind} {roughness}"
            material = document.material(name, COLOR, metallic=metallic, roughness=roughness)
            place = (PITCH * (column - (len(ROUGHNESS) - 1) / 2), STEP_HEIGHT * (row + 1) + RADIUS, -STEP_DEPTH * row)
            document.node(name, mesh=document.mesh(name, (ball, material)), translation=place)


def make():
    document = Document("CC0")
    add_stairs(document)
    add_spheres(document)
    document.light("EXT_lights_area", {"name": "softbox", "type": "rect", "color": [1.0, 0.97, 0.92], "intensity": 2500.0,
                                       "size": 0.45, "rect": {"aspect": 1.6}},
                   **looking((-0.75, 1.05, 0.75), (0, 0.15, -0.12)))
    document.light("KHR_lights_punctual", {"name": "bulb", "type": "point", "color": [0.55, 0.72, 1.0], "intensity": 160.0},
                   translation=(0.85, 0.75, 0.7))
    document.camera("main", 0.36, 16 / 9, 0.01, **looking((0, 0.62, 1.55), (0, 0.155, -0.14)))
    return document.text()
