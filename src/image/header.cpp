#include "image/header.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <string_view>

namespace sr::image {
namespace {

using Bytes = std::span<const std::uint8_t>;

std::uint32_t big_endian(Bytes bytes) {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes) value = value << 8 | byte;
    return value;
}

template<std::size_t n>
bool starts_with(Bytes bytes, const std::array<std::uint8_t, n>& magic) {
    return bytes.size() >= n && std::equal(magic.begin(), magic.end(), bytes.begin());
}

constexpr std::array<std::uint8_t, 8> png_magic{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<std::uint8_t, 3> jpeg_magic{0xFF, 0xD8, 0xFF};

/// Returns whether the chunks fill the file up to an IEND (PNG specification, section 5.3). OpenImageIO reads
/// a truncated file past its end, and leaks memory when it finds out.
bool is_whole_png(Bytes bytes) {
    constexpr std::size_t frame = 12; // length, type and checksum
    constexpr std::array<std::uint8_t, 4> iend{'I', 'E', 'N', 'D'};
    for (bytes = bytes.subspan(png_magic.size()); bytes.size() >= frame;) {
        if (starts_with(bytes.subspan(4), iend)) return true;
        const std::size_t size = frame + big_endian(bytes.first(4));
        if (size > bytes.size()) return false;
        bytes = bytes.subspan(size);
    }
    return false;
}

/// The IHDR chunk comes first (PNG specification, section 5.6).
std::optional<Header> png_header(Bytes bytes) {
    constexpr std::array<std::uint8_t, 4> ihdr{'I', 'H', 'D', 'R'};
    if (bytes.size() < 24 || !starts_with(bytes.subspan(12), ihdr) || !is_whole_png(bytes))
        return std::nullopt;
    return Header{TextureFormat::png, big_endian(bytes.subspan(16, 4)), big_endian(bytes.subspan(20, 4))};
}

/// A frame header SOF0…SOF15; the codes between them that are none: DHT, JPG, DAC (ITU-T T.81, Table B.1).
bool starts_frame(std::uint8_t marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

bool has_end_of_image(Bytes bytes) {
    constexpr std::array<std::uint8_t, 2> eoi{0xFF, 0xD9};
    return !std::ranges::find_end(bytes, eoi).empty();
}

/// Walks the marker segments up to the frame header (ITU-T T.81, B.1 and B.2.2).
std::optional<Header> jpeg_header(Bytes bytes) {
    std::size_t at = 2;
    while (at + 9 <= bytes.size()) {
        if (bytes[at] != 0xFF) return std::nullopt;
        const std::uint8_t marker = bytes[at + 1];
        if (marker == 0xFF) { // a fill byte
            ++at;
            continue;
        }
        if (starts_frame(marker)) {
            // A truncated file would decode with grey for what is missing. (A thumbnail's end comes before
            // the frame.)
            if (!has_end_of_image(bytes.subspan(at))) return std::nullopt;
            return Header{TextureFormat::jpeg, big_endian(bytes.subspan(at + 7, 2)),
                          big_endian(bytes.subspan(at + 5, 2))};
        }
        at += 2 + big_endian(bytes.subspan(at + 2, 2));
    }
    return std::nullopt;
}

/// A name for what else people put into a glTF file.
std::string_view other_format(Bytes bytes) {
    constexpr std::array<std::uint8_t, 7> ktx2{0xAB, 'K', 'T', 'X', ' ', '2', '0'};
    constexpr std::array<std::uint8_t, 4> dds{'D', 'D', 'S', ' '};
    if (starts_with(bytes, ktx2)) return "a KTX2 image";
    if (starts_with(bytes, dds)) return "a DDS image";
    return "neither PNG nor JPEG";
}

} // namespace

Header read_header(Bytes bytes, const std::string& name) {
    const Location where{name};
    const bool is_png = starts_with(bytes, png_magic);
    if (!is_png && !starts_with(bytes, jpeg_magic))
        throw Error(where, fmt::format("{}, which is not supported", other_format(bytes)),
                    "convert it to PNG or JPEG");
    const std::optional<Header> header = is_png ? png_header(bytes) : jpeg_header(bytes);
    if (!header || header->width == 0 || header->height == 0)
        throw Error(where, is_png ? "a broken or truncated PNG" : "a broken or truncated JPEG",
                    "export it again");
    check_size(header->width, header->height, name);
    return *header;
}

void check_size(std::uint32_t width, std::uint32_t height, const std::string& name) {
    const std::uint64_t texels = std::uint64_t{width} * height;
    if (width > max_texture_size || height > max_texture_size || texels > max_texture_texels)
        throw Error({name}, fmt::format("{} x {} texels are too many", width, height),
                    fmt::format("scale it to at most {} texels along an edge and {} in all", max_texture_size,
                                max_texture_texels));
}

bool is_lfs_pointer(const std::filesystem::path& file) {
    constexpr std::string_view beginning =
        "version https://git-lfs.github.com/spec/"; // Git LFS, docs/spec.md
    std::array<char, beginning.size()> head{};
    std::ifstream stream(file, std::ios::binary);
    return stream.read(head.data(), head.size()) && std::string_view(head.data(), head.size()) == beginning;
}

} // namespace sr::image
