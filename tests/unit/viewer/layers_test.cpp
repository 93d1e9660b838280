// Pictures of single lights, and their sum.
#include "viewer/document/light_layers.hpp"
#include "viewer/panels/mixer.hpp"

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

const Test groups("unit.viewer.layers.lights_that_differ_in_a_number_are_a_group", [] {
    std::vector<LightEntry> entries;
    for (const char* name : {"panel 1", "lamp", "panel 2", "panel 10", "key.001", "key.002", "7", "panel"}) {
        entries.emplace_back();
        entries.back().name = name;
    }
    const std::vector<MixerGroup> all = mixer_groups(entries);
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].name, "panel");
    EXPECT_EQ(all[0].entries, (std::vector<std::size_t>{0, 2, 3, 7}));
    EXPECT_EQ(all[1].entries, (std::vector<std::size_t>{1}));
    EXPECT_EQ(all[2].name, "key");
    EXPECT_EQ(all[2].entries, (std::vector<std::size_t>{4, 5}));
    EXPECT_EQ(all[3].entries, (std::vector<std::size_t>{6})) << "a number is a name";
});

} // namespace
