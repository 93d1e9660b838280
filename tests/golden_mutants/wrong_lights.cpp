#include "golden_mutants/change.hpp"
#include "golden_mutants/mutants.hpp"
#include "golden_mutants/picture.hpp"

namespace sr::testing {
namespace {

using image::Image;

/// The picture with a light's layer added to it so many times.
Image plus_layer(Image image, std::size_t light, float times) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                image.at(x, y)[c] += times * image.at(x, y)[4 + 3 * light + c];
    return image;
}

/// R, G, B and A alone: a golden without layers.
Image without_layers(const Image& image) {
    Image result(image.width, image.height, 4);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            std::ranges::copy(image.at(x, y).first(4), result.at(x, y).begin());
    return result;
}

} // namespace

std::vector<Mutant> wrong_lights() {
    const Image right = picture_of_sphere();
    const Image without_spot = picture_of_sphere({.lights = {"key", "fill"}});
    return {{"key_missing",
             picture_of_sphere({.lights = {"fill", "spot"}}),
             right,
             false,
             "light_missing",
             "key",
             {}},
            {"fill_missing",
             picture_of_sphere({.lights = {"key", "spot"}}),
             right,
             false,
             "light_missing",
             "fill",
             {}},
            {"spot_missing_on_2_percent", without_spot, right, false, "light_missing", "spot", {}},
            {"spot_missing_without_layers",
             without_layers(without_spot),
             without_layers(right),
             false,
             {},
             {},
             {}},
            {"two_lights_missing",
             picture_of_sphere({.lights = {"fill"}}),
             right,
             false,
             "lights_missing",
             "key, spot",
             {}},
            {"spot_doubled", plus_layer(right, 2, 1.0f), right, false, "light_doubled", "spot", {}},
            {"fill_at_70_percent", plus_layer(right, 1, -0.3f), right, false, "light_scaled", "fill", {}},
            {"key_at_90_percent", plus_layer(right, 0, -0.1f), right, false, "light_scaled", "key", {}},
            {"key_shadow_missing",
             picture_of_sphere({.key_casts_shadow = false}),
             right,
             false,
             "shadow_missing",
             "key",
             {}},
            {"cosine_missing", picture_of_sphere({.has_cosine = false}), right, false, {}, {}, {}},
            {"no_light_at_all",
             picture_of_sphere({.lights = {}}),
             right,
             false,
             "lights_missing",
             "key, fill, spot",
             {}}};
}

} // namespace sr::testing
