import drjit as dr
import mitsuba as mi

from .microfacets import Microfacets
from .parameters import opaque
from .reflector import Reflector


def read_merl(file):
    """The values of a file of the MERL database, as [θ_h, θ_d, φ_d, channel] (Matusik et al. 2003)."""
    import numpy as np

    counts = np.fromfile(file, "<i4", 3)
    values = np.fromfile(file, "<f8", offset=12).reshape(3, *counts)
    scaled = values * np.array([1.0, 1.15, 1.66]).reshape(3, 1, 1, 1) / 1500
    return np.moveaxis(np.maximum(scaled, 0), 0, -1)


class Merl(Reflector):
    """A measured isotropic BRDF, tinted by the base colour, linear between the middles of its cells.

    The angles: Rusinkiewicz 1998, "A new change of variables for efficient BRDF representation", section 3.
    """

    def __init__(self, props):
        Reflector.__init__(self, props)
        import numpy as np

        values = read_merl(str(mi.file_resolver().resolve(props["filename"])))
        around = np.concatenate([values[:, :, -1:], values, values[:, :, :1]], 2)  # φ_d has the period π
        self.counts = around.shape[:3]
        self.table = mi.Texture3f(mi.TensorXf(around.astype(np.float32)), use_accel=False,
                                  filter_mode=dr.FilterMode.Linear, wrap_mode=dr.WrapMode.Clamp)
        self.alpha = opaque(props.get("alpha", 0.3))  # what is sampled

    @staticmethod
    def turned(a, b, angle):
        """The coordinates (a, b) of a direction that is turned by -angle from a to b."""
        s, c = dr.sincos(angle)
        return c * a + s * b, c * b - s * a

    def f_r(self, x, light):
        i, o = x.frame.to_local(light), x.frame.to_local(x.view)
        h = dr.normalize(i + o)
        theta_h = dr.atan2(dr.norm(mi.Vector2f(h.x, h.y)), h.z)
        # The light, turned as the half vector is turned to the normal.
        dx, dy = self.turned(i.x, i.y, dr.atan2(h.y, h.x))
        dz, dx = self.turned(i.z, dx, theta_h)
        theta_d, phi_d = dr.atan2(dr.norm(mi.Vector2f(dx, dy)), dz), dr.atan2(dy, dx)
        phi_d = dr.select(phi_d < 0, phi_d + dr.pi, phi_d)
        half = dr.pi / 2
        at = [1 + phi_d / dr.pi * (self.counts[2] - 2), theta_d / half * self.counts[1],
              dr.sqrt(dr.clip(theta_h / half, 0, 1)) * self.counts[0]]
        place = mi.Point3f(*(a / n for a, n in zip(at, reversed(self.counts))))
        return x.base_color * mi.Color3f(*self.table.eval(place))

    def peaks(self, x):
        return [(mi.Float(0.5), Microfacets(x.frame, self.alpha, self.alpha))]
