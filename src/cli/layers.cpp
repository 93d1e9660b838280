#include "cli/layers.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
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

} // namespace

std::vector<float> values_of(const image::Image& image, int channel) {
    std::vector<float> values;
    values.reserve(image.pixels.size() / static_cast<std::size_t>(image.channels));
    for (auto i = static_cast<std::size_t>(channel); i < image.pixels.size();
         i += static_cast<std::size_t>(image.channels))
        values.push_back(image.pixels[i]);
    return values;
}

image::Image with_planes(const image::Image& film, const std::vector<Plane>& planes) {
    require(film.channels == 4, "a film has four channels");
    const std::size_t channels = 4 + planes.size();
    image::Image image(film.width, film.height, static_cast<int>(channels));
    image.channel_names = {"R", "G", "B", "A"};
    image.attributes = film.attributes;
    for (std::size_t i = 0; i < film.pixels.size(); ++i)
        image.pixels[i / 4 * channels + i % 4] = film.pixels[i];
    for (std::size_t p = 0; p < planes.size(); ++p) {
        require(planes[p].values.size() * 4 == film.pixels.size(), "a plane has the film's size");
        image.channel_names.push_back(planes[p].name);
        for (std::size_t i = 0; i < planes[p].values.size(); ++i)
            image.pixels[i * channels + 4 + p] = planes[p].values[i];
    }
    return image;
}

std::vector<std::string> layer_names(std::span<const scene::Light> lights,
                                     const std::vector<std::string>& reserved) {
    std::vector<std::string> names{"emission"};
    const auto is_taken = [&](const std::string& name) {
        return std::ranges::find(names, name) != names.end()
               || std::ranges::find(reserved, name) != reserved.end();
    };
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const std::string given = plain(scene::name_of(lights[k]));
        const std::string stem = given.empty() ? fmt::format("light_{}", k) : given;
        std::string name = stem;
        for (int i = 2; is_taken(name); ++i) name = fmt::format("{}_{}", stem, i);
        names.push_back(name);
    }
    return names;
}

std::vector<Plane> light_layers(const std::vector<std::string>& names, render::Renderer& renderer,
                                const std::function<bool(const std::string& layer)>& add_samples) {
    constexpr std::array channels{"R", "G", "B"};
    std::vector<Plane> planes;
    image::Image dark;
    for (std::size_t layer = 0; layer < names.size(); ++layer) {
        const int lights = static_cast<int>(layer);
        renderer.repeat();
        renderer.use_lights(std::max(lights - 1, 0), lights); // none, then one after the other
        if (!add_samples(names[layer])) return {};
        image::Image picture = renderer.film();
        if (layer == 0)
            dark = picture;
        else
            for (std::size_t i = 0; i < dark.pixels.size(); ++i) picture.pixels[i] -= dark.pixels[i];
        for (int c = 0; c < 3; ++c)
            planes.push_back({fmt::format("{}.{}", names[layer], channels[static_cast<std::size_t>(c)]),
                              values_of(picture, c)});
    }
    return planes;
}

} // namespace sr::cli
