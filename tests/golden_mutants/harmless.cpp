#include "golden_mutants/change.hpp"
#include "golden_mutants/mutants.hpp"
#include "golden_mutants/noisy.hpp"
#include "golden_mutants/picture.hpp"

#include <cmath>

namespace sr::testing {
namespace {

using image::Image;

/// A value a few last places away, either way.
float nudged(float value, float relative, Random& random) {
    return value * (1.0f + relative * (2.0f * random.uniform() - 1.0f));
}

Image with_last_places_off(const Image& image) {
    Random random(1);
    return with_colors(image, [&](float value) {
        return std::nextafter(value, random.uniform() < 0.5f ? 0.0f : 2.0f * value);
    });
}

/// Another driver: the last bits everywhere, and a few pixels at edges that fall to the other side.
Image from_another_driver(const Image& image) {
    Random random(2);
    Image result = with_colors(image, [&](float value) { return nudged(value, 1e-5f, random); });
    for (const auto& [x, y] : {std::pair{25, 40}, {60, 51}, {31, 70}, {70, 30}, {12, 60}, {44, 80}})
        std::ranges::copy(image.at(x + 1, y), result.at(x, y).begin());
    return result;
}

/// Values as `half` stores them: 11 significant bits.
Image as_half(const Image& image) {
    return with_colors(image, [](float value) {
        if (value == 0.0f) return 0.0f;
        const float step = std::exp2(std::floor(std::log2(value)) - 10.0f);
        return std::round(value / step) * step;
    });
}

/// sRGB codes of 8 bits, of which each is off by one code or not at all.
Image codes(const Image& image, bool are_off) {
    Random random(3);
    return with_colors(image, [&](float value) {
        const float x = std::clamp(value / 4.0f, 0.0f, 1.0f);
        const float code =
            std::round(255.0f * (x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f));
        const float off = are_off ? std::floor(3.0f * random.uniform()) - 1.0f : 0.0f;
        return std::clamp(code + off, 0.0f, 255.0f) / 255.0f;
    });
}

Image with_stray_pixels(Image image, int step) {
    for (int y = step / 2; y < image.height; y += step)
        for (int x = step / 2; x < image.width; x += step)
            for (float& value : image.at(x, y).first(3)) value *= 1.5f;
    return image;
}

std::vector<Mutant> noise_at_its_floor(const Image& right) {
    const Image floor = noise_floor(right);
    std::vector<Mutant> list{
        {"noise_at_its_floor", noisy(right, floor, 11), right, true, {}, {}, {}},
        {"noise_in_both", noisy(right, floor, 12), noisy(right, floor, 13), true, {}, {}, {}}};
    list[0].options.noise = {floor};
    list[1].options.noise = {floor, floor};
    return list;
}

} // namespace

std::vector<Mutant> harmless() {
    const Image right = picture_of_sphere();
    const Image lamp_only = picture_of_sphere({.is_mostly_black = true});
    std::vector<Mutant> list{{"identical", right, right, true, {}, {}, {}},
                             {"last_place", with_last_places_off(right), right, true, {}, {}, {}},
                             {"other_driver", from_another_driver(right), right, true, {}, {}, {}},
                             {"stored_as_half", as_half(right), right, true, {}, {}, {}},
                             {"mostly_black_identical", lamp_only, lamp_only, true, {}, {}, {}},
                             {"exposure_0.3_percent", scaled(right, 1.003f), right, true, {}, {}, {}}};
    list.push_back({"scattered_1_percent", with_stray_pixels(right, 10), right, true, {}, {}, {}});
    const std::vector<std::string> one_percent{"rel=0.02@99%", "energy=0.02"};
    list.back().options.tolerances = compare::parse_tolerances(one_percent);
    list.push_back({"png_off_by_one_code", codes(right, true), codes(right, false), true, {}, {}, {}});
    list.back().options.encoding = compare::Encoding::display_referred;
    for (Mutant& mutant : noise_at_its_floor(right)) list.push_back(std::move(mutant));
    return list;
}

std::vector<Mutant> mutants() {
    std::vector<Mutant> all;
    for (auto* family : {harmless, wrong_values, wrong_places, wrong_lights, wrong_otherwise})
        for (Mutant& mutant : family()) all.push_back(std::move(mutant));
    return all;
}

} // namespace sr::testing
