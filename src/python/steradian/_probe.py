"""The equation at a pixel."""
from __future__ import annotations

from dataclasses import asdict, dataclass, fields
from html import escape
from typing import Any

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class LightTerms:
    """What one light adds to a pixel. Values are means over the samples; triples are RGB, but for `wi`."""
    name: str
    kind: str
    solid_angle: float  # Ω [sr]; 0 for lights without extent
    wi: Vector  # mean direction to the light, weighted by E
    cos_i: float  # mean cosθ_i, weighted by E
    V: float  # visibility, 0 to 1
    V_rgb: Vector
    E: Vector  # irradiance, shadows included [lx]
    f_r: Vector  # L_r / E [1/sr]
    L_r: Vector  # reflected radiance [cd/m²]


@dataclass(frozen=True)
class Probe:
    """L_o = L_e + Σ L_r at a pixel."""
    pixel: tuple[int, int]  # column, row
    size: tuple[int, int]  # of the picture
    camera: str
    x: Vector  # the point at the pixel's centre [m]
    n: Vector
    wo: Vector
    coverage: float  # of the pixel by surfaces, 0 to 1
    L_e: Vector  # emission and background [cd/m²]
    L_o: Vector  # the pixel as render has it [cd/m²]
    lights: list[LightTerms]

    def records(self) -> list[dict[str, Any]]:
        """Returns the lights as a dict each."""
        return [asdict(light) for light in self.lights]

    def table(self) -> Any:
        """Returns the lights as a pandas.DataFrame, one row each, vectors in columns such as `E.r` and `wi.x`."""
        import pandas

        rows = []
        for record in self.records():
            row: dict[str, Any] = {}
            for key, value in record.items():
                if isinstance(value, tuple):
                    row |= {f"{key}.{axis}": part for axis, part in zip("xyz" if key == "wi" else "rgb", value)}
                else:
                    row[key] = value
            rows.append(row)
        return pandas.DataFrame(rows)

    def _repr_html_(self) -> str:
        heads = "".join(f"<th>{field.name}</th>" for field in fields(LightTerms))
        rows = "".join("<tr>" + "".join(f"<td>{escape(_cell(value))}</td>" for value in asdict(light).values()) + "</tr>"
                       for light in self.lights)
        sums = f"<p>L_e = {escape(_cell(self.L_e))}, L_o = {escape(_cell(self.L_o))} cd/m²</p>"
        return f"<p>pixel {self.pixel[0]}, {self.pixel[1]}</p><table><tr>{heads}</tr>{rows}</table>{sums}"


def _cell(value: Any) -> str:
    if isinstance(value, tuple):
        return " ".join(f"{part:.4g}" for part in value)
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def probe_of(pixel: tuple[int, int], terms: dict[str, Any]) -> Probe:
    """Makes the probe of what the native part tells."""
    return Probe(pixel=pixel, **terms | {"lights": [LightTerms(**row) for row in terms["lights"]]})
