"""Error against seconds, both on logarithmic axes, as SVG."""
import math

WIDTH, HEIGHT, MARGIN = 640, 400, 60
COLORS = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9"]  # Okabe & Ito 2008: told apart by colour-blind people, too


def log_share(a, b, value):
    """Where `value` lies between a and b, in logarithms."""
    return math.log(value / a) / math.log(b / a)


def ticks(low, high):
    return [10.0**e for e in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)]


def line(points, style):
    return f'<polyline fill="none" {style} points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}"/>'


def text(x, y, words, anchor="start"):
    return f'<text x="{x:.0f}" y="{y:.0f}" text-anchor="{anchor}" font-family="sans-serif" font-size="13">{words}</text>'


def svg(result, target):
    curves = result["curves"]
    points = [p for curve in curves.values() for p in curve]
    xs, ys = (ticks(min(p[key] for p in points), max(p[key] for p in points)) for key in ("seconds", "rel_mse"))

    def place(seconds, error):
        return (MARGIN + (WIDTH - 2 * MARGIN) * log_share(xs[0], xs[-1], seconds),
                HEIGHT - MARGIN - (HEIGHT - 2 * MARGIN) * log_share(ys[0], ys[-1], error))

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}"><rect width="100%" height="100%" fill="#fff"/>']
    for x in xs:
        parts.append(line([place(x, ys[0]), place(x, ys[-1])], 'stroke="#ddd"'))
        parts.append(text(place(x, ys[0])[0], HEIGHT - MARGIN + 18, f"{x:g} s", "middle"))
    for y in ys:
        parts.append(line([place(xs[0], y), place(xs[-1], y)], 'stroke="#ddd"'))
        parts.append(text(MARGIN - 6, place(xs[0], y)[1] + 4, f"{y:.0e}", "end"))
    if ys[0] < target < ys[-1]:
        parts.append(line([place(xs[0], target), place(xs[-1], target)], 'stroke="#888" stroke-dasharray="4 4"'))
    for i, (name, curve) in enumerate(curves.items()):
        ends = [place(p["seconds"], p["rel_mse"]) for p in curve]
        parts.append(line(ends, f'stroke="{COLORS[i % len(COLORS)]}" stroke-width="2"'))
        parts.append(f'<g fill="{COLORS[i % len(COLORS)]}">{text(ends[-1][0] + 4, ends[-1][1], name)}</g>')
    parts.append(text(WIDTH / 2, 24, f"relMSE against seconds of the whole process: {result['scene']}, {result['size']}", "middle"))
    return "\n".join([*parts, "</svg>", ""])
