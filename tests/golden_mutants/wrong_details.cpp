#include "golden_mutants/change.hpp"
#include "golden_mutants/noisy.hpp"
#include "golden_mutants/recipes.hpp"

#include <array>

namespace sr::testing {
namespace {

using image::Image;

using Damage = std::function<void(Mutant&)>;

Extent extent_of(const Mutant& m) { return {m.reference.width, m.reference.height}; }

Recipe detail(Base base, const char* name, const Damage& change, const char* diagnosis = "*") {
    return {base, name, false, change, diagnosis};
}

void copy_pixel(Image& image, int x, int y, int from_x, int from_y) {
    std::ranges::copy(image.at(from_x, from_y), image.at(x, y).begin());
}

/// A pixel in every `step` of a row takes the value above it: a dotted line, a serrated edge.
Damage dots_in_row(float row, int fixed_row, int step) {
    return [=](Mutant& m) {
        const int y = fixed_row > 0 ? fixed_row : static_cast<int>(row * static_cast<float>(m.test.height));
        for (int x = 12; x < m.test.width - 12; x += step) copy_pixel(m.test, x, y, x, y - 2);
    };
}

Damage dots_in_column(int column, int from, int to, int step, int side) {
    return [=](Mutant& m) {
        for (int y = from; y < to; y += step) copy_pixel(m.test, column, y, column + side, y);
    };
}

/// A column of the paper's colour, which cuts what it crosses.
Damage column_of_paper(int column) {
    return [=](Mutant& m) {
        for (int y = 40; y < m.test.height; ++y) std::ranges::fill(m.test.at(column, y), 247.0f / 255.0f);
    };
}

Damage in_block(float x, float y, int edge, const std::function<void(std::span<float>, int, int)>& f) {
    return [=](Mutant& m) {
        const int left = static_cast<int>(x * static_cast<float>(m.test.width)),
                  top = static_cast<int>(y * static_cast<float>(m.test.height));
        for (int v = 0; v < edge; ++v)
            for (int u = 0; u < edge; ++u) f(m.test.at(left + u, top + v).first(3), u, v);
    };
}

void dither(std::span<float> pixel, int u, int v) {
    for (float& value : pixel) value += ((u + v) % 2 == 0 ? 1.0f : -1.0f) * 0.03f * std::max(value, 0.4f);
}

/// The mutant with layers, whose channels 4 to 9 are lights and 10 is depth.
Damage with_layers(const std::function<void(Mutant&)>& change) {
    return [=](Mutant& m) {
        m.test = m.reference = layered_render_base(extent_of(m));
        change(m);
    };
}

/// The place in a row where a channel is largest, with `edge` pixels to its right.
int brightest_in_row(const Image& image, int row, std::size_t channel, int edge) {
    int best = 0;
    for (int x = 0; x + edge < image.width; ++x)
        if (image.at(x, row)[channel] > image.at(best, row)[channel]) best = x;
    return best;
}

Damage in_channel(std::size_t channel, int edge, float factor) {
    return with_layers([=](Mutant& m) {
        const int top = m.test.height * 4 / 5, left = brightest_in_row(m.test, top, channel, edge);
        for (int k = 0; k < edge * edge; ++k) m.test.at(left + k % edge, top + k / edge)[channel] *= factor;
    });
}

/// Depth in metres beside a unit normal, in one layer.
Damage geometry(float depth_factor, float normal_shift) {
    return [=](Mutant& m) {
        Image image(m.reference.width, m.reference.height, 7);
        image.channel_names = {"R", "G", "B", "A", "geometry.Z", "geometry.X", "geometry.Y"};
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                std::ranges::copy(m.reference.at(x, y), image.at(x, y).begin());
                image.at(x, y)[4] = 5000.0f + static_cast<float>(y);
                image.at(x, y)[5] = 0.3f + 0.001f * static_cast<float>(x);
                image.at(x, y)[6] = 0.5f;
            }
        m.test = m.reference = image;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                m.test.at(x, y)[4] *= depth_factor;
                m.test.at(x, y)[5] += normal_shift;
            }
    };
}

