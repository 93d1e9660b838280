// Pictures of single lights, and their sum.
#include "viewer/document/light_layers.hpp"

#include "support/address.hpp"

#include <vector>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

image::Image one_pixel(vec3 color) {
    image::Image film(1, 1, 4);
    film.pixels = {color.r, color.g, color.b, 1.0f};
    return film;
}

const Test mixed_layers("unit.viewer.layers.a_mix_is_the_sum_of_weighted_lights", [] {
    LightLayers layers(2);
    EXPECT_EQ(layers.samples(), 0);
    layers.add(0, one_pixel({3.0f, 3.0f, 3.0f}), 4);
    layers.add(1, one_pixel({6.0f, 5.0f, 4.0f}), 4);
    EXPECT_EQ(layers.samples(), 0) << "the picture without lights is missing";
    layers.add(2, one_pixel({1.0f, 1.0f, 1.0f}), 4);
    EXPECT_EQ(layers.samples(), 4);
    const std::vector<vec3> dark(2, vec3(0.0f)), both(2, vec3(1.0f));
    EXPECT_EQ(layers.mix(dark).pixels, (std::vector<float>{1.0f, 1.0f, 1.0f}));
    EXPECT_EQ(layers.mix(both).pixels, (std::vector<float>{8.0f, 7.0f, 6.0f}));
    const std::vector<vec3> colored{vec3(0.5f, 0.0f, 2.0f), vec3(0.0f)};
    EXPECT_EQ(layers.mix(colored).pixels, (std::vector<float>{2.0f, 1.0f, 5.0f}));
});

const Test refined_layers("unit.viewer.layers.samples_are_averaged_by_their_number", [] {
    LightLayers layers(0);
    layers.add(0, one_pixel({1.0f, 2.0f, 3.0f}), 4);
    layers.add(0, one_pixel({5.0f, 2.0f, 7.0f}), 12);
    EXPECT_EQ(layers.samples(), 16);
    EXPECT_EQ(layers.mix({}).pixels, (std::vector<float>{4.0f, 2.0f, 6.0f}));
});

} // namespace
