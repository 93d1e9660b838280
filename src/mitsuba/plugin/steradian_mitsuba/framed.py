"""Mitsuba's own BSDFs in the frames of glTF."""
import drjit as dr
import mitsuba as mi

from .microfacets import SMALLEST_COSINE
from .reflector import Reflector


class Framed(Reflector):
    """Another BSDF, named `inner`, tinted by the base colour, around the shading normal that glTF means.

    With it Mitsuba's `diffuse` is Lambert, and its `conductor` an ideal mirror, with normal maps, vertex colours and two sides.
    """

    def __init__(self, props):
        Reflector.__init__(self, props)
        self.inner = props["inner"]
        self.m_components = [self.inner.flags(i) for i in range(self.inner.component_count())]
        self.m_flags = self.inner.flags()

    def inside(self, x, si):
        inner = mi.SurfaceInteraction3f(si)
        w = x.frame.to_local(x.view)
        inner.wi = mi.Vector3f(w.x, w.y, dr.maximum(w.z, SMALLEST_COSINE))
        return inner

    def sample(self, ctx, si, sample1, sample2, active=True):
        x = self.surface(si, active)
        bs, weight = self.inner.sample(ctx, self.inside(x, si), sample1, sample2, active)
        bs.wo = x.frame.to_world(bs.wo)
        active = self.arrives(si, bs.wo, active & self.is_seen(si))
        return bs, dr.select(active, x.base_color * weight, 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        x = self.surface(si, active)
        active = self.arrives(si, wo, active & self.is_seen(si))
        value, density = self.inner.eval_pdf(ctx, self.inside(x, si), x.frame.to_local(wo), active)
        return dr.select(active, x.base_color * value, 0), dr.select(active, density, 0)
