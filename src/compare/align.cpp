#include "compare/align.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace sr::compare {
namespace {

using image::Image;

std::vector<std::string> names_of(const Image& image) {
    if (static_cast<int>(image.channel_names.size()) == image.channels) return image.channel_names;
    if (image.channels <= 2)
        return image.channels == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"Y", "A"};
    std::vector<std::string> names{"R", "G", "B", "A"};
    names.resize(static_cast<std::size_t>(image.channels)); // more than four: nameless
    return names;
}

bool equal_but_for_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::optional<int> index_of(const std::vector<std::string>& names, const std::string& name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (equal_but_for_case(names[i], name)) return static_cast<int>(i);
    return std::nullopt;
}

bool belongs_to(const std::string& channel, std::string_view layer) {
    const auto dot = channel.rfind('.');
    return dot == std::string::npos ? layer.empty() : std::string_view(channel).substr(0, dot) == layer;
}

} // namespace

std::optional<ImageLayer> layer_of(const Image& image, std::string_view name) {
    const auto names = names_of(image);
    const std::string prefix = name.empty() ? std::string() : std::string(name) + ".";
    ImageLayer layer;
    layer.alpha = index_of(names, prefix + "A");
    const std::array rgb{index_of(names, prefix + "R"), index_of(names, prefix + "G"),
                         index_of(names, prefix + "B")};
    if (rgb[0] && rgb[1] && rgb[2]) {
        layer.colors = {*rgb[0], *rgb[1], *rgb[2]};
    } else if (const auto grey = index_of(names, prefix + "Y")) {
        layer.colors = {*grey};
    } else {
        for (std::size_t i = 0; i < names.size() && layer.colors.size() < 3; ++i)
            if (static_cast<int>(i) != layer.alpha && belongs_to(names[i], name))
                layer.colors.push_back(static_cast<int>(i));
        if (layer.colors.size() == 2) layer.colors.pop_back(); // not a colour: grey and something else
    }
    if (layer.colors.empty()) return std::nullopt;
    return layer;
}

std::vector<std::string> layer_names(const Image& image) {
    std::vector<std::string> layers;
    const auto names = names_of(image);
    for (const std::string& name : names) {
        if (!name.ends_with(".R")) continue;
        const std::string layer = name.substr(0, name.size() - 2);
        if (index_of(names, layer + ".G") && index_of(names, layer + ".B")) layers.push_back(layer);
    }
    return layers;
}

Image extract(const Image& image, const std::vector<int>& channels) {
    Image result(image.width, image.height, static_cast<int>(channels.size()));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto from = image.at(x, y);
            const auto to = result.at(x, y);
            for (std::size_t c = 0; c < channels.size(); ++c)
                to[c] = from[static_cast<std::size_t>(channels[c])];
        }
    return result;
}

std::array<std::size_t, 3> color_channels(const image::Image& image) {
    std::array<std::size_t, 3> channels{0, 1, 2};
    if (image.channels < 3) channels = {0, 0, 0};
    constexpr std::array names{"R", "G", "B"};
    std::array<std::size_t, 3> named{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto found = std::ranges::find(image.channel_names, names[c]);
        if (found == image.channel_names.end()) return channels;
        named[c] = static_cast<std::size_t>(found - image.channel_names.begin());
    }
    return named;
}

