"""What glTF and Steradian say and Mitsuba's own plugins do not, as plugins for Mitsuba 3. Import it once a variant is set.

Written into a folder by `steradian export --to mitsuba`, next to the scene that needs it.
"""
import mitsuba as mi

from .framed import Framed
from .measured import Measured
from .metallic_roughness import MetallicRoughness
from .metals import Conductor, Ggx
from .oren_nayar import OrenNayar
from .phong import BlinnPhong, Phong
from .punctual import Punctual

for name, plugin in {"blinn_phong": BlinnPhong, "conductor": Conductor, "framed": Framed, "ggx": Ggx, "merl": Measured,
                     "metallic_roughness": MetallicRoughness, "oren_nayar": OrenNayar, "phong": Phong}.items():
    mi.register_bsdf("steradian_" + name, plugin)
mi.register_emitter("steradian_punctual", Punctual)
