#pragma once
// Alignment of two images: the same channels of both, and the pixels that are compared.
// An image file has layers: the channels "key.R", "key.G", "key.B" are the layer "key"; "R", "G", "B" are the
// picture itself.
#include "compare/options.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::compare {

/// The channels of a layer, as indices into an image's channels.
struct ImageLayer {
    std::vector<int> colors; // one (grey) to three (R, G, B)
    std::optional<int> alpha;
};

/// Finds the channels of a layer, or of the picture itself for an empty name. An image without channel names
/// has the usual ones. A picture without R, G and B is grey (Y), or its first channels up to three.
/// @return absent if there is no such layer
std::optional<ImageLayer> layer_of(const image::Image& image, std::string_view name);

/// The names of the layers that have R, G and B, in the file's order: a renderer's lights.
std::vector<std::string> layer_names(const image::Image& image);

/// The indices of the channels named R, G and B (a reader may sort channels). Without these names: the first
/// three; of a grey image its only channel three times. The image has at least one channel.
std::array<std::size_t, 3> color_channels(const image::Image& image);

/// Copies the given channels into an image of their own.
image::Image extract(const image::Image& image, const std::vector<int>& channels);

/// The state of a pixel: compared, excluded by the region or the mask, or not finite.
enum class PixelState : std::uint8_t { compared, excluded, nonfinite };

/// Two images with the same channels. Where a pixel is not compared, `test` equals `reference`.
struct AlignedImages {
    image::Image test; // colours, then alpha if both images have it
    image::Image reference;
    int colors = 0; // 1 or 3
    std::vector<PixelState> pixels;
    std::vector<std::size_t> compared; // indices of the compared pixels
    std::size_t nonfinite_test = 0;
    std::size_t nonfinite_reference = 0;

    /// The channels of one pixel by its index, y * width + x.
    std::span<const float> test_at(std::size_t pixel) const { return channels_at(test, pixel); }
    std::span<const float> reference_at(std::size_t pixel) const { return channels_at(reference, pixel); }

private:
    static std::span<const float> channels_at(const image::Image& image, std::size_t pixel) {
        const auto channels = static_cast<std::size_t>(image.channels);
        return {image.pixels.data() + pixel * channels, channels};
    }
};

/// A layer beside the picture, or the picture's channels that are neither colour nor alpha (its name is
/// empty).
struct OtherLayer {
    std::string name;
    std::vector<std::string> channels; // their names in the reference, of those that both have
    std::vector<int> reference;        // channels
    std::vector<int> test;             // the same; without those in `missing`
    std::vector<std::string> missing;  // channels that the test lacks
};

/// The layers of the reference beside the picture, in the file's order.
std::vector<OtherLayer> other_layers(const image::Image& test, const image::Image& reference);

/// True if the reference's layer has alpha and the test's has not.
bool lacks_alpha(const image::Image& test, const image::Image& reference, const std::string& layer);

/// Says why two images cannot be compared ("the test is 64 x 64, the reference 64 x 32"); empty if they can.
/// @throws Error if the reference does not have the layer.
std::string incompatibility(const image::Image& test, const image::Image& reference,
                            const std::string& layer);

/// Aligns two compatible images.
/// @throws Error if the region lies outside or the mask has another size, or if they leave no pixel.
AlignedImages align(const image::Image& test, const image::Image& reference, const CompareOptions& options);

/// The alpha of both images, as a grey picture. Both have it.
AlignedImages alpha_of(const AlignedImages& images);

/// Aligns the channels that both images have of one of the reference's other layers. Values that are not
/// finite and equal are as good as finite ones.
AlignedImages align(const image::Image& test, const image::Image& reference, const OtherLayer& layer,
                    const CompareOptions& options);

} // namespace sr::compare
