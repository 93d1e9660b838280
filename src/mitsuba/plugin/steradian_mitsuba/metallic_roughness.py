import drjit as dr
import mitsuba as mi

from .microfacets import Microfacets, alpha_of, brushed, schlick
from .parameters import color, number
from .reflector import Reflector
from .sheen import Albedo, charlie
from .thin_film import film_reflectance


class MetallicRoughness(Reflector):
    """The BRDF of glTF 2.0, Appendix B: a metal and a coated diffuse dielectric that share one GGX lobe, and their layers.

        coated     = mix(below, D V n_c·wi / n·wi, c F(0.04, n_c·wo))
        below      = sheen colour charlie / max(E, 1) + base (1 - max sheen colour min(E, 1)),  E the larger of E(wi), E(wo)
        base       = mix(dielectric, metal, metallic)
        metal      = F(base colour) D V
        dielectric = (1 - s max F(F0)) ρ/π + s F(F0) D V

    KHR_materials_specular and _ior (s, F0), _anisotropy (D V), _iridescence (F), _sheen, _clearcoat;
    _pbrSpecularGlossiness: F0 is the specular colour, ρ = diffuse (1 - max F0), 1 - roughness is the glossiness.
    """

    own_textures = ("specular_texture", "specular_color_texture", "glossiness_texture", "anisotropy_texture", "clearcoat_texture",
                    "clearcoat_roughness_texture", "clearcoat_normal_texture", "sheen_color_texture",
                    "sheen_roughness_texture", "iridescence_texture", "film_thickness_texture")

    def __init__(self, props):
        Reflector.__init__(self, props)
        self.F0_from_ior = number(props, "F0", 0.04)
        self.specular = number(props, "specular", 1.0)
        self.specular_color = color(props, "specular_color")
        self.is_specular_glossiness = "specular_glossiness" in props
        self.has_anisotropy, self.has_coat, self.has_sheen, self.has_film = (
            name in props for name in ("anisotropy", "clearcoat", "sheen_color", "iridescence"))
        self.anisotropy = number(props, "anisotropy", 0.0)
        self.rotation = number(props, "anisotropy_rotation", 0.0)
        self.clearcoat = number(props, "clearcoat", 0.0)
        self.clearcoat_roughness = number(props, "clearcoat_roughness", 0.0)
        self.clearcoat_normal_scale = number(props, "clearcoat_normal_scale", 1.0)
        self.sheen_color = color(props, "sheen_color", 0.0)
        self.sheen_roughness = number(props, "sheen_roughness", 0.0)
        if self.has_sheen:
            self.E = Albedo(props.get("sheen_roughness", 0.0), self.textures["sheen_roughness_texture"] is not None)
        self.iridescence = number(props, "iridescence", 0.0)
        self.film_ior = number(props, "film_ior", 1.3)
        self.min_thickness = number(props, "min_film_thickness", 100.0)
        self.max_thickness = number(props, "max_film_thickness", 400.0)

    def surface(self, si, active):
        x = Reflector.surface(self, si, active)
        x.F0 = dr.minimum(self.F0_from_ior * self.specular_color * self.read("specular_color_texture", si, active), 1)
        x.specular = self.specular * self.read("specular_texture", si, active).x
        if self.is_specular_glossiness:
            x.base_color = x.base_color * (1 - dr.max(x.F0))
            x.roughness = 1 - (1 - x.roughness) * self.read("glossiness_texture", si, active).x
        self.add_lobe(x, si, active)
        if self.has_coat:
            self.add_coat(x, si, active)
        if self.has_sheen:
            x.sheen_color = dr.clip(self.sheen_color * self.read("sheen_color_texture", si, active), 0, 1)
            x.sheen_roughness = dr.clip(self.sheen_roughness * self.read("sheen_roughness_texture", si, active).x, 0, 1)
        if self.has_film:
            x.iridescence = dr.clip(self.iridescence * self.read("iridescence_texture", si, active).x, 0, 1)
            x.thickness = dr.lerp(self.min_thickness, self.max_thickness,
                                  self.read("film_thickness_texture", si, active).y)
        return x

    def add_lobe(self, x, si, active):
        across, frame = alpha_of(x.roughness), x.frame
        along = across
        if self.has_anisotropy:
            frame, strength = brushed(self, x, si, active)
            along = dr.lerp(across, 1, dr.square(self.anisotropy * strength))
        x.lobe = Microfacets(frame, along, across)

    def add_coat(self, x, si, active):
        alpha = alpha_of(dr.clip(self.clearcoat_roughness * self.read("clearcoat_roughness_texture", si, active).y, 0, 1))
        x.coat_n = self.mapped_normal("clearcoat_normal_texture", self.clearcoat_normal_scale, si, active)
        x.coat = Microfacets(mi.Frame3f(x.coat_n), alpha, alpha)
        clearcoat = dr.clip(self.clearcoat * self.read("clearcoat_texture", si, active).x, 0, 1)
        x.coat_weight = clearcoat * schlick(mi.Float(0.04), dr.maximum(dr.dot(x.coat_n, x.view), 0))

    def F(self, x, F0, cos_h):
        F = schlick(F0, cos_h)
        return dr.lerp(F, film_reflectance(F0, self.film_ior, x.thickness, cos_h), x.iridescence) if self.has_film else F

    def base(self, x, light):
        cos_h = dr.dot(x.view, dr.normalize(light + x.view))
        D_V = x.lobe.D_V(x.view, light)
        F = x.specular * self.F(x, x.F0, cos_h)
        dielectric = (1 - dr.max(F)) * x.base_color / dr.pi + F * D_V
        return dr.lerp(dielectric, self.F(x, x.base_color, cos_h) * D_V, x.metallic)

    def f_r(self, x, light):
        f, cos_i = self.base(x, light), dr.dot(x.n, light)
        if self.has_sheen:
            E = dr.maximum(self.E(cos_i, x.sheen_roughness), self.E(dr.dot(x.n, x.view), x.sheen_roughness))
            fibres = charlie(x.n, x.view, light, alpha_of(x.sheen_roughness)) / dr.maximum(E, 1)
            f = x.sheen_color * fibres + f * (1 - dr.max(x.sheen_color) * dr.minimum(E, 1))
        if self.has_coat:
            cos_coat = dr.dot(x.coat_n, light)
            coat = dr.select((cos_coat > 0) & (cos_i > 0), x.coat.D_V(x.view, light) * cos_coat / cos_i, 0)
            f = dr.lerp(f, mi.Color3f(coat), x.coat_weight)
        return f

    def peaks(self, x):
        base = dr.select(x.specular > 0, dr.lerp(0.5, 1.0, x.metallic), x.metallic)
        if self.has_sheen:
            base = dr.minimum(base, 0.8)  # what fibres scatter is left to the cosine
        if not self.has_coat:
            return [(base, x.lobe)]
        coat = mi.Float(0.3)
        return [((1 - coat) * base, x.lobe), (coat, x.coat)]
