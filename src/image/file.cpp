#include "image/file.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/limits.hpp"
#include "core/parallel.hpp"
#include "image/codec.hpp"
#include "image/exr.hpp"
#include "image/header.hpp"
#include "image/texture_formats.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string_view>

namespace sr::image {
namespace {

namespace fs = std::filesystem;

enum class Format { exr, hdr, png, jpeg };

Format format_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".exr") return Format::exr;
    if (extension == ".hdr") return Format::hdr;
    if (extension == ".png") return Format::png;
    if (extension == ".jpg" || extension == ".jpeg") return Format::jpeg;
    const std::string what = extension.empty() ? std::string("no extension to tell the image format by")
                                               : fmt::format("unknown image format {}", extension);
    throw Error({file.string()}, what, "use .exr, .hdr, .png, .jpg or .jpeg");
}

} // namespace

std::future<void> preload() {
    return started([] { codec(); });
}

bool loads_openimageio(const fs::path& file) { return format_of(file) == Format::hdr; }

bool is_scene_referred(const fs::path& file) {
    const Format format = format_of(file);
    return format == Format::exr || format == Format::hdr;
}

void WholeFiles::add(const Image& image, const fs::path& file, SampleType type) {
    const Format format = format_of(file);
    const std::size_t samples = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)
                                * static_cast<std::size_t>(image.channels);
    require(samples > 0 && image.pixels.size() == samples, "an image has as many samples as its size says");
    const std::string name = file.string();
    if (format == Format::png) return add(file, encode_png(image, name));
    if (format == Format::jpeg) return add(file, encode_jpeg(image, name));
    if (format == Format::hdr) return add(file, codec().encode_hdr(image, name));
    const bool is_clamped = type == SampleType::half && half_overflow_count(image) > 0;
    add(file, encode_exr(is_clamped ? within_half(image) : image, type, name));
}

void write(const Image& image, const fs::path& file, SampleType type) {
    WholeFiles files;
    files.add(image, file, type);
    files.put_in_place();
}

Image read(const fs::path& file) {
    require_regular_file(file); // before OpenImageIO opens it by its path
    if (is_lfs_pointer(file))
        throw Error({file.string()}, "this is a Git LFS pointer, not an image",
                    "fetch the image with git lfs pull");
    if (auto plain = read_plain_exr(file, limit(Limit::pixels))) return std::move(*plain);
    return codec().read(file, limit(Limit::pixels));
}

bool is_webp(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view riff = "RIFF";
    constexpr std::string_view webp = "WEBP"; // after the size
    return bytes.size() >= 12 && std::equal(riff.begin(), riff.end(), bytes.begin())
           && std::equal(webp.begin(), webp.end(), bytes.begin() + 8);
}

bool is_ktx2(std::span<const std::uint8_t> bytes) {
    constexpr std::array<std::uint8_t, 7> magic{0xAB, 'K', 'T', 'X', ' ', '2', '0'};
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

std::uint64_t claimed_texels(std::span<const std::uint8_t> bytes) {
    try {
        if (is_webp(bytes)) return webp_texels(bytes);
        const Header header = read_header(bytes, "");
        return std::uint64_t{header.width} * header.height;
    } catch (const Error&) { // decoding it will say what is wrong
        return 0;
    }
}

DecodedTexture decode_texture(std::span<const std::uint8_t> bytes, const std::string& name) {
    if (is_webp(bytes)) return decode_webp(bytes, name);
    return read_header(bytes, name).format == TextureFormat::png ? decode_png(bytes, name)
                                                                 : decode_jpeg(bytes, name);
}

} // namespace sr::image
