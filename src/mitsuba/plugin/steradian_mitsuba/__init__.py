"""What glTF and Steradian say and Mitsuba's own plugins do not, as plugins for Mitsuba 3. Import it once a variant is set.

Written into a folder by `steradian export --to mitsuba`, next to the scene that needs it. A subclass of Reflector in any file
here is a plugin: BlinnPhong is steradian_blinn_phong.
"""
import importlib
import pkgutil
import re

import mitsuba as mi

from .punctual import Punctual
from .reflector import Reflector


def subclasses(cls):
    for heir in cls.__subclasses__():
        yield heir
        yield from subclasses(heir)


for module in pkgutil.iter_modules(__path__):
    importlib.import_module("." + module.name, __name__)
for bsdf in subclasses(Reflector):
    mi.register_bsdf("steradian_" + re.sub(r"(?<!^)(?=[A-Z])", "_", bsdf.__name__).lower(), bsdf)
mi.register_emitter("steradian_punctual", Punctual)
