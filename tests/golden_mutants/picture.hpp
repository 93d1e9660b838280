#pragma once
// A small picture with closed-form radiance, made without GL, and the ways to make it wrong.
#include "image/image.hpp"

#include <string>
#include <vector>

namespace sr::testing {

/// A sphere on a checkered floor before black, lit by three point lights, with a lamp in sight; what a
/// mutated renderer does differently.
struct PictureOptions {
    int width = 96;
    int height = 96;
    float sphere_x = -0.25f; // [m]
    bool has_sphere = true;
    float zoom = 1.0f;
    float reflectance_red = 1.0f; // times the floor's own
    float offset_x = 0.0f;        // [pixels] of the sampled place
    bool divides_by_pi = true;
    bool has_cosine = true;
    bool key_casts_shadow = true;
    std::vector<std::string> lights{"key", "fill", "spot"}; // the spot reaches 2 % of the frame
    bool is_mostly_black = false;                           // only the lamp
};

/// R, G, B, A, and one layer for each light: "key.R", "key.G", … Without lights it holds the lamp alone.
image::Image picture_of_sphere(const PictureOptions& options = {});

} // namespace sr::testing
