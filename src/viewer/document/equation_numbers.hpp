#pragma once
// Numbers of the equation at a pixel, arranged as a product for each light.
#include "core/math.hpp"
#include "render/probe.hpp"

#include <optional>

namespace sr::viewer {

/// Part of a colour: the luminance of all colours, or one of them.
enum class ColorPart { luminance, red, green, blue };

inline float part_of(vec3 color, ColorPart part) {
    return part == ColorPart::luminance ? luminance(color) : color[static_cast<int>(part) - 1];
}

/// L_r = f_r · L · Ω · V · cosθ of one light: means over it, whose product is exact by the choice of L.
/// Without an extent, L Ω is one number, `face_on`.
struct EquationProduct {
    float L_r = 0.0f; // [cd/m²]
    float V = 0.0f;
    float cos_i = 0.0f;
    float solid_angle = 0.0f;      // Ω [sr]; 0: the light has no extent
    std::optional<float> f_r;      // [1/sr]; of a mirror its reflectance. Absent where nothing arrives
    std::optional<float> radiance; // L [cd/m²]; of a mirror, L with the part of it that V leaves
    std::optional<float> face_on;  // L Ω [lx]: E over V cosθ
    bool is_mirror = false; // L_r = ρ L: the delta leaves one direction, so that Ω and cosθ drop out
};

/// `reflectance`: of an ideal mirror; 0 for every other surface.
inline EquationProduct product_of(const render::LightTerms& terms, ColorPart part, float reflectance) {
    EquationProduct product;
    product.L_r = part_of(terms.L_r, part);
    product.V = part == ColorPart::luminance ? terms.V : part_of(terms.V_color, part);
    product.cos_i = terms.cos_i;
    product.solid_angle = terms.solid_angle;
    product.is_mirror = reflectance > 0.0f;
    if (product.is_mirror) {
        product.f_r = reflectance;
        product.radiance = product.L_r / reflectance;
        return product;
    }
    const float E = part_of(terms.E, part);
    if (!(E > 0.0f && product.V > 0.0f && product.cos_i > 0.0f)) return product;
    product.f_r = product.L_r / E;
    product.face_on = E / (product.V * product.cos_i);
    if (product.solid_angle > 0.0f) product.radiance = *product.face_on / product.solid_angle;
    return product;
}

} // namespace sr::viewer
