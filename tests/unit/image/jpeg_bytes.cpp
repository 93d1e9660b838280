#include "jpeg_bytes.hpp"

#include <bit>
#include <cstdlib>
#include <string_view>

namespace sr::testing {
namespace {

using JpegBytes = std::vector<std::uint8_t>;

/// Entropy-coded data (ITU-T T.81, F.1.2): bits, the highest first, 0xFF followed by a zero byte.
class BitString {
public:
    void append(unsigned bits, int count) {
        for (int i = count - 1; i >= 0; --i) {
            byte_ = byte_ << 1 | (bits >> i & 1u);
            if (++filled_ == 8) flush();
        }
    }

    JpegBytes finished() {
        while (filled_ > 0) append(1, 1);
        return bytes_;
    }

private:
    void flush() {
        bytes_.push_back(static_cast<std::uint8_t>(byte_));
        if (byte_ == 0xFF) bytes_.push_back(0);
        byte_ = 0;
        filled_ = 0;
    }

    JpegBytes bytes_;
    unsigned byte_ = 0;
    int filled_ = 0;
};

void append_segment(JpegBytes& file, std::uint8_t marker, const JpegBytes& data) {
    const std::size_t size = data.size() + 2;
    file.insert(file.end(),
                {0xFF, marker, static_cast<std::uint8_t>(size >> 8), static_cast<std::uint8_t>(size & 0xFF)});
    file.insert(file.end(), data.begin(), data.end());
}

JpegBytes with_text(std::string_view text, const JpegBytes& rest) {
    JpegBytes data(text.begin(), text.end());
    data.insert(data.end(), rest.begin(), rest.end());
    return data;
}

/// The code of a block's mean: the quantisation step is 8, so that it is the value less 128. The categories 0
/// to 8 have codes of four bits.
void append_mean(BitString& bits, std::uint8_t value) {
    const int mean = int{value} - 128;
    const int category = std::bit_width(static_cast<unsigned>(std::abs(mean)));
    bits.append(static_cast<unsigned>(category), 4);
    bits.append(static_cast<unsigned>(mean >= 0 ? mean : mean + (1 << category) - 1), category);
}

constexpr unsigned end_of_block = 0; // of one bit

/// A scan of the coefficients [first, last] of the components.
void append_scan(JpegBytes& file, const JpegBytes& components, std::uint8_t first, std::uint8_t last,
                 BitString bits) {
    JpegBytes header{static_cast<std::uint8_t>(components.size())};
    for (const std::uint8_t component : components) header.insert(header.end(), {component, 0});
    header.insert(header.end(), {first, last, 0});
    append_segment(file, 0xDA, header);
    const JpegBytes data = bits.finished();
    file.insert(file.end(), data.begin(), data.end());
}

void append_tables(JpegBytes& file) {
    JpegBytes quantisation(65, 8);
    quantisation[0] = 0;
    append_segment(file, 0xDB, quantisation);
    append_segment(file, 0xC4,
                   {0x00, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8});
    append_segment(file, 0xC4, {0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x00});
}

} // namespace

std::vector<std::uint8_t> FlatJpeg::bytes() const {
    JpegBytes file{0xFF, 0xD8};
    if (adobe_transform)
        append_segment(file, 0xEE, with_text("Adobe", {0, 100, 0, 0, 0, 0, *adobe_transform}));
    if (orientation) // one entry of TIFF's, big-endian: tag 0x0112, a short
        append_segment(
            file, 0xE1,
            with_text(std::string_view("Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 25),
                      {*orientation, 0, 0, 0, 0, 0, 0}));
    append_tables(file);
    JpegBytes header{8, 0, 8, 0, 8, static_cast<std::uint8_t>(values.size())}, components;
    for (std::size_t i = 0; i < values.size(); ++i) {
        components.push_back(static_cast<std::uint8_t>(i + 1));
        header.insert(header.end(), {components.back(), 0x11, 0});
    }
    append_segment(file, is_progressive ? 0xC2 : frame, header);
    BitString means;
    for (const std::uint8_t value : values) {
        append_mean(means, value);
        if (!is_progressive) means.append(end_of_block, 1);
    }
    append_scan(file, components, 0, is_progressive ? 0 : 63, means);
    for (std::size_t i = 0; is_progressive && i < values.size(); ++i) {
        BitString rest;
        rest.append(end_of_block, 1);
        append_scan(file, {components[i]}, 1, 63, rest);
    }
    file.insert(file.end(), {0xFF, 0xD9});
    return file;
}

} // namespace sr::testing
