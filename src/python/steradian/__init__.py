"""Steradian renders glTF scenes under their own lights, in physical units, by the same code as the command `steradian`.

>>> import steradian
>>> scene = steradian.load(steradian.sample("cornell"))
>>> picture = scene.render(size=(32, 32), samples=4)
>>> picture.image.shape, picture.image.dtype
((32, 32, 4), dtype('float32'))
>>> picture.unit
'cd/m^2'

An array of a picture has the shape height × width × channels, with the top row first. Its values are radiance in cd/m², linear
Rec. 709 red, green and blue, and the coverage by surfaces, 0 to 1.
"""
try:
    from . import _native
except ImportError as error:
    missing, found, _ = str(error).partition(": cannot open shared object file")
    if not found:
        raise
    raise ImportError(f"{missing}: no such library on this system: install the package that has it (apt-file search {missing}); a wheel is for "
                      "the release of Debian or Ubuntu that it was built on") from None
from ._program import Error, Remark, program, sample, samples, start

start()

from ._assignment import Assignment, Marks  # noqa: E402
from ._brdf import Brdf, Law, brdf  # noqa: E402
from ._compare import Comparison, Diagnosis, Verdict, compare, read_image  # noqa: E402
from ._lights import (directional_light, disk_light, point_light, rectangle_light, sphere_light,  # noqa: E402
                      spot_light)
from ._probe import LightTerms, Probe  # noqa: E402
from ._result import Result  # noqa: E402
from ._scene import Animation, Camera, Scene, load  # noqa: E402

Light = _native.Light
Material = _native.Material
__version__ = str(vars(_native)["__version__"])

__all__ = ["Animation", "Assignment", "Brdf", "Camera", "Comparison", "Diagnosis", "Error", "Law", "Light", "LightTerms",
           "Marks", "Material", "Probe", "Remark", "Result", "Scene", "Verdict", "brdf", "compare", "directional_light",
           "disk_light", "load", "point_light", "program", "read_image", "rectangle_light", "sample", "samples",
           "sphere_light", "spot_light"]
