"""From spectra to linear RGB with Rec. 709 primaries and a D65 white."""
import math

# XYZ to linear Rec. 709, IEC 61966-2-1.
RGB_FROM_XYZ = ((3.2404542, -1.5371385, -0.4985314), (-0.9692660, 1.8760108, 0.0415560), (0.0556434, -0.2040259, 1.0572252))
LUMINANCE = (0.2126, 0.7152, 0.0722)  # Y of the three primaries, ITU-R BT.709-6


def lobe(wavelength, center, below, above):
    spread = (wavelength - center) * (below if wavelength < center else above)
    return math.exp(-0.5 * spread * spread)


def observer(wavelength):
    """The CIE 1931 standard observer at a wavelength [nm]: Wyman, Sloan & Shirley 2013, Eq. 4 and Table 1."""
    x = (0.362 * lobe(wavelength, 442.0, 0.0624, 0.0374) + 1.056 * lobe(wavelength, 599.8, 0.0264, 0.0323)
         - 0.065 * lobe(wavelength, 501.1, 0.0490, 0.0382))
    y = 0.821 * lobe(wavelength, 568.8, 0.0213, 0.0247) + 0.286 * lobe(wavelength, 530.9, 0.0613, 0.0322)
    z = 1.217 * lobe(wavelength, 437.0, 0.0845, 0.0278) + 0.681 * lobe(wavelength, 459.0, 0.0385, 0.0725)
    return x, y, z


def linear_rgb(spectrum, wavelengths):
    """Σ spectrum(λ) observer(λ) as linear RGB, in arbitrary scale."""
    xyz = [sum(spectrum(wavelength) * observer(wavelength)[i] for wavelength in wavelengths) for i in range(3)]
    return tuple(sum(weight * value for weight, value in zip(row, xyz)) for row in RGB_FROM_XYZ)


def luminance(rgb):
    return sum(weight * channel for weight, channel in zip(LUMINANCE, rgb))


def with_luminance(rgb, wanted):
    """The colour `rgb` scaled to a luminance [cd/m²]."""
    return tuple(channel * wanted / luminance(rgb) for channel in rgb)
