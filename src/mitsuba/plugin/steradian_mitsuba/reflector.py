"""What all reflecting surfaces here have in common: factors and textures, normal maps, sides, sampling."""
from types import SimpleNamespace

import drjit as dr
import mitsuba as mi

from .parameters import child, color, number


class Reflector(mi.BSDF):
    """A surface that reflects by `f_r`, which its heirs state.

    Factors are numbers; textures of the same name with `_texture` multiply them. Mitsuba's `wi` points to the viewer
    and its `wo` to the light; here they are called `view` and `light`, and both are in the frame of `si`.
    """

    #: Textures that an heir reads besides the base colour, roughness and normal map.
    own_textures = ()

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.base_color = color(props, "base_color")
        self.metallic = number(props, "metallic", 1.0)
        self.roughness = number(props, "roughness", 1.0)
        self.normal_scale = number(props, "normal_scale", 1.0)
        self.is_double_sided = props.get("double_sided", False)
        self.textures = {name: child(props, name) for name in (
            "base_color_texture", "metallic_roughness_texture", "normal_texture", "vertex_color", "vertex_normal",
            "vertex_tangent", "vertex_handedness", *self.own_textures)}
        sides = mi.BSDFFlags.FrontSide | (mi.BSDFFlags.BackSide if self.is_double_sided else mi.BSDFFlags.Empty)
        self.m_components = [mi.BSDFFlags.GlossyReflection | sides, mi.BSDFFlags.DiffuseReflection | sides]
        self.m_flags = self.m_components[0] | self.m_components[1]

    # What heirs state.

    def f_r(self, x, light):
        """[1/sr] above the horizon of x.n."""
        raise NotImplementedError

    def peaks(self, x):
        """What is sampled: pairs of a share and a lobe of microfacets. The rest is sampled as the cosine."""
        return []

    # Reading textures.

    def read(self, name, si, active):
        image = self.textures[name]
        return mi.Color3f(1.0) if image is None else mi.Color3f(image.eval_3(si, active))

    def vector(self, name, si, active):
        return mi.Vector3f(self.textures[name].eval_3(si, active))

    def from_tangent_space(self, m, si, active):
        """As MikkTSpace defines it: the vectors are used at the length they are interpolated at."""
        normal = self.vector("vertex_normal", si, active)
        tangent = self.vector("vertex_tangent", si, active)
        bitangent = self.vector("vertex_handedness", si, active) * dr.cross(normal, tangent)
        return si.to_local(dr.normalize(m.x * tangent + m.y * bitangent + m.z * normal))

    def mapped_normal(self, name, scale, si, active):
        """A shading normal, on the side of the viewer and bent there where it faces away (as shaders/surface/ has it)."""
        n = mi.Vector3f(0, 0, 1)
        if self.textures[name] is not None:
            m = 2 * self.vector(name, si, active) - 1
            n = self.from_tangent_space(mi.Vector3f(m.x * scale, m.y * scale, m.z), si, active)
        n = self.on_seen_side(n, si)
        cos_o = dr.dot(n, si.wi)
        return dr.select(cos_o >= 0, n, dr.normalize(n - cos_o * si.wi))

    def on_seen_side(self, n, si):
        return dr.select(dr.dot(si.n, si.to_world(si.wi)) < 0, -n, n) if self.is_double_sided else n

    def arrives(self, si, light, active):
        """Whether light comes from the side of the surface that is seen: a normal map does not bend it through."""
        if self.textures["normal_texture"] is None:
            return active
        n = si.to_local(self.vector("vertex_normal", si, active))
        return active & (dr.dot(self.on_seen_side(n, si), light) > 0)

    def is_seen(self, si):
        return True if self.is_double_sided else dr.dot(si.n, si.to_world(si.wi)) > 0

    def surface(self, si, active):
        """All that f_r and sampling ask of the point; heirs add theirs."""
        rm = self.read("metallic_roughness_texture", si, active)
        n = self.mapped_normal("normal_texture", self.normal_scale, si, active)
        return SimpleNamespace(
            view=si.wi, n=n, frame=mi.Frame3f(n),
            base_color=self.base_color * self.read("base_color_texture", si, active) * self.read("vertex_color", si, active),
            roughness=dr.clip(self.roughness * rm.y, 0, 1), metallic=dr.clip(self.metallic * rm.z, 0, 1))

    # Mitsuba's questions.

    def value(self, x, light):
        cos_i = dr.dot(x.n, light)
        return dr.select(cos_i > 0, self.f_r(x, light) * cos_i, 0)

    def density(self, x, light):
        cos_i = dr.dot(x.n, light)
        p, rest = mi.Float(0), mi.Float(1)
        for share, lobe in self.peaks(x):
            p += share * lobe.density(x.view, light)
            rest -= share
        return dr.select(cos_i > 0, p + rest * cos_i / dr.pi, 0)

    def sample(self, ctx, si, sample1, sample2, active=True):
        x = self.surface(si, active)
        light = x.frame.to_world(mi.warp.square_to_cosine_hemisphere(sample2))
        begin = mi.Float(0)
        for share, lobe in self.peaks(x):
            is_chosen = (sample1 >= begin) & (sample1 < begin + share)
            light = dr.select(is_chosen, lobe.sample(x.view, sample2), light)
            begin += share
        bs = mi.BSDFSample3f()
        bs.wo = light
        bs.pdf = self.density(x, light)
        bs.eta = 1.0
        bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        bs.sampled_component = mi.UInt32(0)
        active = self.arrives(si, light, active & (bs.pdf > 0) & self.is_seen(si))
        return bs, dr.select(active, self.value(x, light) / dr.select(bs.pdf > 0, bs.pdf, 1), 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        x = self.surface(si, active)
        active = self.arrives(si, wo, active & self.is_seen(si))
        return dr.select(active, self.value(x, wo), 0), dr.select(active, self.density(x, wo), 0)

    def eval(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[0]

    def pdf(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[1]

    def traverse(self, callback):
        pass

    def to_string(self):
        return type(self).__name__ + "[]"
