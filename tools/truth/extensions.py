#!/usr/bin/env python3
"""Renders materials of glTF's extensions with Mitsuba 3: tests/truth/references/extensions.exr.

    tools/truth/.venv/bin/python tools/truth/extensions.py

KHR_materials_pbrSpecularGlossiness, KHR_materials_transmission (with _volume and _ior) and KHR_materials_diffuse_transmission,
as the texts of the extensions and glTF 2.0, Appendix B, define them. No code of Steradian is used: geometry, textures and the
material are made here; D and the masking G1 are Mitsuba's own, and its integrator `volpath` looks through what is `Null`.
tests/truth/extension_test.cpp has the same cells as glTF files.
"""
import os
from pathlib import Path

LLVM = "/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1"  # Debian's libllvm19
if Path(LLVM).exists():
    os.environ.setdefault("DRJIT_LIBLLVM_PATH", LLVM)

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
SIZE, SPP, BATCHES = 16, 8192, 8


def flat(value):
    return {"type": "rgb", "value": list(value)}


class Layered(mi.BSDF):
    """f = (1 - max F) ((1 - t) (1 - d) c / π above, (1 - t) d C / π below) + F D V, and (1 - max F) t c e^-σx straight through.

    F is Schlick's of F0, at the half vector for what is reflected, at the normal for what goes straight.
    """

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.base = props.get_texture("base", 0.5)  # c
        self.F0 = props.get_texture("F0", 0.5)
        self.roughness = props.get_texture("roughness", 0.5)
        self.transmission = float(props.get("transmission", 0.0))            # t
        self.diffuse_transmission = float(props.get("diffuse_transmission", 0.0))  # d
        self.below = mi.Color3f(props.get("below", mi.ScalarColor3f(1.0)))   # C
        self.depth = mi.Color3f(props.get("optical_depth", mi.ScalarColor3f(0.0)))  # σx
        both = mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
        self.m_components = [mi.BSDFFlags.GlossyReflection | both, mi.BSDFFlags.DiffuseTransmission | both,
                             mi.BSDFFlags.Null | both]
        self.m_flags = self.m_components[0] | self.m_components[1] | self.m_components[2]

    def traverse(self, callback):
        pass

    def fresnel(self, F0, cosine):
        return F0 + (1 - F0) * dr.power(1 - dr.clip(cosine, 0, 1), 5)

    def terms(self, si, wo):
        """f without what goes straight, times |cosθ|; and the density of sample()."""
        side = dr.sign(si.wi.z)
        wi, wo = si.wi * side, wo * side
        c, F0 = self.base.eval(si), self.F0.eval(si)
        alpha = dr.square(self.roughness.eval_1(si))
        ggx = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, alpha, False)
        is_above = wo.z > 0
        up = dr.select(is_above, wo, mi.Vector3f(wo.x, wo.y, -wo.z))
        h = dr.normalize(wi + up)
        F = self.fresnel(F0, dr.dot(wi, h))
        base = (1 - dr.max(F)) * (1 - self.transmission)
        # Height-correlated masking and shadowing of G1 = 1 / (1 + Λ): Heitz 2014, Eq. 99.
        G = 1 / (1 / ggx.smith_g1(wi, h) + 1 / ggx.smith_g1(up, h) - 1)
        gloss = F * ggx.eval(h) * G / (4 * wi.z * up.z)
        f = dr.select(is_above, base * (1 - self.diffuse_transmission) * c / dr.pi + gloss,
                      base * self.diffuse_transmission * self.below / dr.pi)
        cosine = mi.warp.square_to_cosine_hemisphere_pdf(up)
        p_gloss = ggx.eval(h) * ggx.smith_g1(wi, h) / (4 * wi.z)
        pdf = dr.select(is_above, 0.25 * cosine + 0.25 * p_gloss, 0.25 * cosine)
        is_valid = (wi.z > 1e-6) & (up.z > 1e-6)
        return dr.select(is_valid, f * up.z, 0), dr.select(is_valid, pdf, 0)

    def straight(self, si):
        F = self.fresnel(self.F0.eval(si), dr.abs(si.wi.z))
        return (1 - dr.max(F)) * self.transmission * self.base.eval(si) * dr.exp(-self.depth)

    def sample(self, ctx, si, sample1, sample2, active=True):
        side = dr.sign(si.wi.z)
        alpha = dr.square(self.roughness.eval_1(si))
        ggx = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, alpha, True)
        wi = si.wi * side
        h, _ = ggx.sample(wi, sample2)
        up = mi.warp.square_to_cosine_hemisphere(sample2)
        wo = dr.select(sample1 < 0.25, up, mi.reflect(wi, h))
        wo = dr.select((sample1 >= 0.5) & (sample1 < 0.75), mi.Vector3f(up.x, up.y, -up.z), wo) * side
        is_null = sample1 >= 0.75
        bs = mi.BSDFSample3f()
        bs.wo = dr.select(is_null, -si.wi, wo)
        f, pdf = self.terms(si, wo)
        bs.pdf = dr.select(is_null, 0.25, pdf)
        bs.eta = 1.0
        bs.sampled_type = dr.select(is_null, mi.UInt32(+mi.BSDFFlags.Null), mi.UInt32(+mi.BSDFFlags.GlossyReflection))
        bs.sampled_component = dr.select(is_null, mi.UInt32(2), mi.UInt32(0))
        weight = dr.select(is_null, self.straight(si) / 0.25, dr.select(pdf > 0, f / pdf, 0))
        return bs, weight & active

    def eval(self, ctx, si, wo, active=True):
        return self.terms(si, wo)[0] & active

    def pdf(self, ctx, si, wo, active=True):
        return dr.select(active, self.terms(si, wo)[1], 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        f, pdf = self.terms(si, wo)
        return f & active, dr.select(active, pdf, 0)

    def eval_null_transmission(self, si, active=True):
        return self.straight(si) & active

    def to_string(self):
        return "Layered[]"


mi.register_bsdf("layered", Layered)


def linear(code):
    """The sRGB transfer function, IEC 61966-2-1, of a code of 8 bits."""
    v = np.asarray(code, float) / 255
    return np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def bitmap(picture):
    """The first row is the upper one; v of Mitsuba's rectangle counts from below."""
    return {"type": "bitmap", "bitmap": mi.Bitmap(np.ascontiguousarray(picture[::-1]).astype(np.float32)), "raw": True, "wrap_mode": "clamp",
            "filter_type": "bilinear"}


# Codes of textures of 4×4 texels; u and v count from the upper left.
J, I = np.mgrid[0:4, 0:4]
DIFFUSE = np.stack([60 + 50 * I, 40 + 60 * J, 200 - 30 * I - 10 * J], 2)
SPECULAR = np.stack([80 + 20 * I + 10 * J, 100 + 30 * J, 120 + 0 * I], 2)
GLOSSINESS = 60 + 40 * I + 10 * J


def fine(texels, n=512):
    """4×4 texels as bilinear filtering shows them, n² times: what is computed of two textures has no texels of its own."""
    at = np.clip((np.arange(n) + 0.5) / n * 4 - 0.5, 0, 3)
    low = np.minimum(at.astype(int), 2)
    w = at - low
    rows = texels[low] * (1 - w)[:, None, None] + texels[low + 1] * w[:, None, None]
    return rows[:, low] * (1 - w)[None, :, None] + rows[:, low + 1] * w[None, :, None]


def spec_gloss(diffuse, specular, glossiness, is_textured=False):
    """c_diff = diffuse (1 - max specular), F0 = specular, roughness = 1 - glossiness."""
    diffuse, specular = np.array(diffuse), np.array(specular)
    if not is_textured:
        return {"type": "layered", "base": flat(diffuse * (1 - specular.max())), "F0": flat(specular),
                "roughness": {"type": "uniform", "value": 1 - glossiness}}
    s = fine(specular * linear(SPECULAR))
    c = fine(diffuse * linear(DIFFUSE)) * (1 - s.max(2, keepdims=True))
    r = 1 - glossiness * fine(GLOSSINESS[:, :, None] / 255)
    return {"type": "layered", "base": bitmap(c), "F0": bitmap(s), "roughness": bitmap(r)}


def glass(base, transmission, roughness, ior=1.5, attenuation=(1, 1, 1), distance=1, thickness=0):
    return {"type": "layered", "base": flat(base), "F0": flat([((ior - 1) / (ior + 1)) ** 2] * 3),
            "roughness": {"type": "uniform", "value": roughness}, "transmission": transmission,
            "optical_depth": mi.ScalarColor3f(*(-np.log(np.array(attenuation, float)) * thickness / distance))}


def sheet(base, share, color, roughness, transmission=0.0):
    return {"type": "layered", "base": flat(base), "F0": flat([0.04] * 3), "roughness": {"type": "uniform", "value": roughness},
            "diffuse_transmission": share, "below": mi.ScalarColor3f(*color), "transmission": transmission}


CELLS = [
    ("plastic", spec_gloss((0.6, 0.3, 0.1), (0.04, 0.04, 0.04), 0.5), False),
    ("metal", spec_gloss((0, 0, 0), (1.0, 0.8, 0.3), 0.6), False),
    ("between", spec_gloss((0.5, 0.6, 0.7), (0.5, 0.25, 0.1), 0.3), False),
    ("textured", spec_gloss((0.9, 0.8, 1.0), (0.8, 1.0, 0.6), 0.9, True), False),
    ("clear", glass((0.9, 0.5, 0.2), 1.0, 0.4), True),
    ("frosted", glass((0.7, 0.8, 0.9), 0.6, 0.5, ior=1.8), True),
    ("volume", glass((1, 1, 1), 1.0, 0.4, attenuation=(0.8, 0.4, 0.9), distance=0.2, thickness=0.1), True),
    ("leaf", sheet((0.2, 0.5, 0.1), 0.6, (0.6, 0.8, 0.2), 0.6), False),
    ("paper", sheet((0.8, 0.8, 0.7), 0.9, (0.9, 0.8, 0.7), 0.4, transmission=0.3), False),
]


def square(bsdf, half, to_world=None):
    """In z = 0, its front towards +Z."""
    to_world = (to_world or mi.ScalarTransform4f()) @ mi.ScalarTransform4f().scale([half, half, 1])
    return {"type": "rectangle", "to_world": to_world, "bsdf": bsdf}


def lamp(place, half, L, faces_up):
    look = [0, 0, 1 if faces_up else -1]
    return {"type": "rectangle", "emitter": {"type": "area", "radiance": flat(L)}, "bsdf": {"type": "diffuse", "reflectance": flat([0] * 3)},
            "to_world": mi.ScalarTransform4f().look_at(origin=place, target=list(np.add(place, look)), up=[0, 1, 0])
            @ mi.ScalarTransform4f().scale([half, half, 1])}


def scene_of(bsdf, is_pane):
    eye = np.array([0.3, 0.5, 1.0]) * 10
    scene = {
        "type": "scene", "integrator": {"type": "volpath", "max_depth": 2, "rr_depth": 100},
        "above": lamp([0.4, -0.6, 1.5], 0.3, (10, 8, 6), False),
        "below": lamp([-0.3, 0.7, -1.2], 0.4, (4, 6, 8), True),
        "sensor": {"type": "orthographic", "near_clip": 0.1, "far_clip": 100,
                   "to_world": mi.ScalarTransform4f().look_at(origin=list(eye), target=[0, 0, 0], up=[0, 1, 0])
                   @ mi.ScalarTransform4f().scale([0.4, 0.4, 1]),
                   "film": {"type": "hdrfilm", "width": SIZE, "height": SIZE, "pixel_format": "rgb",
                            "component_format": "float32", "rfilter": {"type": "box"}}}}
    if is_pane:
        scene["wall"] = square({"type": "diffuse", "reflectance": flat((0.8, 0.7, 0.6))}, 2)
        tilt = mi.ScalarTransform4f().translate([0, 0, 0.4]) @ mi.ScalarTransform4f().rotate([1, 0, 0], 20)
        scene["pane"] = square(bsdf, 2, tilt)
    else:
        scene["subject"] = square(bsdf, 1)
    return mi.load_dict(scene)


def main():
    means, noises = [], []
    for name, bsdf, is_pane in CELLS:
        scene = scene_of(bsdf, is_pane)
        pictures = np.array([np.array(mi.render(scene, spp=SPP, seed=i), float) for i in range(BATCHES)])
        means.append(pictures.mean(0))
        noises.append(pictures.std(0, ddof=1) / np.sqrt(BATCHES))
        print(name, means[-1].mean((0, 1)), noises[-1].max(), flush=True)
    picture = np.concatenate([np.concatenate(means, 1), np.concatenate(noises, 1)], 2).astype(np.float32)
    stored = mi.Bitmap(np.ascontiguousarray(picture), pixel_format=mi.Bitmap.PixelFormat.MultiChannel,
                       channel_names=["R", "G", "B", "noise.R", "noise.G", "noise.B"])
    for key, value in (("made_by", f"Mitsuba {mi.__version__}"), ("integrator", "volpath"), ("spp", SPP * BATCHES), ("seed", 0)):
        stored.metadata()["truth:" + key] = str(value)
    stored.write(str(Path(__file__).resolve().parents[2] / "tests/truth/references/extensions.exr"))


if __name__ == "__main__":
    main()
