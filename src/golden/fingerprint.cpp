#include "golden/fingerprint.hpp"

#include "golden/sha256.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace sr::golden {

std::string fingerprint(const image::Image& image) {
    const std::string header = fmt::format("{}x{}x{} {}\n", image.width, image.height, image.channels,
                                           fmt::join(image.channel_names, "\n"));
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    const auto* begin = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
    bytes.insert(bytes.end(), begin, begin + image.pixels.size() * sizeof(float));
    return hexadecimal(sha256(bytes));
}

} // namespace sr::golden
