"""An atrium of two storeys around a court: columns, arches, reliefs, curtains, urns. 100 draws of about 2,600 triangles."""
import numpy

from glb import Glb, fractal_noise, normal_map, surface

TEXTURE = 1024
HALF_LENGTH, HALF_WIDTH, STOREY = 12.0, 6.0, 4.0  # [m]
AISLE = 2.2                                       # of the columns from the walls [m]
COLORS = [(0.80, 0.72, 0.60), (0.62, 0.34, 0.26), (0.55, 0.56, 0.58), (0.70, 0.12, 0.10), (0.12, 0.32, 0.16), (0.14, 0.22, 0.52),
          (0.75, 0.62, 0.30), (0.42, 0.36, 0.30), (0.86, 0.84, 0.80), (0.30, 0.28, 0.34)]
TAU = 2 * numpy.pi


def pattern(kind):
    """The heights of a material's surface in [0, 1]: tiles, bricks, a weave, or stone with veins."""
    y, x = numpy.mgrid[0:TEXTURE, 0:TEXTURE] / TEXTURE
    noise = fractal_noise(TEXTURE, 4, 7, 10 * kind)
    if kind % 4 == 0:
        joints = numpy.minimum(numpy.abs(8 * x % 1 - 0.5), numpy.abs(8 * y % 1 - 0.5)) < 0.47
        return noise * 0.4 + 0.6 * joints
    if kind % 4 == 1:
        row = numpy.floor(16 * y)
        along = (8 * x + 0.5 * (row % 2)) % 1
        return noise * 0.4 + 0.6 * ((numpy.abs(along - 0.5) < 0.46) & (numpy.abs(16 * y % 1 - 0.5) < 0.42))
    if kind % 4 == 2:
        return 0.25 * noise + 0.375 * (2 + numpy.sin(TAU * 96 * x) * numpy.cos(TAU * 96 * y)) / 1.5
    return numpy.abs(numpy.sin(TAU * (2 * x + 3 * y + 2 * noise))) ** 0.5


def materials(glb):
    made = []
    for kind in range(25):
        heights = pattern(kind)
        tint = numpy.array(COLORS[kind % len(COLORS)]) * (0.75 + 0.25 * (kind % 3) / 2)
        color = (255 * tint * (0.35 + 0.65 * heights[..., None])).clip(0, 255).astype(numpy.uint8)
        is_metal = kind % 8 == 6
        made.append(glb.material(glb.texture(color), glb.texture(normal_map(heights.astype(numpy.float32), 4.0)),
                                 1.0 if is_metal else 0.0, 0.35 if is_metal else 0.5 + 0.05 * (kind % 8)))
    return made


def turned(radius, height, flutes=0, depth=0.0):
    """Turns a profile about the y axis. @param radius of a height in [0, 1]"""
    def place(u, v):
        around = radius(v) * (1 + depth * numpy.cos(flutes * TAU * u) * ((v > 0.12) & (v < 0.88)))
        return numpy.stack((around * numpy.sin(TAU * u), height * v, around * numpy.cos(TAU * u)), -1)
    return place


def column(v):
    foot = numpy.exp(-((v - 0.03) / 0.04) ** 2) + 1.3 * numpy.exp(-((v - 0.97) / 0.04) ** 2)
    return 0.24 - 0.03 * v + 0.12 * foot


def urn(v):
    return 0.05 + 0.32 * numpy.sin(numpy.pi * numpy.clip(v, 0, 1) ** 0.7) * (1 - 0.45 * v) + 0.18 * v**6


def flat(origin, across, up, relief=0.0, waves=0):
    """A rectangle by its corner and its edges, with waves along `across` in the direction of its normal."""
    origin, across, up = (numpy.array(vector, float) for vector in (origin, across, up))
    out = numpy.cross(across, up)
    out /= numpy.linalg.norm(out)

    def place(u, v):
        height = relief * numpy.sin(TAU * waves * u) * (0.6 + 0.4 * numpy.cos(TAU * 2 * v))
        return origin + u[..., None] * across + v[..., None] * up + height[..., None] * out
    return place


