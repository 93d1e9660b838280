"use strict";
// From the text that the page carries back to linear floats, and from floats to colours on a screen.

/** The value of a half float (IEEE 754 binary16) given as 16 bits. */
function half_value(bits) {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  if (exponent === 0) return sign * fraction * 2 ** -24;
  return sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

const half_values = Float64Array.from({ length: 65536 }, (_, bits) => half_value(bits));

/** {width, height, rgb} from what page.cpp packed. */
async function unpacked(packed) {
  const bytes = Uint8Array.from(atob(packed.data), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = packed.width * packed.height;
  const rgb = new Float32Array(3 * count);
  for (let c = 0; c < 3; ++c)
    for (let i = 0; i < count; ++i) {
      const bits = (planes[2 * c * count + i] << 8) | planes[(2 * c + 1) * count + i];
      rgb[3 * i + c] = half_values[bits] / packed.scale;
    }
  return { width: packed.width, height: packed.height, rgb };
}

/** sRGB codes (IEC 61966-2-1) of linear values 0..1 in steps of 1/16383. */
const srgb_codes = Uint8ClampedArray.from({ length: 16384 }, (_, i) => {
  const v = i / 16383;
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
});
const srgb_code = (v) => srgb_codes[Math.max(0, Math.min(16383, Math.round(v * 16383)))];

const luminance = (rgb, i) => 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];

/** The factor that brings the log-average of the lit pixels to middle grey (Reinhard et al. 2002, Eq. 1). */
function automatic_exposure(image) {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < image.rgb.length; i += 3) {
    const y = luminance(image.rgb, i);
    if (y > 0 && y < Infinity) {
      sum += Math.log(y);
      ++count;
    }
  }
  return count ? 0.18 / Math.exp(sum / count) : 1;
}

const nonfinite_colour = [255, 0, 255];

/** Paints one pixel after the other: `colour(i)` gives [r, g, b] in 0..255 for the pixel whose red is rgb[i]. */
function paint(canvas, image, colour) {
  canvas.width = image.width;
  canvas.height = image.height;
  const picture = new ImageData(image.width, image.height);
  for (let i = 0, o = 0; i < image.rgb.length; i += 3, o += 4) {
    const [r, g, b] = colour(i);
    picture.data[o] = r;
    picture.data[o + 1] = g;
    picture.data[o + 2] = b;
    picture.data[o + 3] = 255;
  }
  canvas.getContext("2d").putImageData(picture, 0, 0);
}

/** Light through exposure and the sRGB curve; a picture for screens only through the exposure. */
function paint_picture(canvas, image, factor, is_display_referred) {
  const { rgb } = image;
  const code = is_display_referred ? (v) => 255 * v : srgb_code;
  paint(canvas, image, (i) => {
    const finite = Number.isFinite(rgb[i]) && Number.isFinite(rgb[i + 1]) && Number.isFinite(rgb[i + 2]);
    if (!finite) return nonfinite_colour;
    return [code(rgb[i] * factor), code(rgb[i + 1] * factor), code(rgb[i + 2] * factor)];
  });
}

/** What is added to a denominator, so that darkness does not make differences large: 1 % of the mean. */
function relative_floor(image) {
  let sum = 0;
  for (const v of image.rgb) if (Number.isFinite(v)) sum += Math.abs(v);
  return Math.max((0.01 * sum) / image.rgb.length, 1e-30);
}

/** The gain, 1 to 10000 in tens, at which all but the largest hundredth of the differences are seen. */
function automatic_gain(test, golden) {
  const floor = relative_floor(golden);
  const sizes = golden.rgb.map((g, i) => Math.abs(test.rgb[i] - g) / (Math.abs(g) + floor)).filter(Number.isFinite).sort();
  const large = sizes[Math.floor(0.99 * (sizes.length - 1))] || 1;
  return 10 ** Math.max(0, Math.min(4, Math.round(-Math.log10(large))));
}

/** Relative difference times `gain`: brighter than the golden is warm, darker is cold, palest from 1 on. */
function paint_difference(canvas, test, golden, gain) {
  const floor = relative_floor(golden);
  paint(canvas, golden, (i) => {
    let signed = 0;
    for (let c = 0; c < 3; ++c) {
      const d = (test.rgb[i + c] - golden.rgb[i + c]) / (Math.abs(golden.rgb[i + c]) + floor);
      if (!Number.isFinite(d) && !Object.is(test.rgb[i + c], golden.rgb[i + c])) return nonfinite_colour;
      if (Math.abs(d) > Math.abs(signed)) signed = d;
    }
    const a = Math.min(1, Math.abs(signed) * gain);
    const bright = 255 * a ** 0.6;
    return signed >= 0 ? [bright, 0.8 * bright * a, 0.35 * bright * a] : [0.3 * bright * a, 0.65 * bright * a, bright];
  });
}