/// With noise known of the colours alone.
Damage with_noise(const std::function<void(Mutant&)>& change) {
    return [=](Mutant& m) {
        const Image floor = noise_floor(m.reference);
        m.options.noise = {floor};
        m.test = noisy(m.reference, floor, 71);
        change(m);
    };
}

/// Only one colour, and another picture of it.
Damage constant(float test, float line) {
    return [=](Mutant& m) {
        m.reference = m.test = Image(m.reference.width, m.reference.height, 3);
        std::ranges::fill(m.reference.pixels, 0.5f);
        std::ranges::fill(m.test.pixels, test);
        for (int x = 20; x < m.test.width - 20; ++x) std::ranges::fill(m.reference.at(x, 70), line);
    };
}

std::vector<Recipe> wrong_interface_details() {
    const Base base = Base::interface;
    std::vector<Recipe> list;
    const std::array<const char*, 6> dotted{"rule_dotted_2", "rule_dotted_3", "rule_dotted_4",
                                            "rule_dotted_5", "rule_dotted_8", "rule_dotted_16"};
    const std::array<const char*, 3> serrated{"button_serrated_5", "button_serrated_9", "button_serrated_15"};
    const std::array<int, 6> steps{2, 3, 4, 5, 8, 16};
    for (std::size_t k = 0; k < steps.size(); ++k)
        list.push_back(detail(base, dotted[k], dots_in_row(0.0f, 70, steps[k])));
    const std::array<int, 3> edge_steps{5, 9, 15};
    for (std::size_t k = 0; k < edge_steps.size(); ++k)
        list.push_back(detail(base, serrated[k], dots_in_row(0.0f, 84, edge_steps[k])));
    list.push_back(detail(base, "ring_dotted", dots_in_column(9, 82, 116, 5, -1)));
    list.push_back(detail(base, "button_left_serrated", dots_in_column(12, 86, 112, 5, -1)));
    const std::array<const char*, 5> columns{"column_of_paper_20", "column_of_paper_41", "column_of_paper_62",
                                             "column_of_paper_75", "column_of_paper_120"};
    const std::array<int, 5> at{20, 41, 62, 75, 120};
    for (std::size_t k = 0; k < at.size(); ++k)
        list.push_back(detail(base, columns[k], column_of_paper(at[k])));
    list.push_back(detail(base, "row_of_paper", [](Mutant& m) {
        for (int x = 0; x < m.test.width; ++x) std::ranges::fill(m.test.at(x, 133), 247.0f / 255.0f);
    }));
    list.push_back(detail(base, "button_dithered", in_block(0.1f, 0.55f, 12, dither)));
    list.push_back(detail(base, "rule_alone_missing", constant(0.5f, 0.1f), ""));
    list.push_back(detail(base, "constant_5_percent", constant(0.525f, 0.5f), ""));
    return list;
}

std::vector<Recipe> wrong_photo_details() {
    const Base base = Base::photo;
    return {detail(base, "line_of_dots", dots_in_row(0.6f, 0, 4)),
            detail(base, "dithered", in_block(0.4f, 0.4f, 12, dither)),
            detail(base, "one_code_darker_and_a_hole",
                   [](Mutant& m) {
                       for (float& v : m.test.pixels) v = std::max(v - 1.0f / 255.0f, 0.0f);
                       in_block(0.5f, 0.5f, 7, [](auto p, int, int) { std::ranges::fill(p, 0.0f); })(m);
                   }),
            detail(base, "hole_beside_a_mask", [](Mutant& m) {
                Image mask(m.reference.width, m.reference.height, 1);
                std::ranges::fill(mask.pixels, 1.0f);
                for (int x = 0; x < mask.width; ++x)
                    for (int y = 50; y < 53; ++y) mask.at(x, y)[0] = 0.0f;
                for (int x = 60; x < 70; ++x)
                    for (int y = 48; y < 53; ++y) {
                        std::ranges::fill(m.reference.at(x, y), y < 50 ? 0.8f : 0.2f);
                        std::ranges::copy(m.reference.at(x, y), m.test.at(x, y).begin());
                    }
                std::ranges::fill(m.test.at(64, 49), 0.2f); // explained by masked pixels alone
                m.options.mask = mask;
            })};
}

