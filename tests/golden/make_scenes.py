#!/usr/bin/env python3
"""Makes scenes/: a white Lambert plane under one kind of light each, seen from straight above, so that every pixel is
known in closed form. known_pixels() prints those that suite.json asserts.

usage: make_scenes.py [--pixels]
"""
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "tools"))
from scenes.geometry import floor, rectangle  # noqa: E402
from scenes.gltf import Document  # noqa: E402

DOWN = (-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))  # turns -z into -y
HEIGHT = 1.0  # of the lights over the plane [m]
SIZE = 64  # pixels along an edge; the camera sees [-1, 1]² of the plane
POINT = {"name": "point", "type": "point", "color": [1.0, 0.5, 0.25], "intensity": 1.0}
SPOT = {"name": "spot", "type": "spot", "color": [0.25, 1.0, 0.5], "intensity": 2.0,
        "spot": {"innerConeAngle": 0.3, "outerConeAngle": 0.6}}
SUN = {"name": "sun", "type": "directional", "color": [1.0, 0.9, 0.8], "intensity": 3.0}
RECTANGLE = {"name": "rectangle", "type": "rect", "color": [1.0, 0.8, 0.6], "intensity": 5.0, "size": 0.5,
             "rect": {"aspect": 2.0}}


def plane():
    document = Document("CC0")
    white = document.material("white", (1.0, 1.0, 1.0), roughness=1, lambert=True)
    document.node("plane", mesh=document.mesh("plane", (floor(4, 4), white)))
    camera = document.add("cameras", {"name": "above", "type": "orthographic",
                                      "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.01, "zfar": 10}})
    document.node("above", camera=camera, translation=(0, 3, 0), rotation=DOWN)
    return document


def lit_by(*lights):
    document = plane()
    for extension, light, place in lights:
        document.light(extension, light, translation=place, rotation=DOWN)
    return document


def emissive():
    """The rectangle light's twin: a surface of the same size and luminance that emits."""
    document = plane()
    emission = [5.0 * channel for channel in RECTANGLE["color"]]
    lamp = document.material("lamp", (0, 0, 0), roughness=1, lambert=True, emission=emission)
    # A rectangle faces +z; turned like the light, it faces down.
    facing_down = (math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))
    document.node("lamp", mesh=document.mesh("lamp", (rectangle(1.0, 0.5), lamp)), translation=(0, HEIGHT, 0),
                  rotation=facing_down)
    return document


PUNCTUAL, AREA = "KHR_lights_punctual", "EXT_lights_area"
ABOVE = (0, HEIGHT, 0)
SCENES = {
    "point": lambda: lit_by((PUNCTUAL, POINT, ABOVE)),
    "spot": lambda: lit_by((PUNCTUAL, SPOT, ABOVE)),
    "sun": lambda: lit_by((PUNCTUAL, SUN, ABOVE)),
    "rectangle": lambda: lit_by((AREA, RECTANGLE, ABOVE)),
    "emissive": emissive,
    "two_lights": lambda: lit_by((PUNCTUAL, POINT, (-0.5, HEIGHT, 0)), (PUNCTUAL, SPOT, (0.5, HEIGHT, 0))),
}


def position(pixel):
    """Of a pixel's centre along one axis of the plane [m]."""
    return (pixel + 0.5) / (SIZE / 2) - 1


def radiance_under_point(x, y, centre=0.0):
    """L = ρ/π · I cosθ / d² = I/π · h / (h² + r²)^(3/2)"""
    r2 = (position(x) - centre) ** 2 + position(y) ** 2
    return [c * HEIGHT / (math.pi * (HEIGHT**2 + r2) ** 1.5) for c in POINT["color"]]


def irradiance_of_corner(a, b):
    """E / L of a rectangle a × b at distance h, straight below one of its corners (Lambert 1760; Howell, factor C-11)."""
    a, b = a / HEIGHT, b / HEIGHT
    ra, rb = math.sqrt(1 + a * a), math.sqrt(1 + b * b)
    return 0.5 * (a / ra * math.atan(b / ra) + b / rb * math.atan(a / rb))


def radiance_under_rectangle(x, y):
    """Four rectangles that meet above the pixel, with signs."""
    px, py = position(x), position(y)
    sum_of_corners = sum(math.copysign(1, u * v) * irradiance_of_corner(abs(u), abs(v))
                         for u in (0.5 - px, 0.5 + px) for v in (0.25 - py, 0.25 + py))
    return [5.0 * c * sum_of_corners / math.pi for c in RECTANGLE["color"]]


def known_pixels():
    rows = {
        "point": [((x, y), radiance_under_point(x, y)) for x, y in ((32, 32), (8, 32), (60, 4))],
        "sun": [((x, y), [3.0 * c / math.pi for c in SUN["color"]]) for x, y in ((0, 0), (40, 20))],
        "rectangle": [((x, y), radiance_under_rectangle(x, y)) for x, y in ((32, 32), (10, 40), (56, 8))],
    }
    for name, pixels in rows.items():
        for (x, y), radiance in pixels:
            print(f'{name}: {{"at": [{x}, {y}], "radiance": {[float(f"{v:.6g}") for v in radiance]}}}')


if __name__ == "__main__":
    if "--pixels" in sys.argv[1:]:
        known_pixels()
    else:
        (HERE / "scenes").mkdir(exist_ok=True)
        for scene, make in SCENES.items():
            (HERE / "scenes" / f"{scene}.gltf").write_text(make().text(), encoding="ascii")
