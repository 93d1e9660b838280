"""Small procedural pictures as PNG files."""
import math

from . import png

SIZE = 64


class Random:
    """Numerical Recipes' linear congruential generator: the same on every machine."""

    def __init__(self, seed):
        self.state = seed

    def below(self, limit):
        self.state = (self.state * 1664525 + 1013904223) % 2**32
        return self.state * limit >> 32


def byte(value):
    """0..1 to 0..255. The tiny offset decides ties, which otherwise a platform's sine would."""
    return min(255, max(0, math.floor(value * 255 + 0.5001)))


def grey_ramp(low, high):
    """Sixteen greys between two levels (0..1), as a palette."""
    return [[byte(low + (high - low) * i / 15)] * 3 for i in range(16)]


def quilt():
    """A normal map of soft diamond cushions."""
    rows = []
    for y in range(SIZE):
        row = []
        for x in range(SIZE):
            a, b = 2 * math.pi * (x + y + 1) / SIZE, 2 * math.pi * (x - y) / SIZE
            # The slope of the height sin²(a/2) sin²(b/2), turned into a normal; +y of a normal map is up, rows go down.
            along_a, along_b = math.sin(a) * (1 - math.cos(b)), (1 - math.cos(a)) * math.sin(b)
            dx, dy = 0.35 * (along_a + along_b), -0.35 * (along_a - along_b)
            length = math.sqrt(dx * dx + dy * dy + 1)
            row.append([byte(0.5 + 0.5 * component / length) for component in (-dx, -dy, 1)])
        rows.append(row)
    return png.rgb(rows)


def terrazzo():
    """Stone chips in a dark ground, sRGB colours."""
    random = Random(4)
    ground = [(46, 47, 58)] * 3
    chips = [(40, 42, 52), (66, 68, 80), (92, 90, 92), (122, 114, 106), (70, 48, 52), (38, 58, 66), (112, 84, 60)]
    rows = [[random.below(len(ground)) for _ in range(SIZE * 2)] for _ in range(SIZE * 2)]
    for _ in range(150):
        center_x, center_y, radius = random.below(SIZE * 2), random.below(SIZE * 2), 1 + random.below(5)
        color, squash = 3 + random.below(len(chips)), 2 + random.below(3)
        for y in range(-radius, radius + 1):
            for x in range(-radius, radius + 1):
                if 2 * x * x + squash * y * y + x * y <= 2 * radius * radius:
                    rows[(center_y + y) % (SIZE * 2)][(center_x + x) % (SIZE * 2)] = color
    return png.indexed(rows, ground + chips)


def tiles():
    """Roughness (green) and metalness (blue, none) of polished tiles with matte joints: four tiles a repeat."""
    random = Random(7)
    polish = [[2 + random.below(3) for _ in range(2)] for _ in range(2)]
    rows = []
    for y in range(SIZE):
        row = []
        for x in range(SIZE):
            in_joint = x % (SIZE // 2) == 0 or y % (SIZE // 2) == 0
            row.append(15 if in_joint else polish[y * 2 // SIZE][x * 2 // SIZE])
        rows.append(row)
    palette = [[0, level[1], 0] for level in grey_ramp(0.0, 0.9)]
    return png.indexed(rows, palette)


def brushed():
    """Roughness (green) and metalness (blue, all) of a metal brushed along u."""
    random = Random(11)
    rows = []
    for _ in range(SIZE):
        level = 3 + random.below(9)
        rows.append([min(15, max(0, level + random.below(3) - 1)) for _ in range(SIZE)])
    palette = [[0, level[1], 255] for level in grey_ramp(0.12, 0.6)]
    return png.indexed(rows, palette)
