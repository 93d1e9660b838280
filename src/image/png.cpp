#include "image/texture_formats.hpp"

#include "core/error.hpp"
#include "image/header.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <spng.h>

namespace sr::image {
namespace {

constexpr std::size_t max_text = std::size_t{16}
                                 << 20; // [bytes] of a chunk that is no picture, and of all of them

struct Free {
    void operator()(spng_ctx* context) const { spng_ctx_free(context); }
    void operator()(void* bytes) const { std::free(bytes); }
};
using Context = std::unique_ptr<spng_ctx, Free>;

/// @throws std::bad_alloc
Context context_for(int flags) {
    Context context(spng_ctx_new(flags));
    if (!context) throw std::bad_alloc();
    return context;
}

/// Creates a text chunk: tEXt for ASCII, iTXt for other UTF-8 (PNG specification, section 11.3.4).
/// The attribute must outlive it.
spng_text text_chunk(const Attribute& attribute) {
    static char empty[] = "";
    spng_text text{};
    attribute.name.copy(text.keyword, sizeof text.keyword - 1);
    const bool is_ascii =
        std::ranges::all_of(attribute.value, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    text.type = is_ascii ? SPNG_TEXT : SPNG_ITXT;
    text.text = const_cast<char*>(attribute.value.c_str()); // libspng only reads it
    text.length = attribute.value.size();
    text.language_tag = text.translated_keyword = empty;
    return text;
}

std::uint8_t color_type(int channels) {
    constexpr std::array<std::uint8_t, 4> types{SPNG_COLOR_TYPE_GRAYSCALE, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA,
                                                SPNG_COLOR_TYPE_TRUECOLOR, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA};
    return types[static_cast<std::size_t>(channels - 1)];
}

/// Sets what comes before the pixels. The compression level and the filter were measured, see README.md.
void describe(spng_ctx* png, const Image& image) {
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(image.width);
    header.height = static_cast<std::uint32_t>(image.height);
    header.bit_depth = 8;
    header.color_type = color_type(image.channels);
    spng_set_ihdr(png, &header);
    spng_set_srgb(png, 0); // perceptual
    spng_set_option(png, SPNG_IMG_COMPRESSION_LEVEL, 1);
    spng_set_option(png, SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB);
    spng_set_option(png, SPNG_ENCODE_TO_BUFFER, 1);
}

} // namespace

DecodedTexture decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
    const auto check = [&](int status) {
        if (status != 0)
            throw Error({name}, fmt::format("cannot be decoded ({})", spng_strerror(status)),
                        "export the image again");
    };
    const Context png = context_for(0);
    check(spng_set_image_limits(png.get(), max_texture_size, max_texture_size));
    check(spng_set_chunk_limits(png.get(), max_text, max_text));
    check(spng_set_png_buffer(png.get(), bytes.data(), bytes.size()));
    spng_ihdr header{};
    check(spng_get_ihdr(png.get(), &header));
    check_size(header.width, header.height, name);

    DecodedTexture texture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
    const std::size_t values = std::size_t{4} * header.width * header.height;
    if (header.bit_depth == 16) {
        auto& texels = texture.texels.emplace<std::vector<std::uint16_t>>(values);
        check(spng_decode_image(png.get(), texels.data(), 2 * values, SPNG_FMT_RGBA16, SPNG_DECODE_TRNS));
    } else {
        auto& texels = texture.texels.emplace<std::vector<std::uint8_t>>(values);
        check(spng_decode_image(png.get(), texels.data(), values, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS));
    }
    return texture;
}

std::vector<std::uint8_t> encode_png(const Image& image, const std::string& name) {
    if (image.channels > 4)
        throw Error({name}, fmt::format("PNG cannot hold {} channels", image.channels), "write an .exr");
    const Context png = context_for(SPNG_CTX_ENCODER);
    describe(png.get(), image);
    std::vector<spng_text> texts;
    for (const Attribute& attribute : image.attributes) texts.push_back(text_chunk(attribute));
    if (!texts.empty()) spng_set_text(png.get(), texts.data(), static_cast<std::uint32_t>(texts.size()));
    const std::vector<std::uint8_t> pixels = as_bytes(image.pixels);
    int status =
        spng_encode_image(png.get(), pixels.data(), pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
    std::size_t size = 0;
    const std::unique_ptr<void, Free> encoded(status == 0 ? spng_get_png_buffer(png.get(), &size, &status)
                                                          : nullptr);
    if (status != 0)
        throw Error({name}, fmt::format("cannot be encoded ({})", spng_strerror(status)),
                    "write it in another format");
    const auto* first = static_cast<const std::uint8_t*>(encoded.get());
    return {first, first + size};
}

} // namespace sr::image