namespace {

ImageLayer layer_of_reference(const Image& reference, const std::string& layer) {
    if (const auto found = layer_of(reference, layer)) return *found;
    throw Error(fmt::format("the reference has no layer '{}'", layer),
                "choose one of its layers, or leave the layer out to compare the pictures");
}

void exclude_outside(AlignedImages& images, const PixelRegion& region) {
    const Image& reference = images.reference;
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
                images.pixels[static_cast<std::size_t>(y) * reference.width + x] = PixelState::excluded;
}

void exclude_masked(AlignedImages& images, const Image& mask) {
    if (mask.width != images.reference.width || mask.height != images.reference.height)
        throw Error(fmt::format("the mask is {}x{}, the reference {}x{}", mask.width, mask.height,
                                images.reference.width, images.reference.height),
                    "make a mask of the reference's size");
    for (std::size_t i = 0; i < images.pixels.size(); ++i)
        if (!(mask.pixels[i * static_cast<std::size_t>(mask.channels)] > 0.5f))
            images.pixels[i] = PixelState::excluded;
}

bool is_finite(std::span<const float> values) {
    return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

void set_aside_nonfinite(AlignedImages& images) {
    for (std::size_t i = 0; i < images.pixels.size(); ++i) {
        if (images.pixels[i] != PixelState::compared) continue;
        const bool test_is_finite = is_finite(images.test_at(i)),
                   reference_is_finite = is_finite(images.reference_at(i));
        images.nonfinite_test += !test_is_finite;
        images.nonfinite_reference += !reference_is_finite;
        if (!test_is_finite || !reference_is_finite) images.pixels[i] = PixelState::nonfinite;
    }
}

/// Makes both images equal and finite where they are not compared, so that no filter sees a difference there.
void equalize_the_rest(AlignedImages& images) {
    const auto channels = static_cast<std::size_t>(images.reference.channels);
    for (std::size_t i = 0; i < images.pixels.size(); ++i) {
        if (images.pixels[i] == PixelState::compared) {
            images.compared.push_back(i);
            continue;
        }
        for (std::size_t c = i * channels; c < (i + 1) * channels; ++c) {
            if (!std::isfinite(images.reference.pixels[c])) images.reference.pixels[c] = 0.0f;
            images.test.pixels[c] = images.reference.pixels[c];
        }
    }
}

void choose_pixels(AlignedImages& images, const CompareOptions& options) {
    images.pixels.assign(static_cast<std::size_t>(images.reference.width) * images.reference.height,
                         PixelState::compared);
    if (options.region) exclude_outside(images, *options.region);
    if (options.mask) exclude_masked(images, *options.mask);
    if (std::ranges::all_of(images.pixels, [](PixelState pixel) { return pixel == PixelState::excluded; }))
        throw Error("the region and the mask leave no pixel to compare",
                    "choose a larger region or another mask");
    set_aside_nonfinite(images);
    equalize_the_rest(images);
}

} // namespace

std::string incompatibility(const Image& test, const Image& reference, const std::string& layer) {
    const ImageLayer wanted = layer_of_reference(reference, layer);
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

AlignedImages align(const Image& test, const Image& reference, const CompareOptions& options) {
    auto test_layer = layer_of(test, options.layer);
    auto reference_layer = layer_of_reference(reference, options.layer);
    require(test_layer.has_value(), "only compatible images are aligned");
    // Grey is a colour whose channels are equal.
    for (auto* colors : {&test_layer->colors, &reference_layer.colors})
        if (colors->size() == 1 && test_layer->colors.size() != reference_layer.colors.size())
            colors->assign(3, colors->front());
    AlignedImages images;
    images.colors = static_cast<int>(reference_layer.colors.size());
    if (test_layer->alpha && reference_layer.alpha) {
        test_layer->colors.push_back(*test_layer->alpha);
        reference_layer.colors.push_back(*reference_layer.alpha);
    }
    images.test = extract(test, test_layer->colors);
    images.reference = extract(reference, reference_layer.colors);
    choose_pixels(images, options);
    return images;
}

AlignedImages alpha_of(const AlignedImages& images) {
    AlignedImages alpha = images;
    alpha.colors = 1;
    alpha.test = extract(images.test, {images.colors});
    alpha.reference = extract(images.reference, {images.colors});
    return alpha;
}

AlignedImages align(const Image& test, const Image& reference, const OtherLayer& layer,
                    const CompareOptions& options) {
    AlignedImages images;
    images.colors = static_cast<int>(layer.reference.size());
    images.test = extract(test, layer.test);
    images.reference = extract(reference, layer.reference);
    for (std::size_t i = 0; i < images.test.pixels.size(); ++i) {
        float &t = images.test.pixels[i], &r = images.reference.pixels[i];
        if (t == r || (std::isnan(t) && std::isnan(r))) // infinities too
            if (!std::isfinite(r)) t = r = 0.0f;
    }
    choose_pixels(images, options);
    return images;
}

std::vector<OtherLayer> other_layers(const Image& test, const Image& reference) {
    const auto names = names_of(reference), test_names = names_of(test);
    const auto picture = layer_of(reference, "");
    std::vector<OtherLayer> layers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int channel = static_cast<int>(i);
        if (picture
            && (picture->alpha == channel
                || std::ranges::find(picture->colors, channel) != picture->colors.end()))
            continue;
        const auto dot = names[i].rfind('.');
        const std::string name = dot == std::string::npos ? std::string() : names[i].substr(0, dot);
        auto layer = std::ranges::find(layers, name, &OtherLayer::name);
        if (layer == layers.end()) layer = layers.insert(layers.end(), OtherLayer{name, {}, {}, {}, {}});
        if (const auto found = index_of(test_names, names[i])) {
            layer->channels.push_back(names[i]);
            layer->reference.push_back(channel);
            layer->test.push_back(*found);
        } else {
            layer->missing.push_back(names[i]);
        }
    }
    return layers;
}

bool lacks_alpha(const Image& test, const Image& reference, const std::string& layer) {
    const auto wanted = layer_of(reference, layer), found = layer_of(test, layer);
    return wanted && found && wanted->alpha && !found->alpha;
}

} // namespace sr::compare
