"""Triangle meshes with smooth normals, centred where it is natural to place them."""
import math
from dataclasses import dataclass, field

from .vector import cross, minus, normalized, plus, times


@dataclass
class Geometry:
    """Positions [m] and unit normals, a row a vertex; three indices a triangle, counter-clockwise from outside."""
    positions: list
    normals: list
    indices: list
    texcoords: list = field(default_factory=list)


def merged(*parts):
    """One geometry of several that all have texture coordinates, or none of them."""
    result = Geometry([], [], [])
    for part in parts:
        first = len(result.positions)
        result.positions += part.positions
        result.normals += part.normals
        result.texcoords += part.texcoords
        result.indices += [first + index for index in part.indices]
    return result


def polygon(*corners):
    """A flat convex polygon, its corners counter-clockwise seen from its front."""
    normal = normalized(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])))
    indices = [index for i in range(1, len(corners) - 1) for index in (0, i, i + 1)]
    return Geometry(list(corners), [normal] * len(corners), indices)


def rectangle(width, height, tiles=None):
    """In the xy plane, facing +z. `tiles` = (across, up): how often a texture repeats."""
    x, y = width / 2, height / 2
    result = polygon((-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0))
    if tiles:
        across, up = tiles
        result.texcoords = [(0, up), (across, up), (across, 0), (0, 0)]
    return result


def floor(width, depth, tiles=None):
    """In the xz plane, facing +y."""
    flat = rectangle(width, depth, tiles)
    flat.positions = [(x, 0.0, -y) for x, y, _ in flat.positions]
    flat.normals = [(0.0, 1.0, 0.0)] * 4
    return flat


def box(width, height, depth):
    """Standing on the origin, with hard edges."""
    x, z = width / 2, depth / 2
    corners = [(-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z), (-x, height, z), (x, height, z), (x, height, -z),
               (-x, height, -z)]
    faces = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7), (3, 2, 1, 0)]
    return merged(*(polygon(*(corners[i] for i in face)) for face in faces))


def grid_indices(rows, columns, is_degenerate=lambda row, column, corner: False):
    """Triangles between rows × columns vertices; rows run up where columns run counter-clockwise."""
    indices = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            a = row * columns + column
            b, c, d = a + 1, a + columns + 1, a + columns
            if not is_degenerate(row, column, "lower"):
                indices += [a, b, c]
            if not is_degenerate(row, column, "upper"):
                indices += [a, c, d]
    return indices


def rounded_box(width, height, depth, radius, steps=2):
    """Centred on the origin; every edge is an arc of `steps` facets."""
    inner = (width / 2 - radius, height / 2 - radius, depth / 2 - radius)
    arc = [math.tan(math.radians(45 * i / steps)) for i in range(steps + 1)]
    line = [(-1, -t) for t in reversed(arc)] + [(1, t) for t in arc]
    faces = []
    for axis in range(3):
        for side in (1, -1):
            u, v = ((axis + 1) % 3, (axis + 2) % 3) if side > 0 else ((axis + 2) % 3, (axis + 1) % 3)
            face = Geometry([], [], grid_indices(len(line), len(line)))
            for v_sign, v_slope in line:
                for u_sign, u_slope in line:
                    direction, corner = [0.0] * 3, [0.0] * 3
                    direction[axis], direction[u], direction[v] = side, u_slope, v_slope
                    corner[axis], corner[u], corner[v] = side * inner[axis], u_sign * inner[u], v_sign * inner[v]
                    normal = normalized(direction)
                    face.normals.append(normal)
                    face.positions.append(plus(corner, times(normal, radius)))
            faces.append(face)
    return merged(*faces)


def lathe(*profiles, segments=32, is_textured=False):
    """Turns profiles about the y axis. A profile is a list of (radius, height) that runs up the outside (or in along
    a top); it is smooth along its length, and two profiles meet in an edge. Texture: u goes around, v along."""
    return merged(*(turned(profile, segments, is_textured) for profile in profiles))


def turned(profile, segments, is_textured):
    result = Geometry([], [], [])
    last = len(profile) - 1
    for row, (radius, height) in enumerate(profile):
        before, after = profile[max(row - 1, 0)], profile[min(row + 1, last)]
        slope = normalized((after[1] - before[1], before[0] - after[0], 0.0))
        if radius == 0:
            slope = (0.0, math.copysign(1.0, slope[1]), 0.0)
        for column in range(segments + 1):
            turn = 2 * math.pi * (column % segments) / segments
            sine, cosine = math.sin(turn), math.cos(turn)
            result.positions.append((radius * sine, height, radius * cosine))
            result.normals.append((slope[0] * sine, slope[1], slope[0] * cosine))
            if is_textured:
                result.texcoords.append((column / segments, row / last))

    def is_degenerate(row, _column, corner):
        return (corner == "lower" and profile[row][0] == 0) or (corner == "upper" and profile[row + 1][0] == 0)

    result.indices = grid_indices(len(profile), segments + 1, is_degenerate)
    return result


def arc(center, radius, start, stop, steps):
    """Profile points on a circle; angles in degrees from the horizontal, up is positive."""
    points = []
    for i in range(steps + 1):
        angle = math.radians(start + (stop - start) * i / steps)
        x = center[0] + radius * math.cos(angle)
        points.append((0.0 if abs(x) < 1e-9 else x, center[1] + radius * math.sin(angle)))
    return points


def sphere(radius, segments=40):
    return lathe(arc((0, 0), radius, -90, 90, segments // 2), segments=segments)


def torus(radius, tube, segments=40, steps=10):
    return lathe(arc((radius, 0), tube, -180, 180, steps), segments=segments)


def cylinder(radius, height, bevel, segments=40, is_textured=False):
    """Standing on the origin, closed on top, its upper rim rounded by `bevel`."""
    rim = arc((radius - bevel, height - bevel), bevel, 0, 90, 4)
    return lathe([(radius, 0), (radius, height - bevel)], rim, [(radius - bevel, height), (0, height)], segments=segments,
                 is_textured=is_textured)
