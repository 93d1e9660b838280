"""Sheen: the fibres of KHR_materials_sheen, and how much light they send back."""
import drjit as dr
import mitsuba as mi

from .microfacets import SMALLEST_ALPHA

# Conty Estevez & Kulla 2017, "Production friendly microfacet sheen BRDF", table 1: a to e at roughness 0 and 1.
AT_0 = (25.3245, 3.32435, 0.16801, -1.27393, -4.85967)
AT_1 = (21.5473, 3.82987, 0.19823, -1.97760, -4.32054)
SMALLEST_COSINE = 1e-4  # shaders/brdf/charlie.glsl: the fit ends there


def log_masked(c, alpha):
    """log Λ for cosines up to one half."""
    t = (1 - alpha) * (1 - alpha)
    a, b, p, d, e = (t * at_0 + (1 - t) * at_1 for at_0, at_1 in zip(AT_0, AT_1))
    return a / (1 + b * c**p) + d * c + e


def masked(c, alpha, exp, where):
    """Λ, for arrays of whichever library `exp` and `where` are of."""
    # The exponents of both branches are kept in range, since both are evaluated.
    low, high = where(c < 0.5, c, 0.5), where(c < 0.5, 0.5, 1 - c)
    return exp(where(c < 0.5, log_masked(low, alpha), 2 * log_masked(0.5, alpha) - log_masked(high, alpha)))


def charlie(n, view, light, alpha):
    """D V [1/sr]: (2 + 1/α) sin(h)^(1/α) / 2π over 4 cos cos (1 + Λ + Λ)."""
    i, o = (dr.clip(dr.dot(n, w), SMALLEST_COSINE, 1) for w in (light, view))
    sin_h = dr.norm(dr.cross(n, dr.normalize(light + view)))
    D = (2 + 1 / alpha) * dr.power(sin_h, 1 / alpha) / (2 * dr.pi)
    return D / ((1 + masked(i, alpha, dr.exp, dr.select) + masked(o, alpha, dr.exp, dr.select)) * 4 * i * o)


def albedo(cos_o, alpha, count=96):
    """∫ f cosθ dω for a view: Gauss and Legendre's points over √cosθ, even ones around."""
    import numpy as np

    points, weights = np.polynomial.legendre.leggauss(count)
    u, cos_phi = (points + 1) / 2, np.cos(np.pi * (np.arange(count) + 0.5) / count)[:, None]
    cos_i, cos_o = np.maximum(u * u, SMALLEST_COSINE), max(cos_o, SMALLEST_COSINE)
    cos_d = cos_i * cos_o + np.sqrt((1 - cos_i * cos_i) * (1 - cos_o * cos_o)) * cos_phi
    sin_h = np.sqrt(np.maximum(1 - (cos_i + cos_o)**2 / (2 + 2 * cos_d), 0))
    D = (2 + 1 / alpha) * np.mean(sin_h**(1 / alpha), 0)  # over 2π, of which the integral over φ has as much
    lambdas = sum(masked(c, alpha, np.exp, np.where) for c in (cos_i, np.float64(cos_o)))
    return np.sum(weights / 2 * 2 * u * D / (4 * cos_o * (1 + lambdas)))  # dcosθ = 2u du


class Albedo:
    """`albedo`, tabulated over √cosθ and, where a texture varies it, roughness."""

    def __init__(self, roughness, is_textured):
        import numpy as np

        self.columns = 64 if is_textured else 128
        roughnesses = np.linspace(0, 1, 33) if is_textured else [roughness]
        cosines = np.linspace(0, 1, self.columns)**2
        rows = [[albedo(c, max(r * r, SMALLEST_ALPHA)) for c in cosines] for r in roughnesses]
        self.rows = len(rows)
        self.table = mi.Texture2f(mi.TensorXf(np.array(rows, np.float32)[:, :, None]), use_accel=False,
                                  filter_mode=dr.FilterMode.Linear, wrap_mode=dr.WrapMode.Clamp)

    def __call__(self, cos_w, roughness):
        u = (dr.sqrt(dr.clip(cos_w, 0, 1)) * (self.columns - 1) + 0.5) / self.columns
        v = (roughness * (self.rows - 1) + 0.5) / self.rows
        return self.table.eval(mi.Point2f(u, v))[0]
