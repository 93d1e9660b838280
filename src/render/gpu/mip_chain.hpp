#pragma once
// The mip levels of an image in the form that the GPU stores, made on the CPU: the same on every driver.
#include "scene/material.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace sr::render {

/// The type of a stored channel.
enum class TexelFormat {
    unorm8,              // codes of 8 bits, linear
    srgb8,               // codes of 8 bits, sRGB but for alpha; the driver decodes
    unorm16,             // codes of 16 bits, linear
    float16,             // linear light, half float: relative error 2^-11, alpha too
    float16_exact_alpha, // the same, but alpha is an image's 8-bit code over 256, which a half float holds
                         // exactly
    float32,             // linear light, float
};

/// Bit c: channel c of an image, in the order RGBA.
constexpr unsigned all_channels = 0b1111u;

/// A stored texel.
struct TexelLayout {
    TexelFormat format = TexelFormat::unorm8;
    /// The image's channels that it has, in their order: one or two of unorm16, or all.
    unsigned channels = all_channels;

    bool operator==(const TexelLayout&) const = default;
};

/// How exactly a texture must be stored.
struct TexelNeeds {
    /// The driver decodes sRGB or filters 8-bit texels with fewer bits than they have.
    bool driver_is_inexact = false;
    /// Alpha is compared with a cutoff, so it must keep its exact value.
    bool alpha_is_compared = false;
    /// Those that shaders read, as in TexelLayout.
    unsigned channels = all_channels;

    bool operator==(const TexelNeeds&) const = default;
};

/// Returns the smallest layout that keeps what shaders read of `image`. A 16-bit sRGB image has no format of
/// its own in GL, and becomes linear floats.
TexelLayout texel_layout(const scene::TextureImage& image, scene::ColorSpace color_space, TexelNeeds needs);

/// The texels of an image. Their alpha may be a channel of another image.
struct TexelSource {
    TexelSource(const scene::TextureImage& image); // NOLINT(google-explicit-constructor): any image is one
    /// Both images have one size, and codes of 8 bits.
    TexelSource(const scene::TextureImage& image, const scene::TextureImage& alpha_from, int alpha_channel);

    const scene::TextureImage& image;
    const scene::TextureImage* alpha_from = nullptr;
    int alpha_channel = 3;
};

/// A mip level below the image's own, level 0.
struct MipLevel {
    int width = 0;
    int height = 0;
    std::size_t size = 0;                 // [bytes] of the texels
    std::unique_ptr<std::byte[]> storage; // width * height texels, first row on top

    std::span<const std::byte> texels() const { return {storage.get(), size}; }
};

/// Returns how many levels an image of this size has, down to 1×1.
std::size_t mip_level_count(int width, int height);

/// Makes the levels of an image below level 0 down to 1×1; each is half the size of the one before, rounded
/// down. A texel is the mean of the texels that it covers (area-weighted where a size is odd), formed in
/// linear light where the image is sRGB-encoded. `layout` is one that texel_layout() returns for the image.
std::vector<MipLevel> lower_mip_levels(const TexelSource& source, scene::ColorSpace color_space,
                                       TexelLayout layout);

/// Gives level 0 to `take` in bands of whole rows from the top. The texels are the image's own, in one band,
/// where the layout is the image's; otherwise they are valid during the call, and few at a time: all would
/// take as much memory once more as they do on the GPU.
void for_each_band(const TexelSource& source, TexelLayout layout,
                   const std::function<void(int first_row, int rows, std::span<const std::byte>)>& take);

} // namespace sr::render
