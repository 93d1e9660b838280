// solution row_by_row
vec3 RGB_of_XYZ(vec3 XYZ) {
    return vec3(3.2404542 * XYZ.x - 1.5371385 * XYZ.y - 0.4985314 * XYZ.z,
                -0.9692660 * XYZ.x + 1.8760108 * XYZ.y + 0.0415560 * XYZ.z,
                0.0556434 * XYZ.x - 0.2040259 * XYZ.y + 1.0572252 * XYZ.z);
}
vec3 XYZ_of_RGB(vec3 RGB) {
    return RGB.r * vec3(0.4124564, 0.2126729, 0.0193339) + RGB.g * vec3(0.3575761, 0.7151522, 0.1191920)
           + RGB.b * vec3(0.1804375, 0.0721750, 0.9503041);
}
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ / XYZ.y);
}
// solution by_the_inverse
const mat3 M = transpose(mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252));
vec3 RGB_of_XYZ(vec3 XYZ) { return M * XYZ; }
vec3 XYZ_of_RGB(vec3 RGB) { return inverse(M) * RGB; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(1.0, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) * 683.0 / luminous_flux(XYZ);
}
// mistake not_the_inverse
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return XYZ * to_RGB; }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB * to_RGB; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// mistake transposed
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return to_RGB * XYZ; }
vec3 XYZ_of_RGB(vec3 RGB) { return to_XYZ * RGB; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// mistake wrong_way
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return XYZ * to_XYZ; }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB * to_RGB; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// mistake clamped
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return max(XYZ * to_RGB, vec3(0.0)); }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB * to_XYZ; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// mistake encoded
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 encoded(vec3 RGB) {
    vec3 c = max(RGB, vec3(0.0));
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}
vec3 RGB_of_XYZ(vec3 XYZ) { return encoded(XYZ * to_RGB); }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB * to_XYZ; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// mistake over_Y
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return XYZ * to_RGB / XYZ.y; }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB * to_XYZ; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// mistake matrix_missing
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return XYZ; }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB; }
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// mistake lamp_not_over_Y
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return XYZ * to_RGB; }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB * to_XYZ; }
vec3 RGB_of_your_lamp() { return RGB_of_XYZ(XYZ_of_lamp(lamp_power, lamp_peak, lamp_width)); }
// mistake lamp_over_the_largest
const mat3 to_RGB = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252);
const mat3 to_XYZ = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041);
vec3 RGB_of_XYZ(vec3 XYZ) { return XYZ * to_RGB; }
vec3 XYZ_of_RGB(vec3 RGB) { return RGB * to_XYZ; }
vec3 RGB_of_your_lamp() {
    vec3 RGB = RGB_of_XYZ(XYZ_of_lamp(lamp_power, lamp_peak, lamp_width));
    return RGB / max(RGB.r, max(RGB.g, RGB.b));
}
