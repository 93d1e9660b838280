"""A thin film between air and a base (KHR_materials_iridescence)."""
import drjit as dr
import mitsuba as mi

from .microfacets import schlick

# The Fourier transform of the 1931 observer: a sum of Gaussians for each of X, Y, Z, as weight, position [1/m] and variance
# (Belcour & Barla 2017, section 4; numbers of the extension). X has two.
OBSERVER = (((5.4856e-13, 1.6810e6, 4.3278e9), (9.7470e-14, 2.2399e6, 4.5282e9)), ((4.4201e-13, 1.7953e6, 9.3046e9),),
            ((5.2481e-13, 2.2084e6, 6.6121e9),))
SCALE = 1.0685e-7
RGB_OF_XYZ = ((3.2404542, -1.5371385, -0.4985314), (-0.9692660, 1.8760108, 0.0415560), (0.0556434, -0.2040259, 1.0572252))


def seen(path, phase):
    """How strongly light is seen whose two ways differ by `path` [m], after phase shifts by channel."""
    k = 2 * dr.pi * path
    xyz = [sum(weight * dr.sqrt(2 * dr.pi * variance) * dr.cos(place * k + phase[c]) * dr.exp(-variance * k * k)
               for weight, place, variance in gaussians) / SCALE for c, gaussians in enumerate(OBSERVER)]
    return mi.Color3f(*(sum(row[c] * xyz[c] for c in range(3)) for row in RGB_OF_XYZ))


def at_normal_incidence(a, b):
    return dr.square((a - b) / (a + b))


def film_reflectance(F0, ior, thickness, cos_h):
    """Of a film of `ior`, `thickness` [nm] thick, over a base that reflects F0 in air.

    Belcour & Barla 2017, Eq. 10, to its second order; Schlick's term at both faces, no polarisation, as the extension has it.
    """
    cos_film = dr.safe_sqrt(1 - (1 - cos_h * cos_h) / (ior * ior))  # Snell's law
    root = dr.sqrt(dr.clip(F0, 0, 0.9999))
    base_ior = (1 + root) / (1 - root)
    R12 = schlick(at_normal_incidence(ior, 1), cos_h)
    R23 = schlick(at_normal_incidence(base_ior, ior), cos_film)
    passed = 1 - R12
    product = dr.clip(R12 * R23, 1e-5, 0.9999)
    R = passed * passed * R23 / (1 - product)
    phase = dr.pi + dr.select(base_ior < ior, dr.pi, 0)
    path = 2 * ior * thickness * 1e-9 * cos_film
    F = R12 + R
    for order in (1, 2):
        F += 2 * (R - passed) * dr.power(dr.sqrt(product), order) * seen(order * path, order * phase)
    return dr.clip(F, 0, 1)
