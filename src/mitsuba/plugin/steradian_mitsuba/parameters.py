"""Reading what scene.xml states."""
import drjit as dr
import mitsuba as mi


def opaque(value):
    """A number that kernels take as an argument, so that one kernel serves every material."""
    return dr.opaque(mi.Float, float(value))


def number(props, name, default):
    return opaque(props.get(name, default))


def color(props, name, default=1.0):
    value = props[name] if name in props else [default] * 3
    return mi.Color3f(*(opaque(value[i]) for i in range(3)))


def child(props, name):
    """A texture or another object, or None."""
    return props[name] if name in props else None
