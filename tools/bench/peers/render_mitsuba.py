"""Mitsuba, from a folder that `steradian export` wrote. Integrator `direct` with shadows; a frame is one sample a pixel."""
import os
import sys

import mitsuba

from view import view

v = view()
mitsuba.set_variant(os.environ["STERADIAN_VARIANT"])
sys.path.insert(0, v.scene)
import steradian_mitsuba  # noqa: E402, F401: importing registers the plugins

scene = mitsuba.load_file(f"{v.scene}/scene.xml")
for i in range(v.frames):
    image = mitsuba.Bitmap(mitsuba.render(scene, spp=1, seed=i))
    picture = image.convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.UInt8, srgb_gamma=True)
picture.write(v.output)
