#pragma once
// JPEG files made by hand: 8×8 pixels of one colour, of every kind that a decoder may meet.
#include <cstdint>
#include <optional>
#include <vector>

namespace sr::testing {

struct FlatJpeg {
    std::vector<std::uint8_t> values;            // of the components as stored: Y | Y Cb Cr | C M Y K
    bool is_progressive = false;                 // the coefficients in several scans
    std::optional<std::uint8_t> adobe_transform; // the marker of Adobe: 0 none, 1 YCbCr, 2 YCCK
    std::optional<std::uint8_t> orientation;     // Exif's, 1 to 8
    std::uint8_t frame = 0xC0;                   // SOF; a progressive one has 0xC2

    std::vector<std::uint8_t> bytes() const;
};

} // namespace sr::testing