def arch(start, end, thickness=0.16):
    """Half a ring in the upright plane through two points."""
    start, end = numpy.array(start, float), numpy.array(end, float)
    middle, half = (start + end) / 2, (end - start) / 2
    radius, along, up = numpy.linalg.norm(half), half / numpy.linalg.norm(half), numpy.array((0.0, 0.45, 0.0))
    side = numpy.cross(along, (0.0, 1.0, 0.0))

    def place(u, v):
        turn, tube = numpy.pi * u, TAU * v
        out = radius + thickness * numpy.cos(tube)
        return (middle + (out * numpy.cos(turn))[..., None] * along + (out * numpy.sin(turn))[..., None] * up
                + (thickness * numpy.sin(tube))[..., None] * side)
    return place


def parts():
    """(surface, rows, columns, tiles, translation) of 100 draws."""
    length, width, storeys = 2 * HALF_LENGTH, 2 * HALF_WIDTH, (0.0, STOREY)
    inner_x, inner_z = HALF_LENGTH - AISLE, HALF_WIDTH - AISLE
    yield flat((-HALF_LENGTH, 0, HALF_WIDTH), (length, 0, 0), (0, 0, -width)), 36, 36, (12, 6), (0, 0, 0)
    yield flat((-HALF_LENGTH, 2 * STOREY, -HALF_WIDTH), (length, 0, 0), (0, 0, width)), 36, 36, (12, 6), (0, 0, 0)
    for y in storeys:
        for sign in (1, -1):
            yield (flat((-sign * HALF_LENGTH, y, -sign * HALF_WIDTH), (sign * length, 0, 0), (0, STOREY, 0), 0.06, 24), 12, 108, (8, 2), (0, 0, 0))
            yield (flat((sign * HALF_LENGTH, y, -sign * HALF_WIDTH), (0, 0, sign * width), (0, STOREY, 0), 0.06, 12), 16, 81, (4, 2), (0, 0, 0))
    for sign in (1, -1):  # the galleries' floors
        yield flat((-HALF_LENGTH, STOREY, sign * inner_z + (AISLE if sign > 0 else 0)), (length, 0, 0), (0, 0, -AISLE)), 12, 108, (12, 1), (0, 0, 0)
    xs, zs = numpy.linspace(-inner_x, inner_x, 7), numpy.linspace(-inner_z, inner_z, 3)
    feet = [(x, z) for x in xs for z in (-inner_z, inner_z)] + [(x, zs[1]) for x in (-inner_x, inner_x)]
    for y in storeys:
        for x, z in feet:
            yield turned(column, STOREY, 16, 0.05), 27, 48, (2, 4), (x, y, z)
        for z in (-inner_z, inner_z):
            for a, b in zip(xs, xs[1:]):
                yield arch((a, y + 0.72 * STOREY, z), (b, y + 0.72 * STOREY, z)), 26, 50, (4, 1), (0, 0, 0)
    for z in (-inner_z, inner_z):
        for a, b in zip(xs, xs[1:]):
            yield flat((a + 0.4, STOREY + 0.4, z), (b - a - 0.8, 0, 0), (0, 2.2, 0), 0.09, 7), 18, 72, (2, 2), (0, 0, 0)
    for x in xs[1:-1]:
        for z in (-1.6, 1.6):
            yield turned(urn, 1.2), 27, 48, (3, 1), (x, 0, z)
    for x in numpy.linspace(-6, 6, 10):
        yield turned(lambda v: 0.35 * numpy.sqrt(numpy.clip(1 - (2 * v - 1) ** 2, 0, 1)), 0.7), 27, 48, (2, 1), (x, 0.0, 0.0)


def atrium():
    glb = Glb()
    made = materials(glb)
    for i, (place, rows, columns, tiles, translation) in enumerate(parts()):
        glb.node(glb.mesh(*surface(place, rows, columns, tiles), made[i * 7 % len(made)]), translation=list(map(float, translation)))
    return glb.data()
