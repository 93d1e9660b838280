#include "golden_mutants/change.hpp"
#include "golden_mutants/recipes.hpp"
#include "golden_mutants/whole.hpp"

#include <limits>
#include <numbers>

namespace sr::testing {
namespace {

using image::Image;

constexpr float infinity = std::numeric_limits<float>::infinity();

Extent size_of(const Mutant& m) { return {m.reference.width, m.reference.height}; }

/// Another render, or of its reference too.
Recipe render_of(const char* name, const RenderBase& options, const char* diagnosis = "*") {
    return {Base::render, name, false, [options](Mutant& m) { m.test = render_base(size_of(m), options); },
            diagnosis};
}

template<typename Change>
Recipe wrong(Base base, const char* name, const char* diagnosis, Change change) {
    return {base, name, false, [change](Mutant& m) { m.test = change(m.test); }, diagnosis};
}

Recipe layered(const char* name, const std::function<void(Image&)>& change, const char* diagnosis = "*") {
    return {Base::render, name, false,
            [change](Mutant& m) {
                m.test = m.reference = layered_render_base(size_of(m));
                change(m.test);
            },
            diagnosis};
}

/// Without the channels from `first` up to `end`.
Image without(const Image& image, std::size_t first, std::size_t end) {
    Image result(image.width, image.height, image.channels - static_cast<int>(end - first));
    result.channel_names = image.channel_names;
    result.channel_names.erase(result.channel_names.begin() + static_cast<std::ptrdiff_t>(first),
                               result.channel_names.begin() + static_cast<std::ptrdiff_t>(end));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0, to = 0; c < static_cast<std::size_t>(image.channels); ++c)
                if (c < first || c >= end) result.at(x, y)[to++] = image.at(x, y)[c];
    return result;
}

template<typename Function>
void change_channels(Image& image, std::size_t first, std::size_t end, const Function& f) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = first; c < end; ++c) image.at(x, y)[c] = f(image.at(x, y)[c]);
}

std::vector<Recipe> wrong_scenes() {
    return {render_of("rougher_ball", {.roughness = 0.146f}),
            render_of("object_missing", {.has_object = false}),
            render_of("wire_black", {.wire = 0.0f}),
            render_of("wire_missing", {.has_wire = false}),
            render_of("wire_moved", {.wire_offset = 1}),
            render_of("wire_5_percent_brighter", {.wire = 0.84f}),
            render_of("shadow_missing", {.has_shadow = false}),
            render_of("gloss_missing", {.has_gloss = false}),
            render_of("lamp_off", {.lamp = 0.0f}),
            render_of("lamp_3_percent_darker", {.lamp = 38.8f}),
            render_of("ball_moved_by_1_pixel", {.ball_offset = 1.0f}),
            render_of("ball_2_percent_larger", {.ball_radius = 1.02f}),
            render_of("tile_3_percent_brighter", {.tile = 1.03f}),
            render_of("no_antialiasing", {.supersampling = 1})};
}

std::vector<Recipe> wrong_channels() {
    return {
        wrong(Base::render, "alpha_dropped", "alpha_lost", [](const Image& i) { return without(i, 3, 4); }),
        wrong(Base::render, "alpha_opaque", "alpha_lost",
              [](Image i) {
                  change_channels(i, 3, 4, [](float) { return 1.0f; });
                  return i;
              }),
        wrong(Base::render, "alpha_hole", "",
              [](Image i) {
                  for (int k = 0; k < 25; ++k) i.at(i.width / 2 + k % 5, i.height * 3 / 5 + k / 5)[3] = 0.0f;
                  return i;
              }),
        layered(
            "layer_dropped", [](Image& i) { i = without(i, 4, 7); }, ""),
        layered(
            "layer_5_times", [](Image& i) { change_channels(i, 7, 10, [](float v) { return 5.0f * v; }); },
            ""),
        layered(
            "layer_3_percent_off",
            [](Image& i) { change_channels(i, 4, 7, [](float v) { return 1.03f * v; }); }, ""),
        layered(
            "layer_black", [](Image& i) { change_channels(i, 4, 7, [](float) { return 0.0f; }); }, ""),
        layered(
            "layers_swapped",
            [](Image& i) {
                for (std::size_t p = 0; p < i.pixels.size(); p += 11)
                    std::swap_ranges(&i.pixels[p + 4], &i.pixels[p + 7], &i.pixels[p + 7]);
            },
            ""),
        layered(
            "depth_dropped", [](Image& i) { i = without(i, 10, 11); }, ""),
        layered(
            "depth_hole", [](Image& i) { i.at(i.width / 2, i.height * 4 / 5)[10] = 0.0f; }, ""),
        layered(
            "layer_with_nan", [](Image& i) { i.at(i.width / 2, i.height * 4 / 5)[5] = std::nanf(""); }, ""),
        layered(
            "key_missing",
            [](Image& i) {
                for (std::size_t p = 0; p < i.pixels.size(); p += 11)
                    for (std::size_t c = 0; c < 3; ++c) {
                        i.pixels[p + c] -= i.pixels[p + 4 + c];
                        i.pixels[p + 4 + c] = 0.0f;
                    }
            },
            "light_missing")};
}

