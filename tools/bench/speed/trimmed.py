"""
Prints relMSE as `steradian compare` defines it, without the thousandth of the pixels that differ most: trimmed.py PICTURE REFERENCE

Runs in Mitsuba's Python, which reads EXR files. Where a picture has rare bright samples, the plain mean is that of a few pixels.
"""
import sys

import mitsuba
import numpy

LEFT_OUT = 1e-3  # of the pixels
mitsuba.set_variant("scalar_rgb")


def pixels(path):
    bitmap = mitsuba.Bitmap(path).convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.Float32, srgb_gamma=False)
    return numpy.array(bitmap, numpy.float64).reshape(-1, 3)


def trimmed(picture, reference):
    floor = 0.01 * numpy.median(reference[reference != 0])
    errors = numpy.sort(((picture - reference) ** 2 / (reference**2 + floor**2)).mean(1))
    return errors[:len(errors) - int(LEFT_OUT * len(errors))].mean()


if __name__ == "__main__":
    print(trimmed(pixels(sys.argv[1]), pixels(sys.argv[2])))
