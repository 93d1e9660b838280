#include "cli/layers.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace sr::cli {
namespace {

/// A name that EXR readers do not take apart.
std::string plain(std::string name) {
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
    return name;
}

/// Puts the colours of `layer`, less those of `base`, into the channels from `first` on.
void insert(image::Image& image, int first, const image::Image& layer, const image::Image* base) {
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float other = base ? base->pixels[4 * i + c] : 0.0f;
            image.pixels[i * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(first) + c] =
                layer.pixels[4 * i + c] - other;
        }
    }
}

} // namespace

std::vector<std::string> layer_names(std::span<const scene::Light> lights) {
    std::vector<std::string> names{"emission"};
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const std::string given = plain(std::visit([](const auto& light) { return light.name; }, lights[k]));
        const std::string stem = given.empty() ? fmt::format("light_{}", k) : given;
        std::string name = stem;
        for (int i = 2; std::ranges::find(names, name) != names.end(); ++i)
            name = fmt::format("{}_{}", stem, i);
        names.push_back(name);
    }
    return names;
}

std::optional<image::Image> with_layers(const image::Image& film, const std::vector<std::string>& names,
                                        render::Renderer& renderer,
                                        const std::function<bool(const std::string& layer)>& add_samples) {
    require(film.channels == 4, "a film has four channels");
    image::Image image(film.width, film.height, 4 + 3 * static_cast<int>(names.size()));
    image.channel_names = {"R", "G", "B", "A"};
    image.attributes = film.attributes;
    for (std::size_t i = 0; i < film.pixels.size(); ++i)
        image.pixels[i / 4 * static_cast<std::size_t>(image.channels) + i % 4] = film.pixels[i];
    image::Image dark;
    for (std::size_t layer = 0; layer < names.size(); ++layer) {
        const int lights = static_cast<int>(layer);
        renderer.repeat();
        renderer.use_lights(std::max(lights - 1, 0), lights); // none, then one after the other
        if (!add_samples(names[layer])) return std::nullopt;
        const image::Image picture = renderer.film();
        insert(image, 4 + 3 * lights, picture, layer == 0 ? nullptr : &dark);
        if (layer == 0) dark = picture;
        for (const char* channel : {"R", "G", "B"})
            image.channel_names.push_back(fmt::format("{}.{}", names[layer], channel));
    }
    return image;
}

} // namespace sr::cli
