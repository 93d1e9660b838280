import drjit as dr
import mitsuba as mi

from .microfacets import Microfacets
from .parameters import color, number
from .reflector import Reflector


class Phong(Reflector):
    """Lambert of the base colour, and a power of the cosine around the mirrored view: ρ_s (e + 2)/2π (m·wi)^e.

    Lafortune & Willems 1994, Eq. 7.
    """

    own_textures = ("specular_color_texture",)

    def __init__(self, props):
        Reflector.__init__(self, props)
        self.exponent = number(props, "exponent", 32.0)
        self.specular_color = color(props, "specular_color", 0.04)

    def surface(self, si, active):
        x = Reflector.surface(self, si, active)
        x.specular_color = self.specular_color * self.read("specular_color_texture", si, active)
        return x

    def lobe(self, x, light):
        mirrored = 2 * dr.dot(x.n, x.view) * x.n - x.view
        return (self.exponent + 2) / (2 * dr.pi) * dr.power(dr.maximum(dr.dot(mirrored, light), 0), self.exponent)

    def f_r(self, x, light):
        return x.base_color / dr.pi + x.specular_color * self.lobe(x, light)

    def width(self):
        """Of the GGX lobe that is as curved at its top: half vectors turn by half the angle."""
        return dr.sqrt(2 / (4 * self.exponent + 2))

    def peaks(self, x):
        alpha = self.width()
        return [(mi.Float(0.5), Microfacets(x.frame, alpha, alpha))]


class BlinnPhong(Phong):
    """Lambert, and a power of the cosine between the half vector and the normal: ρ_s (e + 2)(e + 4)/(8π (2^(-e/2) + e)) (n·h)^e.

    Blinn 1977; the factor makes ρ_s the albedo at normal incidence (Giesen 2009).
    """

    def lobe(self, x, light):
        e = self.exponent
        scale = (e + 2) * (e + 4) / (8 * dr.pi * (dr.power(2, -e / 2) + e))
        return scale * dr.power(dr.maximum(dr.dot(x.n, dr.normalize(light + x.view)), 0), e)

    def width(self):
        return dr.sqrt(2 / (self.exponent + 2))