std::vector<Recipe> wrong_numbers() {
    const auto factor = [](float k) { return [k](const Image& i) { return scaled(i, k); }; };
    std::vector<Recipe> list{
        wrong(Base::render, "pi_missing", "pi_missing", factor(std::numbers::pi_v<float>)),
        wrong(Base::render, "factor_3.12", "exposure", factor(3.12f)),
        wrong(Base::render, "factor_1.98", "exposure", factor(1.98f)),
        wrong(Base::render, "exposure_1_percent", "exposure", factor(1.011f)),
        wrong(Base::render, "clamped_to_0.3", "clamped",
              [](const Image& i) { return with_colors(i, [](float v) { return std::min(v, 0.3f); }); }),
        wrong(Base::render, "clamped_to_8", "clamped",
              [](const Image& i) { return with_colors(i, [](float v) { return std::min(v, 8.0f); }); }),
        wrong(Base::render, "banded", "banded", [](const Image& i) { return banded(i, 32.0f); }),
        {Base::render, "half_overflow", false,
         [](Mutant& m) {
             m.reference = render_base(size_of(m), {.lamp = 2e5f});
             m.test = with_colors(m.reference, [](float v) { return std::min(v, 65504.0f); });
         },
         "half_overflow"},
        {Base::render, "half_overflow_to_infinity", false,
         [](Mutant& m) {
             m.reference = render_base(size_of(m), {.lamp = 2e5f});
             m.test = with_colors(m.reference, [](float v) { return v > 65504.0f ? infinity : v; });
         },
         "half_overflow"},
        wrong(Base::render, "negative_pixel", "",
              [](Image i) {
                  i.at(i.width / 3, i.height * 3 / 4)[2] = -0.5f;
                  return i;
              }),
        wrong(Base::render, "noise_of_3_percent", "",
              [](const Image& i) {
                  Random random(41);
                  return with_colors(i, [&](float v) { return v * (1.0f + 0.03f * random.normal()); });
              }),
        wrong(Base::render, "grey", "*",
              [](Image i) {
                  for (std::size_t p = 0; p < i.pixels.size(); p += 4)
                      i.pixels[p] = i.pixels[p + 2] = i.pixels[p + 1];
                  return i;
              }),
        wrong(Base::render, "vignette", "", [](Image i) {
            for (int y = 0; y < i.height; ++y)
                for (int x = 0; x < i.width; ++x) {
                    const float u = static_cast<float>(x) / static_cast<float>(i.width) - 0.5f,
                                v = static_cast<float>(y) / static_cast<float>(i.height) - 0.5f;
                    for (float& value : i.at(x, y).first(3)) value *= 1.0f - 0.5f * (u * u + v * v);
                }
            return i;
        })};
    for (const float gamma : {1.1f, 1.4f, 1.8f, 2.0f, 2.4f})
        list.push_back({Base::render, "gamma_" + std::to_string(gamma).substr(0, 3), false,
                        [gamma](Mutant& m) { m.test = with_gamma(m.test, gamma); }, "gamma_applied"});
    list.push_back({Base::render, "gamma_1.3_missing", false,
                    [](Mutant& m) { m.test = with_gamma(m.test, 1.0f / 1.3f); }, "gamma_missing"});
    return list;
}

std::vector<Recipe> wrong_places_of(Base base) {
    const auto move = [](float dx, float dy) { return [=](const Image& i) { return moved(i, dx, dy); }; };
    return {wrong(base, "half_pixel_right", "shifted", move(0.5f, 0.0f)),
            wrong(base, "half_pixel_down", "shifted", move(0.0f, 0.5f)),
            wrong(base, "half_pixel_up_left", "shifted", move(-0.5f, -0.5f)),
            wrong(base, "one_pixel_right", "shifted", move(1.0f, 0.0f)),
            wrong(base, "upside_down", "flipped_y",
                  [](const Image& i) {
                      return rearranged(i, [&](int x, int y) { return std::pair(x, i.height - 1 - y); });
                  }),
            wrong(base, "half_resolution", "resolution_scaled", at_half_resolution),
            wrong(base, "half_size", "resolution_scaled", of_half_size)};
}

