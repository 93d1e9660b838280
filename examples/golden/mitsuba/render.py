"""Renders a box of light with Mitsuba 3, as linear EXR.  usage: render.py SEED OUT.exr"""
import sys

import mitsuba as mi

mi.set_variant("scalar_rgb")
seed, out = int(sys.argv[1]), sys.argv[2]
scene = mi.cornell_box()
scene["sensor"]["film"].update(width=48, height=48)
image = mi.render(mi.load_dict(scene), spp=32, seed=seed)
mi.Bitmap(image).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32).write(out)
