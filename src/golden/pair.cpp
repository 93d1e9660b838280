#include "golden/pair.hpp"

#include "core/error.hpp"
#include "golden/layer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::golden {
namespace {

using image::Image;

Layer layer_of_reference(const Image& reference, const std::string& layer) {
    if (const auto found = layer_of(reference, layer)) return *found;
    throw Error(fmt::format("the reference has no layer '{}'", layer),
                "choose one of its layers, or leave the layer out to compare the pictures");
}

void exclude_outside(Pair& pair, const Region& region) {
    const Image& reference = pair.reference;
    const bool fits = region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0
                      && region.width <= reference.width - region.x
                      && region.height <= reference.height - region.y;
    if (!fits)
        throw Error(fmt::format("the region {},{} {}x{} is not inside {}x{} pixels", region.x, region.y,
                                region.width, region.height, reference.width, reference.height),
                    "choose a region inside the reference");
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x)
            if (x < region.x || y < region.y || x >= region.x + region.width || y >= region.y + region.height)
                pair.pixels[static_cast<std::size_t>(y) * reference.width + x] = Pixel::excluded;
}

void exclude_masked(Pair& pair, const Image& mask) {
    if (mask.width != pair.reference.width || mask.height != pair.reference.height)
        throw Error(fmt::format("the mask is {}x{}, the reference {}x{}", mask.width, mask.height,
                                pair.reference.width, pair.reference.height),
                    "make a mask of the reference's size");
    for (std::size_t i = 0; i < pair.pixels.size(); ++i)
        if (!(mask.pixels[i * static_cast<std::size_t>(mask.channels)] > 0.5f))
            pair.pixels[i] = Pixel::excluded;
}

bool is_finite(std::span<const float> values) {
    return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

void set_aside_nonfinite(Pair& pair) {
    for (std::size_t i = 0; i < pair.pixels.size(); ++i) {
        if (pair.pixels[i] != Pixel::compared) continue;
        const bool test_is_finite = is_finite(pair.test_at(i)),
                   reference_is_finite = is_finite(pair.reference_at(i));
        pair.nonfinite_test += !test_is_finite;
        pair.nonfinite_reference += !reference_is_finite;
        if (!test_is_finite || !reference_is_finite) pair.pixels[i] = Pixel::nonfinite;
    }
}

/// Makes both images equal and finite where they are not compared, so that no filter's neighbourhood carries
/// a difference from there.
void level_the_rest(Pair& pair) {
    const auto channels = static_cast<std::size_t>(pair.reference.channels);
    for (std::size_t i = 0; i < pair.pixels.size(); ++i) {
        if (pair.pixels[i] == Pixel::compared) {
            pair.compared.push_back(i);
            continue;
        }
        for (std::size_t c = i * channels; c < (i + 1) * channels; ++c) {
            if (!std::isfinite(pair.reference.pixels[c])) pair.reference.pixels[c] = 0.0f;
            pair.test.pixels[c] = pair.reference.pixels[c];
        }
    }
}

} // namespace

std::string obstacle(const Image& test, const Image& reference, const std::string& layer) {
    const Layer wanted = layer_of_reference(reference, layer);
    if (test.width != reference.width || test.height != reference.height)
        return fmt::format("the test is {} x {} pixels, the reference {} x {}", test.width, test.height,
                           reference.width, reference.height);
    const auto found = layer_of(test, layer);
    if (!found) return fmt::format("the test has no layer '{}'", layer);
    const bool is_grey_beside_rgb = found->colors.size() == 1 || wanted.colors.size() == 1;
    if (found->colors.size() != wanted.colors.size() && !is_grey_beside_rgb)
        return fmt::format("the test has {} colour channels, the reference {}", found->colors.size(),
                           wanted.colors.size());
    return {};
}

Pair paired(const Image& test, const Image& reference, const CompareOptions& options) {
    auto test_layer = layer_of(test, options.layer);
    auto reference_layer = layer_of_reference(reference, options.layer);
    require(test_layer.has_value(), "images with an obstacle are not paired");
    // Grey is a colour whose channels are equal.
    for (auto* colors : {&test_layer->colors, &reference_layer.colors})
        if (colors->size() == 1 && test_layer->colors.size() != reference_layer.colors.size())
            colors->assign(3, colors->front());
    Pair pair;
    pair.colors = static_cast<int>(reference_layer.colors.size());
    if (test_layer->alpha && reference_layer.alpha) {
        test_layer->colors.push_back(*test_layer->alpha);
        reference_layer.colors.push_back(*reference_layer.alpha);
    }
    pair.test = extracted(test, test_layer->colors);
    pair.reference = extracted(reference, reference_layer.colors);
    pair.pixels.assign(static_cast<std::size_t>(reference.width) * reference.height, Pixel::compared);
    if (options.region) exclude_outside(pair, *options.region);
    if (options.mask) exclude_masked(pair, *options.mask);
    if (std::ranges::all_of(pair.pixels, [](Pixel pixel) { return pixel == Pixel::excluded; }))
        throw Error("the region and the mask leave no pixel to compare",
                    "choose a larger region or another mask");
    set_aside_nonfinite(pair);
    level_the_rest(pair);
    return pair;
}

} // namespace sr::golden
