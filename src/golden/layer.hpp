#pragma once
// The layers of an image file: channels "key.R", "key.G", "key.B" are the layer "key", "R", "G", "B" the
// picture.
#include "image/image.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::golden {

/// Where a layer's channels lie among an image's.
struct Layer {
    std::vector<int> colors; // one (grey) to three (R, G, B)
    std::optional<int> alpha;
};

/// The channels of a layer, or of the picture itself for an empty name; absent if there is no such layer.
/// An image without channel names has the usual ones; a picture without R, G and B is grey (Y), or its first
/// channels up to three.
std::optional<Layer> layer_of(const image::Image& image, std::string_view name);

/// The names of the layers that have R, G and B, in the file's order: a renderer's lights.
std::vector<std::string> layer_names(const image::Image& image);

/// A layer's colours alone, as an image of its own.
image::Image extracted(const image::Image& image, const std::vector<int>& channels);

} // namespace sr::golden
