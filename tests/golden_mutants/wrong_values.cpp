#include "golden_mutants/change.hpp"
#include "golden_mutants/mutants.hpp"
#include "golden_mutants/picture.hpp"

#include <cmath>
#include <numbers>

namespace sr::testing {
namespace {

using image::Image;

constexpr float pi_f = std::numbers::pi_v<float>;

float srgb(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f; }
float linear(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }
float clamped(float value) { return std::clamp(value, 0.0f, 1.0f); }

/// The factor inside a patch of 2 % of the frame only, as of one material.
Image scaled_in_patch(Image image, float factor) {
    for (int y = 60; y < 74; ++y)
        for (int x = 40; x < 54; ++x)
            for (float& value : image.at(x, y).first(3)) value *= factor;
    return image;
}

Image tinted(Image image) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            image.at(x, y)[0] *= 1.1f;
            image.at(x, y)[2] *= 0.9f;
        }
    return image;
}

std::vector<Mutant> wrong_factors(const Image& right) {
    const auto times = [&right](const char* name, float factor, const char* diagnosis) {
        return Mutant{name, scaled(right, factor), right, false, diagnosis, {}, {}};
    };
    return {times("pi_missing", pi_f, "pi_missing"),
            {"pi_missing_in_shading",
             picture_of_sphere({.divides_by_pi = false}),
             right,
             false,
             "pi_missing",
             {},
             {}},
            {"pi_missing_on_2_percent", scaled_in_patch(right, pi_f), right, false, "pi_missing", {}, {}},
            times("pi_twice", 1.0f / pi_f, "pi_twice"),
            times("four_pi", 4.0f * pi_f, "four_pi_missing"),
            times("factor_two", 2.0f, "factor_two"),
            times("factor_half", 0.5f, "factor_half"),
            {"factor_two_on_2_percent", scaled_in_patch(right, 2.0f), right, false, "factor_two", {}, {}},
            times("watts_for_lumens", 1.0f / 683.0f, "watts_for_lumens"),
            times("exposure_2_percent", 1.02f, "exposure"),
            times("exposure_5_percent", 0.95f, "exposure"),
            times("exposure_third_stop", std::exp2(1.0f / 3.0f), "exposure"),
            {"tint", tinted(right), right, false, "channel_gains", {}, {}},
            {"ambient",
             with_colors(right, [](float value) { return value + 0.05f; }),
             right,
             false,
             "ambient_added",
             {},
             {}}};
}

std::vector<Mutant> wrong_curves(const Image& right) {
    const auto curved = [&right](const char* name, auto curve, const char* diagnosis) {
        return Mutant{name, with_colors(right, curve), right, false, diagnosis, {}, {}};
    };
    std::vector<Mutant> list{
        curved("srgb_applied", srgb, "srgb_applied"),
        curved(
            "srgb_applied_clamped", [](float x) { return srgb(clamped(x)); }, "srgb_applied"),
        curved(
            "srgb_applied_twice", [](float x) { return srgb(srgb(clamped(x))); }, "srgb_applied_twice"),
        curved("srgb_missing", linear, "srgb_missing"),
        curved(
            "gamma_2.2_applied", [](float x) { return std::pow(x, 1.0f / 2.2f); }, "gamma_applied"),
        curved("clamped_to_1", clamped, "clamped")};
    const auto code = [](float x) { return std::round(255.0f * srgb(clamped(0.25f * x))) / 255.0f; };
    Image codes = with_colors(right, code);
    list.push_back({"png_srgb_twice", with_colors(codes, srgb), codes, false, "srgb_applied", {}, {}});
    list.back().options.encoding = compare::Encoding::display_referred;
    const auto half_code = [](float x) { return std::round(255.0f * srgb(clamped(0.125f * x))) / 255.0f; };
    list.push_back({"png_half", with_colors(right, half_code), codes, false, "factor_half", {}, {}});
    list.back().options.encoding = compare::Encoding::display_referred;
    return list;
}

} // namespace

std::vector<Mutant> wrong_values() {
    const Image right = picture_of_sphere();
    std::vector<Mutant> list = wrong_factors(right);
    for (Mutant& mutant : wrong_curves(right)) list.push_back(std::move(mutant));
    list.push_back({"channels_bgr", reordered(right, {2, 1, 0}), right, false, "channels_swapped", {}, {}});
    list.push_back(
        {"channels_rotated", reordered(right, {1, 2, 0}), right, false, "channels_swapped", {}, {}});
    return list;
}

} // namespace sr::testing
