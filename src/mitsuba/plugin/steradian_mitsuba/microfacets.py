"""GGX microfacets, as wide along a direction as across it or not, by Mitsuba's own distribution."""
import drjit as dr
import mitsuba as mi

# Below it no density is to be seen, and the fourth power leaves the range of floats (shaders/surface/at_fragment.glsl).
SMALLEST_ALPHA = 1e-4
# The limit of G1 / cos at grazing is finite, but Mitsuba's G1 is 0 there; nearer to it cos has no digits.
SMALLEST_COSINE = 1e-6


def alpha_of(roughness):
    return dr.maximum(roughness * roughness, SMALLEST_ALPHA)


def schlick(F0, cos_h):
    """Schlick 1994, Eq. 15."""
    return F0 + (1 - F0) * dr.power(dr.clip(1 - cos_h, 0, 1), 5)


class Microfacets:
    """A lobe in a frame whose x is the direction of the width alpha_u.

    D and the masking of one side G1 are Mitsuba's. Where they do not depend on one another (`roughconductor`) G is their
    product; glTF asks for heights that do: G = 1 / (1 + Λ_i + Λ_o), Λ = 1/G1 - 1 (Heitz 2014, Eq. 43 and 99).
    """

    def __init__(self, frame, alpha_u, alpha_v):
        self.frame, self.alpha_u, self.alpha_v = frame, alpha_u, alpha_v
        self.ggx = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, alpha_u, alpha_v, True)

    def local(self, w):
        w = self.frame.to_local(w)
        return mi.Vector3f(w.x, w.y, dr.maximum(w.z, SMALLEST_COSINE))

    def D_V(self, view, light):
        """D G / (4 cos_i cos_o) [1/sr]."""
        i, o = self.local(light), self.local(view)
        h = self.frame.to_local(dr.normalize(light + view))
        masked = 1 / self.ggx.smith_g1(i, h) + 1 / self.ggx.smith_g1(o, h) - 1
        return self.ggx.eval(h) / (masked * 4 * i.z * o.z)

    def sample(self, view, u):
        """A mirrored view, at a normal that it sees."""
        o = self.local(view)
        return self.frame.to_world(mi.reflect(o, self.ggx.sample(o, u)[0]))

    def density(self, view, light):
        """Of `sample`: D G1 / (4 cos_o), with G1 = 2 cos_o / (cos_o + |…|) divided out (Heitz 2018, Eq. 2 and 17)."""
        o = self.local(view)
        h = self.frame.to_local(dr.normalize(light + view))
        stretched = dr.norm(mi.Vector3f(self.alpha_u * o.x, self.alpha_v * o.y, o.z))
        return self.ggx.eval(h) / (2 * (o.z + stretched))


def brushed(reflector, x, si, active):
    """The frame of x whose x is the direction of KHR_materials_anisotropy, and the texture's strength."""
    turn = mi.Vector2f(dr.cos(reflector.rotation), dr.sin(reflector.rotation))
    strength = mi.Float(1)
    if reflector.textures["anisotropy_texture"] is not None:
        texel = reflector.vector("anisotropy_texture", si, active)
        m = mi.Vector2f(2 * texel.x - 1, 2 * texel.y - 1)
        m = dr.select(dr.dot(m, m) > 1e-3, dr.normalize(m), mi.Vector2f(1, 0))  # texels without a direction say +X
        turn = mi.Vector2f(turn.x * m.x - turn.y * m.y, turn.y * m.x + turn.x * m.y)
        strength = texel.z
    t = reflector.from_tangent_space(mi.Vector3f(turn.x, turn.y, 0), si, active)
    t = dr.normalize(t - dr.dot(t, x.n) * x.n)
    return mi.Frame3f(t, dr.cross(x.n, t), x.n), strength
