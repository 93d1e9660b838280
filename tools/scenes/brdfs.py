"""Fifteen balls: the BRDFs that extras.steradian names, metals, and the layers of glTF's own material."""
from .geometry import arc, box, floor, lathe
from .gltf import Document
from .vector import looking

FILE = "brdfs.gltf"

RADIUS, PITCH = 0.5, 1.2  # [m]


def own(brdf, **properties):
    return {"extras": {"steradian": {"brdf": brdf, **properties}}}


def layer(name, **properties):
    return {"extensions": {f"KHR_materials_{name}": properties}}


# name, base colour, metallic, roughness, what else; three rows from top to bottom
ROWS = (
    (("lambert", (0.75, 0.45, 0.3), 0, 1, own("lambert")),
     ("oren_nayar", (0.75, 0.45, 0.3), 0, 1, own("oren_nayar")),
     ("phong", (0.25, 0.1, 0.4), 0, 1, own("phong", exponent=40, specular_color=[0.3, 0.3, 0.3])),
     ("blinn_phong", (0.25, 0.1, 0.4), 0, 1, own("blinn_phong", exponent=160, specular_color=[0.3, 0.3, 0.3])),
     ("mirror", (0.9, 0.9, 0.9), 1, 0, own("mirror"))),
    (("gold", (1, 1, 1), 1, 0.3, own("conductor", metal="gold")),
     ("copper", (1, 1, 1), 1, 0.3, own("conductor", metal="copper")),
     ("silver", (1, 1, 1), 1, 0.3, own("conductor", metal="silver")),
     ("iron", (1, 1, 1), 1, 0.3, own("conductor", metal="iron")),
     ("brushed ggx", (0.8, 0.82, 0.85), 1, 0.65, own("ggx", roughness_across=0.25))),
    (("anisotropy", (0.85, 0.6, 0.35), 1, 0.3, layer("anisotropy", anisotropyStrength=0.8, anisotropyRotation=1.5708)),
     ("clearcoat", (0.6, 0.02, 0.02), 0, 0.7, layer("clearcoat", clearcoatFactor=1, clearcoatRoughnessFactor=0.04)),
     ("sheen", (0.03, 0.05, 0.25), 0, 0.9, layer("sheen", sheenColorFactor=[0.8, 0.8, 0.9], sheenRoughnessFactor=0.45)),
     ("thin film", (0.35, 0.35, 0.35), 1, 0.3, layer("iridescence", iridescenceFactor=1, iridescenceIor=1.33,
                                                      iridescenceThicknessMaximum=420)),
     ("coated film", (0.05, 0.05, 0.05), 0, 0.3, layer("iridescence", iridescenceFactor=1, iridescenceIor=1.8,
                                                        iridescenceThicknessMaximum=600))),
)


def add_balls(document):
    ball = lathe(arc((0, 0), RADIUS, -90, 90, 20), segments=40, is_textured=True)
    for row, balls in enumerate(ROWS):
        for column, (name, color, metallic, roughness, more) in enumerate(balls):
            number = document.material(name, color, metallic=metallic, roughness=roughness)
            document.json["materials"][number].update(more)
            for extension in more.get("extensions", {}):
                document.use(extension)
            place = ((column - 2) * PITCH, RADIUS + (len(ROWS) - 1 - row) * PITCH, 0)
            document.node(name, mesh=document.mesh(name, (ball, number)), translation=place)


def add_room(document):
    paint = document.material("paint", (0.25, 0.25, 0.26), roughness=1, lambert=True)
    document.node("floor", mesh=document.mesh("floor", (floor(14, 8), paint)))
    document.node("wall", mesh=document.mesh("wall", (box(14, 6, 0.1), paint)), translation=(0, 0, -1.6))


def make():
    document = Document("CC0")
    add_balls(document)
    add_room(document)
    document.light("EXT_lights_area", {"name": "softbox", "type": "rect", "color": [1.0, 0.97, 0.92], "intensity": 900.0,
                                       "size": 1.6, "rect": {"aspect": 1.5}}, **looking((-3, 5, 4.5), (0, 1.5, 0)))
    document.light("EXT_lights_area", {"name": "strip", "type": "rect", "color": [0.7, 0.82, 1.0], "intensity": 900.0,
                                       "size": 3.0, "rect": {"aspect": 0.15}}, **looking((5, 2, 3), (0, 1.5, 0)))
    document.light("KHR_lights_punctual", {"name": "bulb", "type": "point", "color": [1.0, 1.0, 1.0], "intensity": 500.0},
                   translation=(0.5, 4.5, 5))
    document.camera("main", 0.4, 1.5, 0.01, **looking((0, 2.1, 10), (0, 1.7, 0)))
    return document.text()
