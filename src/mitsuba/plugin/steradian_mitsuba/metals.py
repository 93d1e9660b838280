import drjit as dr
import mitsuba as mi

from .microfacets import Microfacets, alpha_of, brushed, schlick
from .parameters import color, number
from .reflector import Reflector


class Ggx(Reflector):
    """GGX microfacets of two widths; their reflectance at normal incidence is the base colour, and Schlick's elsewhere."""

    own_textures = ("anisotropy_texture",)

    def __init__(self, props):
        Reflector.__init__(self, props)
        self.is_brushed = "roughness_across" in props
        self.roughness_across = number(props, "roughness_across", 1.0)
        self.rotation = number(props, "anisotropy_rotation", 0.0)

    def surface(self, si, active):
        x = Reflector.surface(self, si, active)
        alpha, frame = alpha_of(x.roughness), x.frame
        if self.is_brushed:
            frame = brushed(self, x, si, active)[0]
        x.lobe = Microfacets(frame, alpha, alpha_of(self.roughness_across) if self.is_brushed else alpha)
        return x

    def F(self, x, cos_h):
        return schlick(x.base_color, cos_h)

    def f_r(self, x, light):
        return self.F(x, dr.dot(x.view, dr.normalize(light + x.view))) * x.lobe.D_V(x.view, light)

    def peaks(self, x):
        return [(mi.Float(1), x.lobe)]


class Conductor(Ggx):
    """GGX microfacets of a metal by its index of refraction n + ik; the base colour tints it. F is Mitsuba's own."""

    def __init__(self, props):
        Ggx.__init__(self, props)
        self.n, self.k = color(props, "n"), color(props, "k", 0.0)

    def F(self, x, cos_h):
        return x.base_color * mi.Color3f(*(
            mi.fresnel_conductor(cos_h, mi.Complex2f(self.n[i], self.k[i])) for i in range(3)))
