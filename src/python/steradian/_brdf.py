"""BRDFs by themselves, evaluated by the shaders that render."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._program import told_in_python


@dataclass(frozen=True)
class Law:
    """A law that BRDFs obey: it holds while `worst` is at most `limit`."""
    law: str
    holds: bool
    worst: float
    limit: float
    where: str
    broken_by_definition: bool


def _rows(values: Any, columns: int) -> NDArray[np.float32]:
    array = np.asarray(values, np.float32)
    if array.ndim == 0 or array.shape[-1] != columns:
        raise ValueError(f"the last axis has {columns} numbers, not the shape {array.shape}")
    return np.ascontiguousarray(array.reshape(-1, columns))


class Brdf:
    """A BRDF. Directions are unit vectors that point away from the surface, whose normal is z and whose tangent is x."""

    def __init__(self, name: str, native: _native.EvaluatedBrdf) -> None:
        self.name = name
        self._native = native

    def f_r(self, wi: Any, wo: Any) -> NDArray[np.float32]:
        """Returns f_r(wi, wo) [1/sr] as float32, … × 3, by the GLSL of the renderer.

        wi, wo: … × 3; their leading axes broadcast.
        """
        wi, wo = np.broadcast_arrays(np.asarray(wi, np.float32), np.asarray(wo, np.float32))
        with told_in_python():
            return np.asarray(self._native.f_r(_rows(wi, 3), _rows(wo, 3))).reshape(wi.shape)

    __call__ = f_r

    def albedo(self, wo: Any, count: int = 8192) -> NDArray[np.float32]:
        """Returns ∫ f_r cosθ_i dω_i for each wo as float32, … × 3, from `count` directions each."""
        wo = np.asarray(wo, np.float32)
        with told_in_python():
            return np.asarray(self._native.albedo(_rows(wo, 3), count)).reshape(wo.shape)

    def sample(self, wo: Any, u: Any) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Returns the directions that the BRDF's own sampling makes of u (… × 2, in [0, 1)), and their densities [1/sr]."""
        u = np.asarray(u, np.float32)
        with told_in_python():
            rows = np.asarray(self._native.samples(tuple(float(v) for v in wo), _rows(u, 2)))
        return rows[:, :3].reshape(*u.shape[:-1], 3), rows[:, 3].reshape(u.shape[:-1])

    def laws(self) -> list[Law]:
        """Checks reciprocity, negativity, energy and the sampling, as `steradian brdf` does."""
        with told_in_python():
            return [Law(**row) for row in self._native.laws()]

    def polar_plot(self) -> str:
        """Returns f_r cosθ_i in the plane of incidence as SVG, a curve for wo at 0°, 30°, 60° and 80°."""
        with told_in_python():
            return self._native.polar_plot(self.name)

    def _repr_svg_(self) -> str:
        return self.polar_plot()

    def __repr__(self) -> str:
        return f"<Brdf {self.name}>"


def brdf(name: str | os.PathLike[str], *, metal: str | None = None, energy_compensation: bool = False,
         **parameters: float | Sequence[float]) -> Brdf:
    """Returns a BRDF by its name: gltf, lambert, oren_nayar, phong, blinn_phong, ggx or conductor; a .glsl file that declares
    f_r; a .binary file of the MERL database.

    metal: of conductor, such as "gold". The parameters are the options of `steradian brdf`, with _ for -: roughness=0.3,
    base_color=(1, 0.5, 0.2).

    >>> lambert = steradian.brdf("lambert", base_color=(1, 0.5, 0))
    >>> lambert.f_r((0, 0, 1), (0, 0.6, 0.8)) * np.pi
    array([1. , 0.5, 0. ], dtype=float32)
    """
    given = {key: [float(v) for v in np.atleast_1d(value)] for key, value in parameters.items()}
    with told_in_python():
        return Brdf(os.fspath(name), _native.EvaluatedBrdf(os.fspath(name), given, metal or "", energy_compensation))
