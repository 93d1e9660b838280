"""The parts of Steradian that Python calls."""

from collections.abc import Mapping, Sequence
from typing import Annotated

import numpy
from numpy.typing import NDArray


def start(arg0: object, arg1: object, arg2: str, /) -> None: ...

def end() -> None: ...

class Light:
    """
    A light. Positions are in metres in the file's world. Quantities are luminances of linear Rec. 709 RGB, in lm, cd, lx and cd/m², or in watts where the file counts in watts.
    """

    @property
    def name(self) -> str:
        """its name, which its layer has as well"""

    @name.setter
    def name(self, arg: str, /) -> None: ...

    @property
    def kind(self) -> str:
        """
        point, spot, directional, sun, profile, rectangle, disk, sphere, tube, polygon, mesh or environment
        """

    @property
    def unit(self) -> str:
        """the unit of `value`; 1 where a profile gives the intensities"""

    @property
    def value(self) -> list[float]:
        """the light's own quantity, I, E or L, as linear RGB in `unit`"""

    @value.setter
    def value(self, arg: Sequence[float], /) -> None: ...

    @property
    def position(self) -> list[float] | None:
        """the middle of its extent [m]; None if it is far"""

    @position.setter
    def position(self, arg: Sequence[float], /) -> None: ...

    @property
    def direction(self) -> list[float] | None:
        """where the light goes, or a flat light faces; None where there is none"""

    @direction.setter
    def direction(self, arg: Sequence[float], /) -> None: ...

    @property
    def sizes(self) -> dict:
        """its sizes by name [m]: width, height, radius, length"""

    def resize(self, name: str, value: float) -> None:
        """Sets one of `sizes`."""

    @property
    def is_edited(self) -> bool: ...

    def copy(self) -> Light:
        """Returns a light like it."""

    def __repr__(self) -> str: ...

    @property
    def flux(self) -> float | None:
        """Φ [lm]; None where the light has none of its own"""

    @flux.setter
    def flux(self, arg: float, /) -> None: ...

    @property
    def intensity(self) -> float | None:
        """I on the axis [cd]; None where it has none"""

    @intensity.setter
    def intensity(self, arg: float, /) -> None: ...

    @property
    def irradiance(self) -> float | None:
        """E on a surface that faces it [lx]; of directional lights"""

    @irradiance.setter
    def irradiance(self, arg: float, /) -> None: ...

    @property
    def radiance(self) -> float | None:
        """L [cd/m²]; None for lights without extent"""

    @radiance.setter
    def radiance(self, arg: float, /) -> None: ...

def point_light(arg0: Sequence[float], arg1: float, arg2: str, /) -> Light: ...

def spot_light(arg0: Sequence[float], arg1: Sequence[float], arg2: float, arg3: float, arg4: str, /) -> Light: ...

def directional_light(arg0: Sequence[float], arg1: float, arg2: str, /) -> Light: ...

def rectangle_light(arg0: Sequence[float], arg1: Sequence[float], arg2: float, arg3: float, arg4: str, /) -> Light: ...

def disk_light(arg0: Sequence[float], arg1: Sequence[float], arg2: float, arg3: str, /) -> Light: ...

def sphere_light(arg0: Sequence[float], arg1: float, arg2: str, /) -> Light: ...

class Material:
    """The factors of a material; textures multiply them as in the file."""

    @property
    def name(self) -> str: ...

    @property
    def index(self) -> int:
        """the number in the AOV `material`"""

    @property
    def model(self) -> str:
        """its BRDF and layers"""

    @property
    def is_edited(self) -> bool: ...

    @property
    def emission(self) -> list[float]:
        """L_e as linear RGB [cd/m²]; its surfaces become lights"""

    @emission.setter
    def emission(self, arg: Sequence[float], /) -> None: ...

    @property
    def base_color(self) -> list[float]:
        """linear RGB, 0 to 1"""

    @base_color.setter
    def base_color(self, arg: Sequence[float], /) -> None: ...

    def copy(self) -> Material:
        """Returns a material like it."""

    def __repr__(self) -> str: ...

    @property
    def metallic(self) -> float:
        """0 to 1"""

    @metallic.setter
    def metallic(self, arg: float, /) -> None: ...

    @property
    def roughness(self) -> float:
        """0 to 1"""

    @roughness.setter
    def roughness(self, arg: float, /) -> None: ...

