#include "golden/colour_channels.hpp"

#include <algorithm>

namespace sr::golden {

std::array<std::size_t, 3> colour_channels(const image::Image& image) {
    std::array<std::size_t, 3> channels{0, 1, 2};
    if (image.channels < 3) channels = {0, 0, 0};
    constexpr std::array names{"R", "G", "B"};
    std::array<std::size_t, 3> named{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto found = std::ranges::find(image.channel_names, names[c]);
        if (found == image.channel_names.end()) return channels;
        named[c] = static_cast<std::size_t>(found - image.channel_names.begin());
    }
    return named;
}

} // namespace sr::golden
