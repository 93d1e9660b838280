"""The Cornell box, from the measurements that Cornell's Program of Computer Graphics published with it."""
import math

from . import spectrum
from .cornell_reflectance import GREEN, RED, WAVELENGTHS, WHITE
from .geometry import merged, polygon
from .gltf import Document
from .spectrum import with_luminance

FILE = "cornell.gltf"

# Cornell Box Data, millimetres, in the order in which they are published.
FLOOR = ((552.8, 0, 0), (0, 0, 0), (0, 0, 559.2), (549.6, 0, 559.2))
LIGHT = ((343, 548.8, 227), (343, 548.8, 332), (213, 548.8, 332), (213, 548.8, 227))
CEILING = ((556, 548.8, 0), (556, 548.8, 559.2), (0, 548.8, 559.2), (0, 548.8, 0))
BACK_WALL = ((549.6, 0, 559.2), (0, 0, 559.2), (0, 548.8, 559.2), (556, 548.8, 559.2))
RIGHT_WALL = ((0, 0, 559.2), (0, 0, 0), (0, 548.8, 0), (0, 548.8, 559.2))
LEFT_WALL = ((552.8, 0, 0), (549.6, 0, 559.2), (556, 548.8, 559.2), (556, 548.8, 0))
SHORT_BLOCK = ((130, 165, 65), (82, 165, 225), (240, 165, 272), (290, 165, 114))
TALL_BLOCK = ((423, 330, 247), (265, 330, 296), (314, 330, 456), (472, 330, 406))
EYE, FOCAL_LENGTH, FILM = (278, 273, -800), 0.035, 0.025

LIGHT_SPECTRUM = ((400, 0.0), (500, 8.0), (600, 15.6), (700, 18.4))
LIGHT_REFLECTANCE = 0.78
# The published spectrum is relative. An 800 lm lamp (60 W incandescent) makes it absolute: L = Φ / (π A).
LIGHT_FLUX = 800.0


def metres(point):
    return tuple(coordinate / 1000 for coordinate in point)


def face(corners):
    return polygon(*map(metres, corners))


def bent_wall(corners):
    """Two flat triangles: the four measured corners of the left wall do not lie in one plane."""
    a, b, c, d = map(metres, corners)
    return merged(polygon(a, b, c), polygon(a, c, d))


def ceiling_around_light():
    """The ceiling has a hole where the lamp is."""
    sides = []
    for i in range(4):
        j = (i + 1) % 4
        sides.append(face((CEILING[i], CEILING[j], LIGHT[j], LIGHT[i])))
    return merged(*sides)


def block(top):
    sides = [face(top)]
    for i in range(4):
        near, far = top[i], top[(i + 1) % 4]
        sides.append(face((near, (near[0], 0, near[2]), (far[0], 0, far[2]), far)))
    return merged(*sides)


def light_power(wavelength):
    for (start, low), (stop, high) in zip(LIGHT_SPECTRUM, LIGHT_SPECTRUM[1:]):
        if wavelength <= stop:
            return low + (high - low) * (wavelength - start) / (stop - start)
    return LIGHT_SPECTRUM[-1][1]


def color_under_light(reflectance):
    """RGB(light · reflectance) / RGB(light), a channel at a time: times the light's RGB it is the spectral answer,
    exactly, for light that is reflected once."""
    reflected = dict(zip(WAVELENGTHS, reflectance))
    both = spectrum.linear_rgb(lambda w: light_power(w) * reflected[w], WAVELENGTHS)
    light = spectrum.linear_rgb(light_power, WAVELENGTHS)
    return tuple(round(a / b, 4) for a, b in zip(both, light))


def light_emission():
    width, depth = (LIGHT[0][0] - LIGHT[2][0]) / 1000, (LIGHT[1][2] - LIGHT[0][2]) / 1000
    color = spectrum.linear_rgb(light_power, WAVELENGTHS)
    return with_luminance(color, LIGHT_FLUX / (math.pi * width * depth))


def make():
    document = Document("CC0; measurements: Cornell University Program of Computer Graphics, Cornell Box Data")
    white = document.material("white", color_under_light(WHITE), roughness=1, lambert=True)
    green = document.material("green", color_under_light(GREEN), roughness=1, lambert=True)
    red = document.material("red", color_under_light(RED), roughness=1, lambert=True)
    lamp = document.material("lamp", [LIGHT_REFLECTANCE] * 3, roughness=1, lambert=True, emission=light_emission())
    parts = [("floor", face(FLOOR), white), ("ceiling", ceiling_around_light(), white),
             ("back wall", face(BACK_WALL), white), ("right wall", face(RIGHT_WALL), green),
             ("left wall", bent_wall(LEFT_WALL), red), ("short block", block(SHORT_BLOCK), white),
             ("tall block", block(TALL_BLOCK), white), ("lamp", face(LIGHT), lamp)]
    for name, geometry, material in parts:
        document.node(name, mesh=document.mesh(name, (geometry, material)))
    # Cornell's camera looks along +z: half a turn about y.
    document.camera("main", 2 * math.atan(FILM / 2 / FOCAL_LENGTH), 1.0, 0.01, translation=metres(EYE),
                    rotation=(0, 1, 0, 0))
    return document.text()
