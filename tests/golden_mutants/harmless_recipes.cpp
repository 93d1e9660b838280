#include "golden_mutants/change.hpp"
#include "golden_mutants/flips.hpp"
#include "golden_mutants/recipes.hpp"
#include "golden_mutants/whole.hpp"

#include <array>
#include <cmath>

namespace sr::testing {
namespace {

using image::Image;

Recipe harmless_one(Base base, const char* name, const std::function<void(Mutant&)>& change) {
    return {base, name, true, change, ""};
}

void add_layers(Mutant& m) {
    m.test = m.reference = layered_render_base({m.reference.width, m.reference.height});
}

std::vector<Recipe> harmless_renders() {
    const Base base = Base::render;
    const auto nudge = [](Mutant& m) {
        Random random(51);
        m.test = with_colors(m.test, [&](float v) { return v * (1.0f + 1e-5f * (random.uniform() - 0.5f)); });
    };
    return {
        harmless_one(base, "identical", [](Mutant&) {}),
        harmless_one(base, "last_bits", nudge),
        harmless_one(base, "stored_as_half",
                     [](Mutant& m) {
                         m.test = with_colors(m.test, [](float v) {
                             if (v == 0.0f) return v;
                             const float step = std::exp2(std::floor(std::log2(std::abs(v))) - 10.0f);
                             return std::round(v / step) * step;
                         });
                     }),
        harmless_one(base, "3_edge_pixels", [](Mutant& m) { flip_edges(m.test, 3, 52); }),
        harmless_one(base, "12_edge_pixels", [](Mutant& m) { flip_edges(m.test, 12, 53); }),
        harmless_one(base, "other_driver",
                     [nudge](Mutant& m) {
                         nudge(m);
                         flip_edges(m.test, 24, 54);
                     }),
        harmless_one(base, "a_sample_of_8_edge_pixels", [](Mutant& m) { flip_edges(m.test, 8, 56, 0.25f); }),
        harmless_one(base, "zeros_with_a_sign",
                     [](Mutant& m) {
                         for (float& v : m.test.pixels)
                             if (v == 0.0f) v = -0.0f;
                     }),
        harmless_one(base, "depth_stored_as_half",
                     [](Mutant& m) {
                         add_layers(m);
                         for (std::size_t p = 10; p < m.test.pixels.size(); p += 11)
                             m.test.pixels[p] = std::round(m.test.pixels[p] * 1024.0f) / 1024.0f;
                     }),
        harmless_one(base, "without_names_of_channels", [](Mutant& m) { m.test.channel_names.clear(); }),
        harmless_one(base, "0.3_percent_brighter", [](Mutant& m) { m.test = scaled(m.test, 1.003f); }),
        harmless_one(base, "layers_identical", add_layers),
        harmless_one(base, "layers_of_other_driver",
                     [nudge](Mutant& m) {
                         add_layers(m);
                         nudge(m);
                         flip_edges(m.test, 12, 55);
                     }),
        harmless_one(base, "layers_only_in_the_test",
                     [](Mutant& m) {
                         m.test = layered_render_base({m.reference.width, m.reference.height});
                     }),
        harmless_one(base, "channels_in_another_order",
                     [](Mutant& m) {
                         m.test = reordered(m.test, {2, 1, 0});
                         m.test.channel_names = {"B", "G", "R", "A"};
                     }),
        harmless_one(base, "alpha_only_in_the_test", [](Mutant& m) {
            Image rgb(m.reference.width, m.reference.height, 3);
            for (int y = 0; y < rgb.height; ++y)
                for (int x = 0; x < rgb.width; ++x)
                    std::ranges::copy(m.reference.at(x, y).first(3), rgb.at(x, y).begin());
            m.reference = rgb;
        })};
}

void off_by(Image& image, int codes, std::uint32_t seed) {
    Random random(seed);
    const float span = static_cast<float>(2 * codes + 1);
    for (float& v : image.pixels)
        v += (std::floor(span * random.uniform()) - static_cast<float>(codes)) / 255.0f;
    round_to_codes(image);
}

std::vector<Recipe> harmless_codes(Base base) {
    return {harmless_one(base, "identical", [](Mutant&) {}),
            harmless_one(base, "1_code_off", [](Mutant& m) { off_by(m.test, 1, 61); }),
            harmless_one(base, "2_codes_off", [](Mutant& m) { off_by(m.test, 2, 62); }),
            harmless_one(base, "3_edge_pixels", [](Mutant& m) { flip_edges(m.test, 3, 63); }),
            harmless_one(base, "12_edge_pixels", [](Mutant& m) { flip_edges(m.test, 12, 64); }),
            harmless_one(base, "1_code_off_and_6_edge_pixels",
                         [](Mutant& m) {
                             off_by(m.test, 1, 66);
                             flip_edges(m.test, 6, 67);
                         }),
            harmless_one(base, "grey_as_rgb",
                         [](Mutant& m) {
                             Image grey(m.reference.width, m.reference.height, 1);
                             grey.channel_names = {"Y"};
                             for (std::size_t i = 0; i < grey.pixels.size(); ++i)
                                 grey.pixels[i] = m.reference.pixels[3 * i + 1];
                             for (std::size_t i = 0; i < m.test.pixels.size(); ++i)
                                 m.test.pixels[i] = grey.pixels[i / 3];
                             m.reference = grey;
                         }),
            harmless_one(base, "16_bits_rounded", [](Mutant& m) {
                Random random(65);
                for (float& v : m.test.pixels) v += 5e-4f * (random.uniform() - 0.5f);
                m.options.bits = 16;
            })};
}

} // namespace

std::vector<Recipe> harmless_recipes() {
    std::vector<Recipe> list = harmless_renders();
    for (const Base base : {Base::photo, Base::interface})
        for (Recipe& recipe : harmless_codes(base)) list.push_back(std::move(recipe));
    return list;
}

} // namespace sr::testing
