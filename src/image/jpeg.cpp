#include "image/texture_formats.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "image/header.hpp"

#include <fmt/format.h>
#include <memory>
#include <turbojpeg.h>

namespace sr::image {
namespace {

constexpr int quality = 95; // measured, see README.md

struct Destroy {
    void operator()(void* codec) const { tjDestroy(codec); }
};

/// CMYK as Adobe's programs store it, inverted, to RGBA in place.
void convert_inverted_cmyk(std::vector<std::uint8_t>& texels) {
    for (std::size_t i = 0; i < texels.size(); i += 4) {
        const unsigned k = texels[i + 3];
        for (std::size_t c = 0; c < 3; ++c)
            texels[i + c] = static_cast<std::uint8_t>((texels[i + c] * k + 127) / 255);
        texels[i + 3] = 255;
    }
}

} // namespace

DecodedTexture decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name) {
    const std::unique_ptr<void, Destroy> decoder(tjInitDecompress());
    if (!decoder) throw std::bad_alloc();
    // A warning (junk between markers, say) leaves a picture, which is taken.
    const auto check = [&](int status) {
        if (status != 0 && tjGetErrorCode(decoder.get()) == TJERR_FATAL)
            throw Error({name}, fmt::format("cannot be decoded ({})", tjGetErrorStr2(decoder.get())),
                        "export the image again");
    };
    const auto size = static_cast<unsigned long>(bytes.size());
    int width = 0, height = 0, subsampling = 0, color_space = 0;
    check(
        tjDecompressHeader3(decoder.get(), bytes.data(), size, &width, &height, &subsampling, &color_space));
    check_size(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), name);
    const bool is_cmyk = color_space == TJCS_CMYK || color_space == TJCS_YCCK;

    DecodedTexture texture{width, height, {}};
    auto& texels = texture.texels.emplace<std::vector<std::uint8_t>>(
        std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    // Many scans of a large picture would take hours (the flag ends at 500).
    check(tjDecompress2(decoder.get(), bytes.data(), size, texels.data(), width, 0, height,
                        is_cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS));
    if (is_cmyk) convert_inverted_cmyk(texels);
    return texture;
}

std::vector<std::uint8_t> encode_jpeg(const Image& image, const std::string& name) {
    const std::unique_ptr<void, Destroy> encoder(tjInitCompress());
    if (!encoder) throw std::bad_alloc();
    const std::vector<std::uint8_t> pixels = as_bytes(as_rgb(image).pixels);
    unsigned char* encoded = nullptr;
    unsigned long size = 0;
    const int status = tjCompress2(encoder.get(), pixels.data(), image.width, 0, image.height, TJPF_RGB,
                                   &encoded, &size, TJSAMP_444, quality, TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, decltype(&tjFree)> owner(encoded, tjFree);
    if (status != 0)
        throw Error({name}, fmt::format("cannot be encoded ({})", one_line(tjGetErrorStr2(encoder.get()))),
                    "write it in another format");
    return {encoded, encoded + size};
}

} // namespace sr::image
