"""New lights for `Scene.lights`, each with one quantity."""
from __future__ import annotations

from typing import Sequence

from . import _native
from ._program import told_in_python

Vector = Sequence[float]


def _emit(light: _native.Light, color: Vector, **quantities: float | None) -> _native.Light:
    """Gives a light its colour, then the one quantity that is given."""
    given = {name: value for name, value in quantities.items() if value is not None}
    if len(given) != 1:
        raise ValueError(f"a new light has one of {', '.join(quantities)}; {len(given)} are given")
    light.value = tuple(color)
    for name, value in given.items():
        setattr(light, name, value)
    return light


def point_light(position: Vector, *, flux: float | None = None, intensity: float | None = None, radiance: float | None = None,
                color: Vector = (1, 1, 1), radius: float = 0.0, name: str = "point") -> _native.Light:
    """Returns a point light, or with a radius [m] a sphere that shines as one.

    flux [lm], intensity [cd] or radiance [cd/m²], of which one is given, are luminances; `color` is linear RGB of any scale.

    >>> steradian.point_light((0, 2, 0), flux=800).intensity    # 800 lm / 4π
    63.66...
    """
    with told_in_python():
        return _emit(_native.point_light(tuple(position), radius, name), color, flux=flux, intensity=intensity, radiance=radiance)


def spot_light(position: Vector, direction: Vector, *, outer_angle: float, inner_angle: float = 0.0, flux: float | None = None,
               intensity: float | None = None, color: Vector = (1, 1, 1), name: str = "spot") -> _native.Light:
    """Returns a light within a cone; the half angles are in degrees, the intensity [cd] is that on the axis."""
    with told_in_python():
        return _emit(_native.spot_light(tuple(position), tuple(direction), inner_angle, outer_angle, name), color, flux=flux,
                     intensity=intensity)


def directional_light(direction: Vector, *, irradiance: float | None = None, radiance: float | None = None,
                      color: Vector = (1, 1, 1), angular_diameter: float = 0.0, name: str = "sun") -> _native.Light:
    """Returns light from infinitely far that goes in `direction`; irradiance [lx] is that of a surface that faces it.

    angular_diameter [degrees] makes it a disk in the sky; the sun's is 0.53.
    """
    with told_in_python():
        return _emit(_native.directional_light(tuple(direction), angular_diameter, name), color, irradiance=irradiance,
                     radiance=radiance)


def rectangle_light(position: Vector, direction: Vector, width: float, height: float, *, flux: float | None = None,
                    intensity: float | None = None, radiance: float | None = None, color: Vector = (1, 1, 1),
                    name: str = "rectangle") -> _native.Light:
    """Returns a flat light of width × height [m] that shines towards `direction`."""
    with told_in_python():
        return _emit(_native.rectangle_light(tuple(position), tuple(direction), width, height, name), color, flux=flux,
                     intensity=intensity, radiance=radiance)


def disk_light(position: Vector, direction: Vector, radius: float, *, flux: float | None = None, intensity: float | None = None,
               radiance: float | None = None, color: Vector = (1, 1, 1), name: str = "disk") -> _native.Light:
    """Returns a disk of a radius [m] that shines towards `direction`."""
    with told_in_python():
        return _emit(_native.disk_light(tuple(position), tuple(direction), radius, name), color, flux=flux, intensity=intensity,
                     radiance=radiance)


def sphere_light(position: Vector, radius: float, *, flux: float | None = None, intensity: float | None = None,
                 radiance: float | None = None, color: Vector = (1, 1, 1), name: str = "sphere") -> _native.Light:
    """Returns a sphere of a radius [m]."""
    with told_in_python():
        return _emit(_native.sphere_light(tuple(position), radius, name), color, flux=flux, intensity=intensity, radiance=radiance)