class Image:
    def __init__(self, arg0: Annotated[NDArray[numpy.float32], dict(shape=(None, None, None), order='C', device='cpu', writable=False)], arg1: Sequence[str], arg2: int, /) -> None: ...

    @property
    def width(self) -> int: ...

    @property
    def height(self) -> int: ...

    @property
    def channel_names(self) -> list[str]: ...

    @property
    def attributes(self) -> dict: ...

    def channels(self, arg0: int, arg1: int, /) -> object: ...

    def write(self, file: str, type: str) -> None: ...

def read_image(arg: str, /) -> Image: ...

class Limits:
    def __init__(self) -> None: ...

    @property
    def tolerances(self) -> list[str]: ...

    @tolerances.setter
    def tolerances(self, arg: Sequence[str], /) -> None: ...

    @property
    def allows_nonfinite(self) -> bool: ...

    @allows_nonfinite.setter
    def allows_nonfinite(self, arg: bool, /) -> None: ...

    @property
    def region(self) -> tuple[int, int, int, int] | None: ...

    @region.setter
    def region(self, arg: tuple[int, int, int, int] | None, /) -> None: ...

    @property
    def mask(self) -> Image: ...

    @mask.setter
    def mask(self, arg: Image, /) -> None: ...

    @property
    def noise(self) -> list[Image]: ...

    @noise.setter
    def noise(self, arg: Sequence[Image], /) -> None: ...

    @property
    def layer(self) -> str: ...

    @layer.setter
    def layer(self, arg: str, /) -> None: ...

    @property
    def encoding(self) -> str: ...

    @encoding.setter
    def encoding(self, arg: str, /) -> None: ...

class Compared:
    @property
    def json(self) -> str: ...

    @property
    def error(self) -> Image: ...

    @property
    def heat_map(self) -> Image: ...

    @property
    def side_by_side(self) -> Image: ...

def compare(arg0: Image, arg1: Image, arg2: Limits, /) -> Compared: ...

class RenderedPicture:
    @property
    def summary(self) -> str: ...

    @property
    def image(self) -> Image: ...

    @property
    def exposure(self) -> float: ...

    def save(self, files: Sequence[str], exposure: float | None, tone_curve: str, exr_type: str) -> float | None: ...

    def displayed(self, exposure: float | None, tone_curve: str) -> Image: ...

def options() -> list:
    """The table of options: a dict each."""

def load(arg0: str, arg1: Mapping[str, Sequence[str]], /) -> SceneFile: ...

class SceneFile:
    @property
    def file(self) -> str: ...

    def contents(self) -> dict: ...

    def warnings(self) -> list[str]: ...

    def lights(self) -> list[Light]: ...

    def materials(self) -> list[Material]: ...

    def render(self, options: Mapping[str, Sequence[str]], lights: Sequence[Light] | None, materials: Sequence[Material], progress: object | None) -> RenderedPicture: ...

    def probe(self, column: int, row: int, options: Mapping[str, Sequence[str]], lights: Sequence[Light] | None, materials: Sequence[Material]) -> dict: ...

    def camera(self, camera: str, lights: Sequence[Light] | None, materials: Sequence[Material]) -> dict: ...

    def save(self, target: str, camera: str, lights: Sequence[Light] | None, materials: Sequence[Material]) -> None: ...

class EvaluatedBrdf:
    def __init__(self, arg0: str, arg1: Mapping[str, Sequence[float]], arg2: str, arg3: bool, /) -> None: ...

    def f_r(self, arg0: Annotated[NDArray[numpy.float32], dict(shape=(None, None), order='C', device='cpu', writable=False)], arg1: Annotated[NDArray[numpy.float32], dict(shape=(None, None), order='C', device='cpu', writable=False)], /) -> object: ...

    def albedo(self, arg0: Annotated[NDArray[numpy.float32], dict(shape=(None, None), order='C', device='cpu', writable=False)], arg1: int, /) -> object: ...

    def samples(self, arg0: Sequence[float], arg1: Annotated[NDArray[numpy.float32], dict(shape=(None, None), order='C', device='cpu', writable=False)], /) -> object: ...

    def polar_plot(self, arg: str, /) -> str: ...

    def laws(self) -> list: ...

def brdf_parameters() -> list: ...

def check_assignment(arg0: str, arg1: float, arg2: str, arg3: str, arg4: str, /) -> tuple: ...
