#pragma once
// Float images in memory.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace sr::image {

/// A metadata entry of an image file (EXR attribute).
struct Attribute {
    std::string name; // "steradian:unit"
    std::string value;
};

/// Rows from top to bottom, `channels` interleaved floats a pixel. Linear, scene-referred.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> pixels; // width * height * channels
    std::vector<std::string>
        channel_names; // "R", "G", "B", "A", or a layer's "key.R"; empty: the usual names
    std::vector<Attribute> attributes;

    Image() = default;
    Image(int width, int height, int channels);

    std::span<float> at(int x, int y) {
        return {pixels.data() + offset(x, y), static_cast<std::size_t>(channels)};
    }
    std::span<const float> at(int x, int y) const {
        return {pixels.data() + offset(x, y), static_cast<std::size_t>(channels)};
    }

private:
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y) * width + x) * static_cast<std::size_t>(channels);
    }
};

} // namespace sr::image
