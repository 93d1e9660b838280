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

/** The channels that page.cpp packed, each a Float32Array of width times height values. */
async function unpacked_channels(packed) {
  const bytes = Uint8Array.from(atob(packed.data), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = packed.width * packed.height;
  return Array.from({ length: packed.channels }, (_, c) => {
    const values = new Float32Array(count);
    for (let i = 0; i < count; ++i) {
      const bits = (planes[2 * c * count + i] << 8) | planes[(2 * c + 1) * count + i];
      values[i] = half_values[bits] / packed.scale;
    }
    return values;
  });
}

/** {width, height, rgb, alpha} from what page.cpp packed; alpha is null where the picture has none. */
async function unpacked(packed) {
  const channels = await unpacked_channels(packed);
  const rgb = new Float32Array(3 * packed.width * packed.height);
  for (let c = 0; c < 3; ++c) {
    const values = channels[Math.min(c, channels.length - 1)];
    for (let i = 0; i < values.length; ++i) rgb[3 * i + c] = values[i];
  }
  return { width: packed.width, height: packed.height, rgb, alpha: channels[3] || null };
}

/** {width, height, values}: the errors of pixels over their limits; NaN is not finite, -1 is not compared. */
async function unpacked_errors(packed) {
  return { width: packed.width, height: packed.height, values: (await unpacked_channels(packed))[0] };
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

/** A light or a dark square of a checkerboard behind transparent pixels. */
function checker(pixel, width) {
  const x = pixel % width;
  const y = (pixel - x) / width;
  return ((x >> 3) + (y >> 3)) & 1 ? 200 : 130;
}

/**
 * Light through exposure and the sRGB curve; a picture for screens only through the exposure. `alpha_mode`: "over" puts
 * it on a checkerboard (colours are associated with alpha), "alone" shows alpha as grey.
 */
function paint_picture(canvas, image, factor, is_display_referred, alpha_mode) {
  const { rgb, alpha } = image;
  const code = is_display_referred ? (v) => 255 * v : srgb_code;
  const behind = (i) => (1 - Math.max(0, Math.min(1, alpha[i / 3]))) * checker(i / 3, image.width);
  paint(canvas, image, (i) => {
    if (alpha && alpha_mode === "alone") return Array(3).fill(255 * alpha[i / 3]);
    const finite = Number.isFinite(rgb[i]) && Number.isFinite(rgb[i + 1]) && Number.isFinite(rgb[i + 2]);
    if (!finite) return nonfinite_colour;
    const below = alpha && alpha_mode === "over" ? behind(i) : 0;
    return [below + code(rgb[i] * factor), below + code(rgb[i + 1] * factor), below + code(rgb[i + 2] * factor)];
  });
}

/** Whether a pixel is over its limit, or not finite. */
const is_failing = (error) => !(error <= 1);

/**
 * What broke the limit: pixels over it from yellow to red (32 times the limit and more), those that are not finite
 * magenta, those within it in shades of blue, those that are not compared grey.
 */
function paint_limits(canvas, errors) {
  paint(canvas, { ...errors, rgb: { length: 3 * errors.values.length } }, (i) => {
    const error = errors.values[i / 3];
    if (Number.isNaN(error)) return nonfinite_colour;
    if (error < 0) return [70, 70, 70];
    if (error <= 1) return [10 + 30 * error, 20 + 70 * error, 45 + 110 * error];
    return [255, 225 * (1 - Math.min(1, Math.log2(error) / 5)), 0];
  });
}

/**
 * Boxes around clusters of failing pixels, {x, y, width, height, count, worst: {x, y, error}, nonfinite}: those with
 * pixels that are not finite first, then the largest. Pixels belong together if they lie in neighbouring cells of a grid.
 */
function failing_boxes(errors) {
  const { width, height, values } = errors;
  const cell = Math.max(2, Math.ceil(Math.max(width, height) / 96));
  const columns = Math.ceil(width / cell);
  const rows = Math.ceil(height / cell);
  const cells = Array.from({ length: columns * rows }, () => null);
  for (let i = 0; i < values.length; ++i) {
    if (!is_failing(values[i])) continue;
    const x = i % width;
    const y = (i - x) / width;
    const at = Math.floor(y / cell) * columns + Math.floor(x / cell);
    cells[at] = cells[at] || { left: x, right: x, top: y, bottom: y, count: 0, nonfinite: 0, worst: { x, y, error: -1 } };
    grow(cells[at], { left: x, right: x, top: y, bottom: y, count: 1, nonfinite: Number.isNaN(values[i]) ? 1 : 0, worst: { x, y, error: values[i] } });
  }
  const boxes = [];
  for (let start = 0; start < cells.length; ++start) {
    if (!cells[start]) continue;
    const box = cells[start];
    const waiting = [start];
    cells[start] = null;
    while (waiting.length) {
      const at = waiting.pop();
      const [cx, cy] = [at % columns, Math.floor(at / columns)];
      for (let y = Math.max(0, cy - 1); y <= Math.min(rows - 1, cy + 1); ++y)
        for (let x = Math.max(0, cx - 1); x <= Math.min(columns - 1, cx + 1); ++x) {
          const beside = y * columns + x;
          if (!cells[beside]) continue;
          grow(box, cells[beside]);
          cells[beside] = null;
          waiting.push(beside);
        }
    }
    boxes.push({ ...box, x: box.left, y: box.top, width: box.right - box.left + 1, height: box.bottom - box.top + 1 });
  }
  return boxes.sort((a, b) => b.nonfinite - a.nonfinite || b.count - a.count);
}

/** Adds a part to a cluster. */
function grow(box, part) {
  box.left = Math.min(box.left, part.left);
  box.right = Math.max(box.right, part.right);
  box.top = Math.min(box.top, part.top);
  box.bottom = Math.max(box.bottom, part.bottom);
  box.count += part.count;
  box.nonfinite += part.nonfinite;
  const is_worse = Number.isNaN(part.worst.error) ? !Number.isNaN(box.worst.error) : part.worst.error > box.worst.error;
  if (is_worse) box.worst = part.worst;
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
