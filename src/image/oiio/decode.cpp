#include "core/error.hpp"
#include "image/header.hpp"
#include "image/oiio/codec_functions.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <limits>

namespace sr::image::oiio {
namespace {

/// `channels` interleaved values a texel (1: grey, 2: grey and alpha, 3: RGB, 4: RGBA) to RGBA.
template<typename Value>
void expand_row(const Value* from, int channels, int width, Value* to) {
    constexpr Value opaque = std::numeric_limits<Value>::max();
    const bool is_grey = channels < 3;
    const bool has_alpha = channels == 2 || channels == 4;
    for (int x = 0; x < width; ++x, from += channels, to += 4) {
        to[0] = from[0];
        to[1] = from[is_grey ? 0 : 1];
        to[2] = from[is_grey ? 0 : 2];
        to[3] = has_alpha ? from[channels - 1] : opaque;
    }
}

/// Reads row by row: the decoders deliver rows, and one row stays in the cache on its way to RGBA.
template<typename Value>
bool read_rows(OIIO::ImageInput& input, OIIO::TypeDesc type, std::vector<Value>& texels) {
    const OIIO::ImageSpec& spec = input.spec();
    const std::size_t width = static_cast<std::size_t>(spec.width);
    texels.resize(width * static_cast<std::size_t>(spec.height) * 4);
    std::vector<Value> row(width * static_cast<std::size_t>(spec.nchannels));
    for (int y = 0; y < spec.height; ++y) {
        Value* to = texels.data() + static_cast<std::size_t>(y) * width * 4;
        Value* from = spec.nchannels == 4 ? to : row.data();
        if (!input.read_scanline(y, 0, type, from)) return false;
        if (from != to) expand_row(from, spec.nchannels, spec.width, to);
    }
    return true;
}

[[noreturn]] void fail(const std::string& name, std::string_view reason) {
    throw Error({name}, fmt::format("cannot be decoded ({})", one_line(reason)), "export the image again");
}

} // namespace

DecodedTexture decode(std::span<const std::uint8_t> bytes, const std::string& name) {
    const Header header = header_of(bytes, name);
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // values as stored
    const auto input = OIIO::ImageInput::create(header.format == TextureFormat::png ? "png" : "jpeg");
    if (!input || !input->set_ioproxy(&memory)) fail(name, "this OpenImageIO has no decoder for it");
    OIIO::ImageSpec spec;
    // The name only says what OpenImageIO's messages call it.
    if (!input->open(name, spec, config)) fail(name, input->geterror());
    const bool is_as_announced = spec.width == static_cast<int>(header.width)
                                 && spec.height == static_cast<int>(header.height) && spec.nchannels >= 1
                                 && spec.nchannels <= 4;
    if (!is_as_announced) fail(name, "its size is not what its header says");

    DecodedTexture texture{spec.width, spec.height, {}};
    bool is_read = false;
    if (spec.format == OIIO::TypeDesc::UINT16)
        is_read = read_rows(*input, spec.format, texture.texels.emplace<std::vector<std::uint16_t>>());
    else
        is_read =
            read_rows(*input, OIIO::TypeDesc::UINT8, texture.texels.emplace<std::vector<std::uint8_t>>());
    if (!is_read) fail(name, input->geterror());
    return texture;
}

} // namespace sr::image::oiio