std::vector<Recipe> wrong_render_details() {
    const Base base = Base::render;
    const auto all = [](std::size_t first, std::size_t end, float factor) {
        return with_layers([=](Mutant& m) {
            for (std::size_t p = 0; p < m.test.pixels.size(); p += 11)
                for (std::size_t c = first; c < end; ++c) m.test.pixels[p + c] *= factor;
        });
    };
    const auto share = [](const Damage& change) {
        return [=](Mutant& m) {
            change(m);
            const std::vector<std::string> limits{"rel=0.02@99%", "energy=0.005"};
            m.options.tolerances = compare::parse_tolerances(limits);
        };
    };
    const auto five_times_the_key = [](Mutant& m) {
        for (std::size_t p = 0; p < m.test.pixels.size(); p += 11) m.test.pixels[p + 4] *= 5.0f;
    };
    return {detail(base, "horizon_dotted", dots_in_row(0.45f, 0, 6)),
            detail(base, "floor_dithered", in_block(0.5f, 0.8f, 12, dither)),
            detail(base, "layer_pixel_black", in_channel(5, 1, 0.0f), ""),
            detail(base, "layer_square_3_percent", in_channel(5, 6, 1.03f), ""),
            detail(base, "layer_square_of_a_share", share(in_channel(5, 12, 1.5f)), ""),
            detail(base, "layer_0.8_percent", all(4, 7, 1.008f), ""),
            detail(base, "layer_0.8_percent_darker", all(7, 10, 0.992f), ""),
            detail(base, "depth_2_percent", all(10, 11, 1.02f), ""),
            detail(base, "depth_pixel", in_channel(10, 1, 1.2f), ""),
            detail(base, "normal_beside_depth", geometry(1.0f, 0.02f), ""),
            detail(base, "depth_beside_normal", geometry(1.02f, 0.0f), ""),
            detail(base, "noise_and_alpha_hole", with_noise([](Mutant& m) {
                       for (int k = 0; k < 9; ++k)
                           m.test.at(m.test.width / 2 + k % 3, m.test.height * 3 / 5 + k / 3)[3] = 0.0f;
                   })),
            detail(base, "noise_and_alpha_opaque", with_noise([](Mutant& m) {
                       for (std::size_t p = 3; p < m.test.pixels.size(); p += 4) m.test.pixels[p] = 1.0f;
                   })),
            detail(base, "noise_and_layer_5_times", with_layers(with_noise(five_times_the_key))),
            detail(base, "noise_and_layer_pixel", with_layers(with_noise([](Mutant& m) {
                       const int row = m.test.height * 4 / 5;
                       m.test.at(brightest_in_row(m.test, row, 5, 1), row)[5] *= 1.5f;
                   }))),
            detail(
                base, "0.3_percent_and_a_hole",
                [](Mutant& m) {
                    m.test = scaled(m.test, 1.003f);
                    in_block(0.5f, 0.8f, 3, [](auto p, int, int) { std::ranges::fill(p, 0.0f); })(m);
                },
                ""),
            detail(
                base, "last_bits_and_alpha_opaque",
                [](Mutant& m) {
                    m.test = scaled(m.test, 1.00001f);
                    for (std::size_t p = 3; p < m.test.pixels.size(); p += 4) m.test.pixels[p] = 1.0f;
                },
                "alpha_lost"),
            detail(base, "0.3_percent_and_layer_5_times", with_layers([=](Mutant& m) {
                       m.test = scaled(m.test, 1.003f);
                       five_times_the_key(m);
                   }),
                   "")};
}

} // namespace

std::vector<Recipe> wrong_details() {
    std::vector<Recipe> list;
    for (auto* family : {wrong_interface_details, wrong_photo_details, wrong_render_details})
        for (Recipe& recipe : family()) list.push_back(std::move(recipe));
    return list;
}

} // namespace sr::testing
