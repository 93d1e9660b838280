"""A hall with pillars and steel balls under many lights of one kind, as a glTF document."""
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from scenes.geometry import box, floor, rectangle, sphere  # noqa: E402
from scenes.gltf import Document  # noqa: E402
from scenes.vector import looking  # noqa: E402

SIDE = 24.0  # of the hall [m]
KINDS = ("point", "sphere", "rectangle")
EYE, TARGET, FOV = (1.2, 2.3, SIDE / 2 - 0.5), (0.0, 0.8, 0.0), 0.9  # [m], [m], from bottom to top [rad]


def add_hall(document):
    plaster = document.material("plaster", (0.7, 0.68, 0.64), roughness=0.9)
    stone = document.material("stone", (0.5, 0.5, 0.52), roughness=0.5)
    steel = document.material("steel", (0.8, 0.8, 0.82), metallic=1.0, roughness=0.3)
    document.node("floor", mesh=document.mesh("floor", (floor(SIDE, SIDE), stone)))
    wall = document.mesh("wall", (rectangle(SIDE, 5.0), plaster))
    document.node("wall", mesh=wall, translation=(0, 2.5, -SIDE / 2))
    pillar, ball = document.mesh("pillar", (box(0.6, 3.0, 0.6), plaster)), document.mesh("ball", (sphere(0.4, 24), steel))
    for i in range(-2, 3):
        for j in range(-2, 3):
            document.node(f"pillar {i} {j}", mesh=pillar, translation=(4.4 * i, 0, 4.4 * j))
            document.node(f"ball {i} {j}", mesh=ball, translation=(4.4 * i + 2.2, 0.4, 4.4 * j + 1.6))


def hall(kind, count):
    """Lights of one kind at random places below the ceiling. Their power varies tenfold; their sum is the same for every count."""
    document = Document("CC0")
    add_hall(document)
    chance = random.Random(count)
    powers = [10.0 ** chance.uniform(-1.0, 0.0) for _ in range(count)]
    for i, power in enumerate(powers):
        place = [chance.uniform(-SIDE / 2, SIDE / 2), chance.uniform(2.0, 4.5), chance.uniform(-SIDE / 2, SIDE / 2)]
        light = {"name": f"{kind} {i}", "color": [1.0, chance.uniform(0.7, 1.0), chance.uniform(0.4, 1.0)]}
        share = power / sum(powers)
        if kind in ("point", "sphere"):
            form = {"extras": {"steradian": {"radius": chance.uniform(0.05, 0.3)}}} if kind == "sphere" else {}
            document.light("KHR_lights_punctual", {**light, **form, "type": "point", "intensity": 16000.0 * share}, translation=place)
            continue
        width, height = chance.uniform(0.2, 0.8), chance.uniform(0.2, 0.8)
        target = [place[0] + chance.uniform(-1.5, 1.5), 0.0, place[2] + chance.uniform(-1.5, 1.5)]
        document.light("EXT_lights_area", {**light, "type": "rect", "intensity": 60000.0 * share / (width * height), "size": height,
                                           "rect": {"aspect": width / height}}, **looking(place, target))
    document.camera("main", FOV, 16 / 9, 0.01, **looking(EYE, TARGET))
    return document
