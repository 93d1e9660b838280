#pragma once
// PNG files made by hand, of every kind.
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sr::testing {

using ByteVector = std::vector<std::uint8_t>;

struct Png {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint8_t bit_depth = 8;
    std::uint8_t color_type = 0; // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    ByteVector rows;             // as PNG stores them: a filter byte (0) before each row
    ByteVector palette;          // RGB triples
    ByteVector palette_alpha;    // tRNS, of whatever color type
    bool is_interlaced = false;  // then `rows` has those of Adam7's seven passes, one after the other
    std::vector<std::pair<std::string, ByteVector>>
        chunks{}; // before the palette; an iCCP has its profile compressed

    ByteVector bytes() const;
};

} // namespace sr::testing
