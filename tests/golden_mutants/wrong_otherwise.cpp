#include "golden_mutants/change.hpp"
#include "golden_mutants/mutants.hpp"
#include "golden_mutants/noisy.hpp"
#include "golden_mutants/picture.hpp"

#include <limits>
#include <numbers>

namespace sr::testing {
namespace {

using image::Image;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Image with_value(Image image, int x, int y, float value) {
    std::ranges::fill(image.at(x, y).first(3), value);
    return image;
}

Image filled(Image image, float r, float g, float b) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) std::ranges::copy(std::array{r, g, b}, image.at(x, y).begin());
    return image;
}

/// `factor` in a square of `edge` pixels.
Image with_wrong_block(Image image, float factor, int edge) {
    for (int y = 50; y < 50 + edge; ++y)
        for (int x = 60; x < 60 + edge; ++x)
            for (float& value : image.at(x, y).first(3)) value *= factor;
    return image;
}

std::vector<Mutant> holes(const Image& right) {
    const Image lamp_only = picture_of_sphere({.is_mostly_black = true});
    const Image hole_in_both = with_value(right, 50, 50, nan);
    std::vector<Mutant> list{
        {"all_nan", filled(right, nan, nan, nan), right, false, {}, {}, {}},
        {"one_nan", with_value(right, 50, 50, nan), right, false, {}, {}, {}},
        {"one_infinity",
         with_value(right, 50, 50, std::numeric_limits<float>::infinity()),
         right,
         false,
         {},
         {},
         {}},
        {"nan_in_both", hole_in_both, hole_in_both, false, {}, {}, {}},
        {"nan_in_both_allowed", hole_in_both, hole_in_both, true, {}, {}, {}},
        {"all_nan_allowed", filled(right, nan, nan, nan), right, false, {}, {}, {}},
        {"all_black", filled(right, 0.0f, 0.0f, 0.0f), right, false, "black", {}, {}},
        {"black_for_mostly_black", filled(lamp_only, 0.0f, 0.0f, 0.0f), lamp_only, false, "black", {}, {}},
        {"sentinel", filled(right, 1.0f, 0.0f, 1.0f), right, false, "uniform", {}, {}},
        {"firefly", with_value(right, 50, 50, 5000.0f), right, false, {}, {}, {}}};
    list[4].options.allow_nonfinite = list[5].options.allow_nonfinite = true;
    return list;
}

std::vector<Mutant> in_part(const Image& right) {
    const Image wrong = with_wrong_block(right, 1.5f, 9);
    std::vector<Mutant> list{{"clustered_0.9_percent", wrong, right, false, "exposure", {}, {}},
                             {"wrong_outside_region", wrong, right, true, {}, {}, {}},
                             {"wrong_inside_region", wrong, right, false, "exposure", {}, {}},
                             {"wrong_behind_mask", wrong, right, true, {}, {}, {}}};
    const std::vector<std::string> one_percent{"rel=0.02@99%", "energy=0.02"};
    list[0].options.tolerances = compare::parse_tolerances(one_percent);
    list[1].options.region = {0, 0, 60, 96};
    list[2].options.region = {40, 0, 56, 96};
    Image mask(right.width, right.height, 1);
    std::ranges::fill(mask.pixels, 1.0f);
    for (int y = 48; y < 60; ++y)
        for (int x = 58; x < 70; ++x) mask.at(x, y)[0] = 0.0f;
    list[3].options.mask = mask;
    return list;
}

std::vector<Mutant> noisy_and_wrong(const Image& right) {
    const Image floor = noise_floor(right);
    const Image without_spot = picture_of_sphere({.lights = {"key", "fill"}});
    std::vector<Mutant> list{
        {"noise_at_twice_its_floor", noisy(right, floor, 21, 2.0f), right, false, {}, {}, {}},
        {"noise_hides_1_percent", scaled(noisy(right, floor, 22), 1.01f), right, false, {}, {}, {}},
        {"noise_and_pi_missing",
         scaled(noisy(right, floor, 23), std::numbers::pi_v<float>),
         right,
         false,
         "pi_missing",
         {},
         {}},
        {"noise_and_30_percent_brighter",
         scaled(noisy(right, floor, 25), 1.3f),
         right,
         false,
         "exposure",
         {},
         {}},
        {"noise_and_spot_missing",
         noisy(without_spot, floor, 24),
         right,
         false,
         "light_missing",
         "spot",
         {}}};
    for (Mutant& mutant : list) mutant.options.noise = {floor};
    return list;
}

std::vector<Mutant> of_other_kinds(const Image& right) {
    Image transparent = right;
    for (int y = 0; y < right.height; ++y)
        for (int x = 0; x < right.width; ++x) transparent.at(x, y)[3] = 0.0f;
    Image grey(right.width, right.height, 1);
    for (std::size_t i = 0; i < grey.pixels.size(); ++i)
        grey.pixels[i] = right.pixels[i * static_cast<std::size_t>(right.channels) + 1];
    return {{"small_thing_missing", with_wrong_block(right, 0.3f, 5), right, false, {}, {}, {}},
            {"alpha_missing", transparent, right, false, "alpha_lost", {}, {}},
            {"grey", grey, right, false, {}, {}, {}},
            {"another_size", picture_of_sphere({.width = 95}), right, false, "resolution_scaled", {}, {}},
            {"redder_floor", picture_of_sphere({.reflectance_red = 1.1f}), right, false, {}, {}, {}}};
}

} // namespace

std::vector<Mutant> wrong_otherwise() {
    const Image right = picture_of_sphere();
    std::vector<Mutant> list;
    for (auto* family : {holes, in_part, noisy_and_wrong, of_other_kinds})
        for (Mutant& mutant : family(right)) list.push_back(std::move(mutant));
    return list;
}

} // namespace sr::testing
