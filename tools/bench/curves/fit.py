"""How a cost grows with a size: a power law, alone and above a fixed cost, by least squares of the logarithms."""
import math
from dataclasses import dataclass


@dataclass
class Growth:
    slope: float               # of ln cost over ln size
    slope_error: float | None  # its standard error; none with less than three sizes
    fixed: float               # c of c + k·sizeᵖ, in the cost's unit
    exponent: float            # p
    exponent_error: float | None  # its standard error with c free; none with less than four sizes
    factor: float              # k

    def at(self, size: float) -> float:
        return self.fixed + self.factor * size**self.exponent


def line(xs, ys, weights):
    """Weighted least squares. @return intercept, slope"""
    total = sum(weights)
    x0, y0 = (sum(w * v for w, v in zip(weights, values)) / total for values in (xs, ys))
    slope = sum(w * (x - x0) * (y - y0) for w, x, y in zip(weights, xs, ys)) / sum(w * (x - x0) ** 2 for w, x in zip(weights, xs))
    return y0 - slope * x0, slope


def above(sizes, costs, fixed):
    """The power law of what lies above a fixed cost. @return k, p, the sum of squares of the logarithms' residuals"""
    xs, ys = [math.log(x) for x in sizes], [math.log(t - fixed) for t in costs]
    # A relative error of a cost is t / (t − c) times as large in what lies above c.
    intercept, p = line(xs, ys, [((t - fixed) / t) ** 2 for t in costs])
    k = math.exp(intercept)
    return k, p, sum(math.log(t / (fixed + k * x**p)) ** 2 for x, t in zip(sizes, costs))


def best_fixed(sizes, costs):
    """The fixed cost with the least squares, between 0 and the smallest cost: a search on finer and finer grids."""
    low, high = 0.0, 0.999 * min(costs)
    for _ in range(6):
        grid = [low + (high - low) * i / 40 for i in range(41)]
        best = min(range(41), key=lambda i: above(sizes, costs, grid[i])[2])
        low, high = grid[max(best - 1, 0)], grid[min(best + 1, 40)]
    return grid[best]


def inverse(matrix):
    """Gauss & Jordan. @throws ZeroDivisionError of a singular one"""
    n = len(matrix)
    rows = [list(row) + [float(i == j) for j in range(n)] for i, row in enumerate(matrix)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for r in range(n):
            if r != i:
                rows[r] = [a - rows[r][i] * b for a, b in zip(rows[r], rows[i])]
    return [row[n:] for row in rows]


def error_of_exponent(sizes, costs, fixed, k, p, squares):
    """From the covariance of ln k, p and c at the optimum; c is left out where it lies on its bound."""
    rows = []
    for x in sizes:
        power = k * x**p
        f = fixed + power
        rows.append([power / f, power * math.log(x) / f] + ([min(costs) / f] if fixed > 1e-6 * min(costs) else []))
    free = len(sizes) - len(rows[0])
    if free < 1:
        return None
    try:
        normal = [[sum(row[i] * row[j] for row in rows) for j in range(len(rows[0]))] for i in range(len(rows[0]))]
        return math.sqrt(max(0.0, squares / free * inverse(normal)[1][1]))
    except ZeroDivisionError:
        return None


def growth(sizes, costs) -> Growth:
    """@param sizes at least two, all different @param costs all positive"""
    k, slope, squares = above(sizes, costs, 0.0)
    xs = [math.log(x) for x in sizes]
    mean = sum(xs) / len(xs)
    slope_error = math.sqrt(squares / (len(xs) - 2) / sum((x - mean) ** 2 for x in xs)) if len(xs) > 2 else None
    if len(sizes) < 3:
        return Growth(slope, slope_error, 0.0, slope, None, k)
    fixed = best_fixed(sizes, costs)
    k, p, squares = above(sizes, costs, fixed)
    return Growth(slope, slope_error, fixed, p, error_of_exponent(sizes, costs, fixed, k, p, squares), k)
