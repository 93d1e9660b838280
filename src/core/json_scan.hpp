#pragma once
// What a JSON text asks for, looked at before a parser allocates memory for it.
#include <cstdint>
#include <optional>
#include <string_view>

namespace sr {

struct JsonExtent {
    std::uint64_t values = 0; // an upper bound
    int depth = 0;            // of objects and arrays
};

/// Counts on the text, which need not be valid. nlohmann's parser callback, which is told the depth, would
/// make parsing quadratic in the length of arrays (3.11 looks through all earlier siblings after each
/// element).
JsonExtent json_extent(std::string_view text);

/// Where the first number begins that no double can hold; nlohmann does not tell.
std::optional<std::size_t> overflowing_number(std::string_view text);

} // namespace sr
