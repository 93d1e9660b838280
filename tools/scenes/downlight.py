"""A luminaire that nobody sells: a batwing downlight with an oval footprint, as an IES LM-63-2002 file."""
import math

FILE = "downlight.ies"

VERTICAL = range(0, 91, 5)  # from straight down [deg]
HORIZONTAL = (0, 22.5, 45, 67.5, 90)  # quadrilateral symmetry [deg]


def intensity(vertical, horizontal):
    """Wings at 30° along the luminaire, a plain cosine across it, nothing at the horizon [cd]."""
    gamma, phi = math.radians(vertical), math.radians(horizontal)
    wings = 1 + 0.9 * math.cos(phi) ** 2 * math.sin(math.pi * min(1.0, vertical / 60)) ** 2
    return 100 * wings * math.cos(gamma) ** 2


def rows(numbers, per_line=10):
    texts = [f"{number:g}" for number in numbers]
    return [" ".join(texts[i:i + per_line]) for i in range(0, len(texts), per_line)]


def make():
    lines = ["IESNA:LM-63-2002", "[TEST] none: made by tools/make_scenes", "[MANUFAC] Steradian (CC0)",
             "[LUMINAIRE] batwing downlight", "TILT=NONE",
             f"1 -1 1 {len(VERTICAL)} {len(HORIZONTAL)} 1 2 0 0 0", "1 1 10"]
    lines += rows(VERTICAL) + rows(HORIZONTAL)
    for horizontal in HORIZONTAL:
        lines += rows(round(intensity(vertical, horizontal), 1) for vertical in VERTICAL)
    return "\n".join(lines) + "\n"