template<typename Function>
std::function<Image(const Image&)> curve(Function f) {
    return [f](const Image& i) {
        Image result = with_colors(i, f);
        round_to_codes(result);
        return result;
    };
}

} // namespace

std::vector<Recipe> wrong_renders() {
    std::vector<Recipe> list;
    for (auto* family : {wrong_scenes, wrong_channels, wrong_numbers})
        for (Recipe& recipe : family()) list.push_back(std::move(recipe));
    for (Recipe& recipe : wrong_places_of(Base::render)) list.push_back(std::move(recipe));
    return list;
}

std::vector<Recipe> wrong_photos() {
    const Base base = Base::photo;
    std::vector<Recipe> list = wrong_places_of(base);
    const auto add = [&](const char* name, const char* diagnosis,
                         const std::function<Image(const Image&)>& change) {
        list.push_back(wrong(base, name, diagnosis, change));
    };
    add("4_codes_brighter", "*", curve([](float v) { return v + 4.0f / 255.0f; }));
    add("contrast_3_percent", "*", curve([](float v) { return 0.4f + 1.03f * (v - 0.4f); }));
    add("gamma_1.2", "*", curve([](float v) { return std::pow(v, 1.0f / 1.2f); }));
    add("posterised", "banded", curve([](float v) { return std::round(v * 15.0f) / 15.0f; }));
    add("clipped_at_200", "clamped", curve([](float v) { return std::min(v, 200.0f / 255.0f); }));
    add("bgr", "channels_swapped", [](const Image& i) { return reordered(i, {2, 1, 0}); });
    add("grain_of_4_codes", "", [](const Image& i) {
        Random random(42);
        return curve([&](float v) { return v + 4.0f / 255.0f * random.normal(); })(i);
    });
    add("scratch", "*", [](Image i) {
        for (int k = 0; k < 40; ++k) std::ranges::fill(i.at(i.width / 3 + k / 4, i.height / 3 + k), 0.95f);
        return i;
    });
    add("red_eye", "*", [](Image i) {
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x)
                if (x * x + y * y <= 5)
                    std::ranges::copy(std::array{0.9f, 0.1f, 0.1f},
                                      i.at(i.width / 2 + x, i.height / 2 + y).begin());
        return i;
    });
    add("patch_3_codes_darker", "*", [](Image i) {
        for (int k = 0; k < 81; ++k)
            for (float& v : i.at(i.width / 2 + k % 9, i.height / 2 + k / 9))
                v = std::max(v - 3.0f / 255.0f, 0.0f);
        return i;
    });
    add("cropped_and_enlarged", "*", [](const Image& i) {
        return rearranged(i, [&](int x, int y) {
            return std::pair(2 + x * (i.width - 4) / i.width, 2 + y * (i.height - 4) / i.height);
        });
    });
    list.push_back({base, "16_bits_0.7_percent_darker", false, [](Mutant& m) {
                        m.test = scaled(m.test, 0.993f);
                        m.options.bits = 16;
                    }});
    return list;
}

std::vector<Recipe> wrong_interfaces() {
    const Base base = Base::interface;
    std::vector<Recipe> list;
    const auto add = [&](const char* name, const InterfaceBase& options) {
        list.push_back(
            {base, name, false, [options](Mutant& m) { m.test = interface_base(size_of(m), options); }});
    };
    add("save_sane", {.label = "Sane"});
    add("label_missing", {.label = ""});
    add("letter_missing", {.label = "Sav"});
    add("letters_exchanged", {.label = "Svae"});
    add("label_moved_by_1_pixel", {.label_offset = 1});
    add("digit_3_8", {.amount = "1,880.00"});
    add("digit_8_6", {.amount = "1,360.00"});
    add("digit_1_7", {.amount = "7,380.00"});
    add("comma_period", {.amount = "1.380.00"});
    add("period_missing", {.amount = "1,380 00"});
    add("colon_period", {.title = "Setting:"});
    add("rule_missing", {.has_rule = false});
    add("rule_moved_by_1_pixel", {.rule_offset = 1});
    add("icon_missing", {.has_icon = false});
    add("badge_missing", {.has_badge = false});
    add("focus_ring_missing", {.has_focus_ring = false});
    add("caret", {.has_caret = true});
    add("button_grown_by_1_pixel", {.button_growth = 1});
    add("button_3_codes", {.button = 0.86f - 3.0f / 255.0f});
    add("no_antialiasing", {.has_antialiasing = false});
    add("text_larger", {.text_size = 2.1f});
    return list;
}

} // namespace sr::testing
