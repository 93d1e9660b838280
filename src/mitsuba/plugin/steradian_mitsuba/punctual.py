"""The lights of KHR_lights_punctual and EXT_lights_ies."""
import drjit as dr
import mitsuba as mi

from .parameters import color, opaque


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
