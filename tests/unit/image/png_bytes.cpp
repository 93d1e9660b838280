#include "png_bytes.hpp"

#include <span>

namespace sr::testing {
namespace {

void append_number(ByteVector& to, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append(ByteVector& to, std::span<const std::uint8_t> bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes) { // PNG specification, annex D
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1u ? 0xEDB88320u ^ crc >> 1 : crc >> 1;
    }
    return ~crc;
}

void append_chunk(ByteVector& to, std::string_view type, const ByteVector& data) {
    append_number(to, static_cast<std::uint32_t>(data.size()));
    ByteVector checked(type.begin(), type.end());
    append(checked, data);
    append(to, checked);
    append_number(to, crc32(checked));
}

/// A zlib stream of one stored block (RFC 1950, RFC 1951 section 3.2.4); at most 65535 bytes.
ByteVector stored(const ByteVector& data) {
    const auto low = static_cast<std::uint8_t>(data.size() & 0xFF);
    const auto high = static_cast<std::uint8_t>(data.size() >> 8);
    ByteVector stream{
        0x78, 0x01, 0x01, low, high, static_cast<std::uint8_t>(~low), static_cast<std::uint8_t>(~high)};
    append(stream, data);
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : data) {
        a = (a + byte) % 65521u;
        b = (b + a) % 65521u;
    }
    append_number(stream, b << 16 | a);
    return stream;
}

} // namespace

ByteVector Png::bytes() const {
    ByteVector file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    ByteVector header;
    append_number(header, width);
    append_number(header, height);
    append(header, ByteVector{bit_depth, color_type, 0, 0, static_cast<std::uint8_t>(is_interlaced)});
    append_chunk(file, "IHDR", header);
    for (const auto& [type, data] : chunks) {
        ByteVector written{data};
        if (type == "iCCP") {
            written = {'p', 0, 0}; // its name, and that it is compressed by zlib
            append(written, stored(data));
        }
        append_chunk(file, type, written);
    }
    if (!palette.empty()) append_chunk(file, "PLTE", palette);
    if (!palette_alpha.empty()) append_chunk(file, "tRNS", palette_alpha);
    append_chunk(file, "IDAT", stored(rows));
    append_chunk(file, "IEND", {});
    return file;
}

} // namespace sr::testing
