"""Just enough vector algebra to place things: 3-vectors and unit quaternions (x, y, z, w), as tuples."""
import math


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(a, factor):
    return tuple(x * factor for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normalized(a):
    return times(a, 1.0 / math.sqrt(dot(a, a)))


def rotation_about(axis, degrees):
    half = math.radians(degrees) / 2
    return (*times(normalized(axis), math.sin(half)), math.cos(half))


def rotation_from_axes(right, up, back):
    """The quaternion that turns x, y, z into three perpendicular unit vectors."""
    # Shepperd 1978: start from the largest component, so that no division is by a small number.
    diagonal = (right[0], up[1], back[2])
    off = (up[2] - back[1], back[0] - right[2], right[1] - up[0])
    if sum(diagonal) > 0:
        w = math.sqrt(1 + sum(diagonal)) / 2
        return (*times(off, 1 / (4 * w)), w)
    axes = (right, up, back)
    i = diagonal.index(max(diagonal))
    j, k = (i + 1) % 3, (i + 2) % 3
    largest = math.sqrt(1 + diagonal[i] - diagonal[j] - diagonal[k]) / 2
    result = [0.0] * 4
    result[i] = largest
    result[j] = (axes[j][i] + axes[i][j]) / (4 * largest)
    result[k] = (axes[k][i] + axes[i][k]) / (4 * largest)
    result[3] = off[i] / (4 * largest)
    return tuple(result)


def rotation_facing(direction, up=(0, 1, 0)):
    """Turns -z, where glTF's cameras and lights look, into `direction`."""
    back = normalized(times(direction, -1))
    right = normalized(cross(up, back))
    return rotation_from_axes(right, cross(back, right), back)


def looking(eye, target):
    """The placement of a camera or a light at `eye` that looks at `target`."""
    return {"translation": eye, "rotation": rotation_facing(minus(target, eye))}
