"""What glTF says and Mitsuba's own plugins do not, as plugins for Mitsuba 3. Import it once a variant is set.

Written into a folder by `steradian export --to mitsuba`, next to the scene that needs it.
"""
import drjit as dr
import mitsuba as mi


def opaque(value):
    """A number that kernels take as an argument, so that one kernel serves every material."""
    return dr.opaque(mi.Float, float(value))


def color(props, name, default=1.0):
    value = props[name] if name in props else [default] * 3
    return mi.Color3f(*(opaque(value[i]) for i in range(3)))


def texture(props, name):
    return props[name] if name in props else None


class MetallicRoughness(mi.BSDF):
    """The BRDF of glTF 2.0, Appendix B: a metal and a coated diffuse dielectric that share one GGX lobe.

        f_r        = mix(dielectric, metal, metallic)
        metal      = F(base colour) D V
        dielectric = (1 - s max F(F0)) ρ/π + s F(F0) D V

    F: Schlick 1994, Eq. 15. D: Walter et al. 2007, Eq. 33. V = G / (4 cos cos): Heitz 2014, Eq. 99.
    s, F0: KHR_materials_specular, KHR_materials_ior.

    Factors are numbers; textures of the same name with `_texture` multiply them. Mitsuba's `wi` points to the viewer
    and its `wo` to the light; here they are called `view` and `light`.
    """

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.base_color = color(props, "base_color")
        self.metallic = opaque(props.get("metallic", 1.0))
        self.roughness = opaque(props.get("roughness", 1.0))
        self.F0_from_ior = opaque(props.get("F0", 0.04))
        self.specular = opaque(props.get("specular", 1.0))
        self.specular_color = color(props, "specular_color")
        self.normal_scale = opaque(props.get("normal_scale", 1.0))
        self.is_double_sided = props.get("double_sided", False)
        self.textures = {name: texture(props, name) for name in (
            "base_color_texture", "metallic_roughness_texture", "normal_texture", "specular_texture",
            "specular_color_texture", "vertex_color", "vertex_normal", "vertex_tangent", "vertex_handedness")}
        sides = mi.BSDFFlags.FrontSide | (mi.BSDFFlags.BackSide if self.is_double_sided else mi.BSDFFlags.Empty)
        self.m_components = [mi.BSDFFlags.GlossyReflection | sides, mi.BSDFFlags.DiffuseReflection | sides]
        self.m_flags = self.m_components[0] | self.m_components[1]

    def read(self, name, si, active):
        image = self.textures[name]
        return mi.Color3f(1.0) if image is None else mi.Color3f(image.eval_3(si, active))

    def vector(self, name, si, active):
        return mi.Vector3f(self.textures[name].eval_3(si, active))

    def normal(self, si, active):
        """The shading normal in the frame of `si`, on the side of the viewer (as shaders/surface/ has it)."""
        n = mi.Vector3f(0, 0, 1)
        if self.textures["normal_texture"] is not None:
            m = 2 * self.vector("normal_texture", si, active) - 1
            normal = self.vector("vertex_normal", si, active)  # as interpolated, not unit: MikkTSpace
            tangent = self.vector("vertex_tangent", si, active)
            bitangent = self.vector("vertex_handedness", si, active) * dr.cross(normal, tangent)
            n = si.to_local(dr.normalize((m.x * tangent + m.y * bitangent) * self.normal_scale + m.z * normal))
        if self.is_double_sided:
            n = dr.select(dr.dot(si.n, si.to_world(si.wi)) < 0, -n, n)
        cos_o = dr.dot(n, si.wi)
        return dr.select(cos_o >= 0, n, dr.normalize(n - cos_o * si.wi))

    def arrives(self, si, light, active):
        """Whether light comes from the side of the surface that is seen: a normal map does not bend it through."""
        if self.textures["normal_texture"] is None:
            return active
        n = si.to_local(self.vector("vertex_normal", si, active))
        if self.is_double_sided:
            n = dr.select(dr.dot(si.n, si.to_world(si.wi)) < 0, -n, n)
        return active & (dr.dot(n, light) > 0)

    def is_seen(self, si):
        return True if self.is_double_sided else dr.dot(si.n, si.to_world(si.wi)) > 0

    def surface(self, si, active):
        """n, base colour, metallic, alpha, F0 of the dielectric, weight of its layer."""
        base_color = self.base_color * self.read("base_color_texture", si, active) * self.read("vertex_color", si, active)
        rm = self.read("metallic_roughness_texture", si, active)
        roughness = dr.clip(self.roughness * rm.y, 0, 1)
        metallic = dr.clip(self.metallic * rm.z, 0, 1)
        alpha = dr.maximum(roughness * roughness, 1e-4)  # shaders/surface/at_fragment.glsl says why
        F0 = dr.minimum(self.F0_from_ior * self.specular_color * self.read("specular_color_texture", si, active), 1)
        specular = self.specular * self.read("specular_texture", si, active).x
        return self.normal(si, active), base_color, metallic, alpha, F0, specular

    @staticmethod
    def f_r(surface, view, light):
        n, base_color, metallic, alpha, F0, specular = surface
        cos_i, cos_o = dr.dot(n, light), dr.maximum(dr.dot(n, view), 0)
        h = dr.normalize(light + view)
        weight = dr.power(dr.clip(1 - dr.dot(view, h), 0, 1), 5)
        s, c, a2 = dr.cross(n, h), dr.dot(n, h), alpha * alpha
        D = a2 / (dr.pi * dr.square(dr.dot(s, s) + a2 * c * c))
        V = 0.5 / (cos_i * dr.sqrt(cos_o * cos_o * (1 - a2) + a2) + cos_o * dr.sqrt(cos_i * cos_i * (1 - a2) + a2))
        F = specular * (F0 + (1 - F0) * weight)
        dielectric = (1 - dr.max(F)) * base_color / dr.pi + F * D * V
        metal = (base_color + (1 - base_color) * weight) * D * V
        return dr.select(cos_i > 0, (1 - metallic) * dielectric + metallic * metal, 0)

    @staticmethod
    def specular_share(surface):
        """How often the specular lobe is sampled."""
        _, _, metallic, _, _, specular = surface
        return dr.select(specular > 0, dr.lerp(0.5, 1.0, metallic), metallic)

    @classmethod
    def density(cls, surface, view, light):
        """Of `sample`: visible GGX normals and cosines, in the shares that specular_share gives.

        The former: D G1 / (4 cos_o), Heitz 2018, Eq. 2 and 17, with G1 = 2 cos_o / (cos_o + √(…)) divided out.
        """
        frame = mi.Frame3f(surface[0])
        i, cos_o, a2 = frame.to_local(light), dr.maximum(dr.dot(surface[0], view), 0), dr.square(surface[3])
        D = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, surface[3]).eval(dr.normalize(frame.to_local(view) + i))
        share = cls.specular_share(surface)
        p = share * 0.5 * D / (cos_o + dr.sqrt(a2 + (1 - a2) * cos_o * cos_o)) + (1 - share) * i.z / dr.pi
        return dr.select(i.z > 0, p, 0)

    def sample(self, ctx, si, sample1, sample2, active=True):
        surface = self.surface(si, active)
        frame = mi.Frame3f(surface[0])
        o = frame.to_local(si.wi)
        o.z = dr.maximum(o.z, 0)
        ggx = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, surface[3])
        mirrored = mi.reflect(o, ggx.sample(o, sample2)[0])
        is_specular = sample1 < self.specular_share(surface)
        light = frame.to_world(dr.select(is_specular, mirrored, mi.warp.square_to_cosine_hemisphere(sample2)))
        bs = mi.BSDFSample3f()
        bs.wo = light
        bs.pdf = self.density(surface, si.wi, light)
        bs.eta = 1.0
        bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        bs.sampled_component = mi.UInt32(0)
        active = self.arrives(si, light, active & (bs.pdf > 0) & self.is_seen(si))
        value = self.f_r(surface, si.wi, light) * dr.maximum(dr.dot(surface[0], light), 0) / bs.pdf
        return bs, dr.select(active, value, 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        surface = self.surface(si, active)
        active = self.arrives(si, wo, active & self.is_seen(si))
        value = self.f_r(surface, si.wi, wo) * dr.maximum(dr.dot(surface[0], wo), 0)
        return dr.select(active, value, 0), dr.select(active, self.density(surface, si.wi, wo), 0)

    def eval(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[0]

    def pdf(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[1]

    def traverse(self, callback):
        pass

    def to_string(self):
        return "steradian_metallic_roughness[]"


class Profile:
    """A photometric profile: I(γ, φ) on a grid, linear between its angles, nothing beyond its first and last γ.

    γ [rad] is the angle to -profile_y, φ [rad] turns around it from profile_x to profile_z; the columns of one φ each hold
    all γ.
    """

    def __init__(self, props):
        array = mi.Float if dr.is_jit_v(mi.Float) else dr.scalar.ArrayXf
        self.gamma, self.phi, self.values = (array([float(v) for v in props[name].split()])
                                             for name in ("profile_gamma", "profile_phi", "profile_intensity"))
        self.count = [len(self.gamma), len(self.phi)]
        self.x, self.y, self.z = (mi.Vector3f(props["profile_" + axis]) for axis in "xyz")

    @staticmethod
    def interval(angles, count, angle):
        """The index of the grid's angle below, and how far it is to the next."""
        above = dr.binary_search(0, count, lambda i: dr.gather(mi.Float, angles, i) <= angle)
        low = mi.UInt32(dr.clip(mi.Int32(above) - 1, 0, count - 2))
        start, end = dr.gather(mi.Float, angles, low), dr.gather(mi.Float, angles, low + 1)
        return low, dr.clip((angle - start) / (end - start), 0, 1)

    def intensity(self, w):
        """In the direction w, which leaves the light [cd]."""
        x, y, z = dr.dot(w, self.x), dr.dot(w, self.y), dr.dot(w, self.z)
        gamma = dr.atan2(dr.hypot(x, z), -y)
        phi = dr.atan2(z, x)
        phi = dr.select(phi < 0, phi + 2 * dr.pi, phi)
        row, s = self.interval(self.gamma, self.count[0], gamma)
        column, t = self.interval(self.phi, self.count[1], phi)
        at = [dr.gather(mi.Float, self.values, (column + j) * self.count[0] + row + i) for j in (0, 1) for i in (0, 1)]
        slack = 1e-5  # π as a file printed it [rad]
        first, last = (dr.gather(mi.Float, self.gamma, mi.UInt32(i)) for i in (0, self.count[0] - 1))
        is_within = (gamma >= first - slack) & (gamma <= last + slack)
        return dr.select(is_within, dr.lerp(dr.lerp(at[0], at[1], s), dr.lerp(at[2], at[3], s), t), 0)


class Punctual(mi.Emitter):
    """A point or a spot of KHR_lights_punctual: I / d² · saturate(1 - (d / range)⁴) · saturate(cosθ scale + offset)².

    With a profile, I is the profile's times a factor.
    """

    def __init__(self, props):
        mi.Emitter.__init__(self, props)
        self.position = mi.Point3f(props["position"])
        self.direction = mi.Vector3f(props["direction"])
        self.intensity = color(props, "intensity")
        self.inverse_range = opaque(props.get("inverse_range", 0.0))
        self.cone_scale = opaque(props.get("cone_scale", 0.0))
        self.cone_offset = opaque(props.get("cone_offset", 1.0))
        self.profile = Profile(props) if "profile_gamma" in props else None
        self.m_flags = +mi.EmitterFlags.DeltaPosition

    def sample_direction(self, it, sample, active=True):
        ds = mi.DirectionSample3f()
        ds.p = self.position
        ds.n = 0
        ds.uv = 0
        ds.time = it.time
        ds.pdf = 1.0
        ds.delta = True
        ds.emitter = mi.EmitterPtr(self) if dr.is_jit_v(mi.Float) else self
        ds.d = self.position - it.p
        ds.dist = dr.norm(ds.d)
        ds.d = ds.d / ds.dist
        cone = dr.square(dr.clip(dr.dot(self.direction, -ds.d) * self.cone_scale + self.cone_offset, 0, 1))
        window = dr.clip(1 - dr.power(ds.dist * self.inverse_range, 4), 0, 1)
        I = self.intensity if self.profile is None else self.intensity * self.profile.intensity(-ds.d)
        return ds, dr.select(active, I * cone * window / dr.square(ds.dist), 0)

    def eval_direction(self, it, ds, active=True):
        return self.sample_direction(it, mi.Point2f(0), active)[1]

    def pdf_direction(self, it, ds, active=True):
        return mi.Float(0)

    def eval(self, si, active=True):
        return mi.Color3f(0)

    def bbox(self):
        return mi.ScalarBoundingBox3f()

    def traverse(self, callback):
        pass

    def to_string(self):
        return "steradian_punctual[]"


mi.register_bsdf("steradian_metallic_roughness", MetallicRoughness)
mi.register_emitter("steradian_punctual", Punctual)
