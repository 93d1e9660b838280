#pragma once
// The mip levels of an image, made on the CPU: by several threads at once, and the same on every driver.
#include "scene/material.hpp"

#include <vector>

namespace sr::render {

/// One mip level; level 0 is the image itself and is not copied.
struct MipLevel {
    int width = 0;
    int height = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> texels; // RGBA, as in TextureImage
};

/// Levels 1 and up, each half the size of the one before (rounded down) until 1×1. A texel is the mean of the
/// texels that it covers (area-weighted where a size is odd), formed in linear light where the image is
/// sRGB-encoded.
std::vector<MipLevel> mip_chain(const scene::TextureImage& image, scene::ColorSpace color_space);

} // namespace sr::render
