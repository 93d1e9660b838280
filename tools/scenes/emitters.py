"""The zoo's second house: the emitters that glTF says only through extras.steradian and EXT_lights_ies."""
import math

from . import downlight, png
from .gltf import Document
from .vector import looking, rotation_about, rotation_facing
from .zoo import LIGHT_HEIGHT, PITCH, Furniture

FILE = "emitters.gltf"

BOOTHS = ("disk", "sphere", "tube", "polygon", "picture", "IES lamp")
# A phosphor's two lines and its green and red bands, roughly: [nm, relative power].
NEON_TUBE = ((400, 0.0), (430, 0.1), (436, 1.0), (442, 0.15), (500, 0.2), (540, 0.4), (546, 1.4), (552, 0.45),
             (600, 0.7), (611, 1.3), (622, 0.4), (700, 0.0))


def booth_x(name):
    return PITCH * (BOOTHS.index(name) - (len(BOOTHS) - 1) / 2)


def window_panes(size=16):
    """Four panes of coloured glass behind a dark cross, encoded as sRGB."""
    colors = (((230, 70, 40), (250, 200, 60)), ((60, 120, 230), (60, 200, 120)))
    half = size // 2
    return [[(12, 12, 12) if row % half in (0, half - 1) or column % half in (0, half - 1)
             else colors[row // half][column // half] for column in range(size)] for row in range(size)]


def hexagon(radius):
    """Counter-clockwise seen from below, where it emits to: the node's -Z."""
    return [[round(radius * math.cos(-i * math.pi / 3), 4), round(radius * math.sin(-i * math.pi / 3), 4), 0]
            for i in range(6)]


def add_lights(document):
    down = rotation_facing((0, -1, 0), up=(0, 0, -1))
    picture = document.texture("panes", png.rgb(window_panes()))
    lights = {
        "disk": {"shape": "disk", "radius": 0.16, "quantity": {"value": 90, "unit": "lm"}, "temperature": 2700},
        "sphere": {"shape": "sphere", "radius": 0.09, "quantity": {"value": 14, "unit": "cd"},
                   "color": [1.0, 0.62, 0.28]},
        "tube": {"shape": "tube", "radius": 0.015, "length": 0.7, "quantity": {"value": 0.5, "unit": "W"},
                 "spectrum": [list(pair) for pair in NEON_TUBE]},
        "polygon": {"shape": "polygon", "corners": hexagon(0.22), "quantity": {"value": 220, "unit": "cd/m^2"},
                    "color": [0.4, 1.0, 0.45]},
        "picture": {"shape": "rectangle", "width": 0.5, "height": 0.5, "texture": picture,
                    "quantity": {"value": 700, "unit": "nit"}},
    }
    for name, stated in lights.items():
        placement = {"translation": (booth_x(name), LIGHT_HEIGHT, 0.1), "rotation": down}
        if name == "picture":  # hangs at the back like a window, and is seen
            placement = {"translation": (booth_x(name), 0.75, -0.4), "rotation": rotation_about((0, 1, 0), 180)}
        document.node(name, extras={"steradian": stated}, **placement)
    document.use("EXT_lights_ies")
    document.json.setdefault("extensions", {})["EXT_lights_ies"] = {
        "lights": [{"name": "downlight", "uri": downlight.FILE}]}
    document.node("IES lamp", extensions={"EXT_lights_ies": {"light": 0, "multiplier": 0.2, "color": [1.0, 0.8, 0.6]}},
                  extras={"steradian": {"radius": 0.03}},
                  translation=(booth_x("IES lamp"), 1.0, 0.1), rotation=down)


def make():
    document = Document("CC0")
    furniture = Furniture(document)
    for number, name in enumerate(BOOTHS, 1):
        furniture.place(number, booth_x(name), has_roof=True)
    add_lights(document)
    document.camera("main", 0.275, 4.6, 0.01, **looking((0, 1.55, 8.1), (0, 0.5, 0)))
    for name in BOOTHS:
        document.camera(name, 0.5, 1.0, 0.01, **looking((booth_x(name), 0.95, 2.9), (booth_x(name), 0.5, 0)))
    return document.text()
