#pragma once
// Float images in memory.
#include <cstddef>
#include <cstdint>
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

/// The first three channels; of one or two the first as grey. Without attributes.
Image as_rgb(const Image& image);

/// Converts display values in 0..1 to bytes. Values outside of it are clamped; NaN becomes 0.
std::vector<std::uint8_t> as_bytes(const std::vector<float>& values);

// Relative errors: one definition for comparing pictures and for pictures that know their own error.

/// Returns the smallest denominator of a relative error: 1 % of the median magnitude of those colours that
/// are not 0, so that neither a dark picture nor a bright lamp moves it. 0 if all are 0.
double relative_floor(std::vector<float> colors);

/// (difference / reference)², with the floor added in squares: what relMSE is the mean of. 0 for no
/// difference.
double relative_square(double difference, double reference, double floor);

} // namespace sr::image
