#include "golden/layer.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace sr::golden {
namespace {

using image::Image;

std::vector<std::string> names_of(const Image& image) {
    if (static_cast<int>(image.channel_names.size()) == image.channels) return image.channel_names;
    if (image.channels <= 2)
        return image.channels == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"Y", "A"};
    std::vector<std::string> names{"R", "G", "B", "A"};
    names.resize(static_cast<std::size_t>(image.channels)); // more than four: nameless
    return names;
}

bool equal_but_for_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::optional<int> index_of(const std::vector<std::string>& names, const std::string& name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (equal_but_for_case(names[i], name)) return static_cast<int>(i);
    return std::nullopt;
}

bool belongs_to(const std::string& channel, std::string_view layer) {
    const auto dot = channel.rfind('.');
    return dot == std::string::npos ? layer.empty() : std::string_view(channel).substr(0, dot) == layer;
}

} // namespace

std::optional<Layer> layer_of(const Image& image, std::string_view name) {
    const auto names = names_of(image);
    const std::string prefix = name.empty() ? std::string() : std::string(name) + ".";
    Layer layer;
    layer.alpha = index_of(names, prefix + "A");
    const std::array rgb{index_of(names, prefix + "R"), index_of(names, prefix + "G"),
                         index_of(names, prefix + "B")};
    if (rgb[0] && rgb[1] && rgb[2]) {
        layer.colors = {*rgb[0], *rgb[1], *rgb[2]};
    } else if (const auto grey = index_of(names, prefix + "Y")) {
        layer.colors = {*grey};
    } else {
        for (std::size_t i = 0; i < names.size() && layer.colors.size() < 3; ++i)
            if (static_cast<int>(i) != layer.alpha && belongs_to(names[i], name))
                layer.colors.push_back(static_cast<int>(i));
        if (layer.colors.size() == 2) layer.colors.pop_back(); // not a colour: grey and something else
    }
    if (layer.colors.empty()) return std::nullopt;
    return layer;
}

std::vector<std::string> layer_names(const Image& image) {
    std::vector<std::string> layers;
    const auto names = names_of(image);
    for (const std::string& name : names) {
        if (!name.ends_with(".R")) continue;
        const std::string layer = name.substr(0, name.size() - 2);
        if (index_of(names, layer + ".G") && index_of(names, layer + ".B")) layers.push_back(layer);
    }
    return layers;
}

Image extracted(const Image& image, const std::vector<int>& channels) {
    Image result(image.width, image.height, static_cast<int>(channels.size()));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto from = image.at(x, y);
            const auto to = result.at(x, y);
            for (std::size_t c = 0; c < channels.size(); ++c)
                to[c] = from[static_cast<std::size_t>(channels[c])];
        }
    return result;
}

} // namespace sr::golden
