import drjit as dr
import mitsuba as mi

from .reflector import Reflector

C1 = 0.5 - 2 / (3 * dr.pi)
C2 = 2 / 3 - 28 / (15 * dr.pi)


class OrenNayar(Reflector):
    """Oren-Nayar in the form of Fujii, with what it loses given back.

    Portsmouth, Kutz & Hill 2024, "EON: A practical energy-preserving rough diffuse BRDF": f of one bounce, its albedo
    E(w), the mean of that over the hemisphere, and the lobe that makes up for 1 - E.
    """

    @staticmethod
    def albedo(cos_w, r):
        """E of a white surface, exactly."""
        c = dr.clip(cos_w, 1e-6, 1)  # its quotient has a limit at 0, and no digits near it
        s = dr.safe_sqrt(1 - c * c)
        G = s * (dr.safe_acos(c) - s * c) + 2 / 3 * (s / c * (1 - s * s * s) - s)
        return (1 + r * G / dr.pi) / (1 + C1 * r)

    def f_r(self, x, light):
        r, rho = x.roughness, x.base_color
        i, o = x.frame.to_local(light), x.frame.to_local(x.view)
        o.z = dr.maximum(o.z, 0)
        A = 1 / (1 + C1 * r)
        s = i.x * o.x + i.y * o.y
        once = rho / dr.pi * A * (1 + r * s / dr.select(s > 0, dr.maximum(i.z, o.z), 1))
        mean = A * (1 + C2 * r)
        lost = (1 - self.albedo(i.z, r)) * (1 - self.albedo(o.z, r)) / dr.maximum(1 - mean, 1e-7)
        return once + rho * rho * mean / (1 - rho * (1 - mean)) / dr.pi * lost
