"""Costs against sizes, a panel for each thing that grows, all on logarithmic axes, as one SVG."""
import math
from xml.sax.saxutils import escape

from .plot import COLORS, log_share, line

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM, COLUMNS = 360, 270, 62, 14, 44, 48, 3


def text(x, y, words, anchor="start", size=12, color="#222"):
    return (f'<text x="{x:.0f}" y="{y:.0f}" text-anchor="{anchor}" font-family="sans-serif" font-size="{size}" fill="{color}">'
            f"{escape(words)}</text>")


def decades(values):
    """Powers of ten around the values, at least one decade."""
    low, high = math.floor(math.log10(min(values)) + 1e-9), math.ceil(math.log10(max(values)) - 1e-9)
    return [10.0**e for e in range(low, max(high, low + 1) + 1)]


def milliseconds(seconds):
    return f"{seconds:g} s" if seconds >= 1 else f"{1e3 * seconds:g} ms"


def panel(title, unit, series, left, top):
    """@param series (name, sizes, labels, costs [s], a function of the size that fits them)"""
    sizes = [x for _, xs, *_ in series for x in xs]
    low, high = min(sizes), max(sizes)
    ticks = decades([cost for *_, costs, _ in series for cost in costs])

    def place(size, cost):
        return (left + LEFT + (WIDTH - LEFT - RIGHT) * log_share(low, high, size),
                top + HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * log_share(ticks[0], ticks[-1], cost))
    parts = [text(left + WIDTH / 2, top + 18, title, "middle", 14)]
    for tick in ticks:
        parts.append(line([place(low, tick), place(high, tick)], 'stroke="#ddd"'))
        parts.append(text(left + LEFT - 6, place(low, tick)[1] + 4, milliseconds(tick), "end", 11))
    before, lower = -1e9, 0
    for size, label in dict(zip(series[0][1], series[0][2])).items():
        x = place(size, ticks[0])[0]
        lower = 11 if x - before < 7 * len(label) and not lower else 0  # so that neighbours do not overlap
        before = x
        parts.append(line([(x, place(low, ticks[0])[1]), (x, place(low, ticks[-1])[1])], 'stroke="#eee"'))
        parts.append(text(x, top + HEIGHT - BOTTOM + 15 + lower, label, "middle", 10))
    parts.append(text(left + WIDTH / 2, top + HEIGHT - 8, unit, "middle", 11, "#555"))
    for i, (name, xs, _, costs, fitted) in enumerate(series):
        color = COLORS[i % len(COLORS)]
        curve = [low * (high / low) ** (j / 40) for j in range(41)]
        parts.append(line([place(x, min(max(fitted(x), ticks[0]), ticks[-1])) for x in curve if min(xs) <= x <= max(xs)],
                          f'stroke="{color}" stroke-width="1.5"'))
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{color}"/>' for x, y in (place(*point) for point in zip(xs, costs))]
        parts.append(text(left + LEFT + 6 + 145 * i, top + TOP - 8, name, size=11, color=color))
    return parts


def svg(panels):
    """@param panels arguments of panel() without its place"""
    rows = -(-len(panels) // COLUMNS)
    columns = min(len(panels), COLUMNS)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {columns * WIDTH} {rows * HEIGHT}"><rect width="100%" height="100%" fill="#fff"/>']
    for i, each in enumerate(panels):
        parts += panel(*each, i % COLUMNS * WIDTH, i // COLUMNS * HEIGHT)
    return "\n".join([*parts, "</svg>", ""])
