#include "output/channels.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <variant>

namespace sr::output {
namespace {

/// A name that EXR readers do not take apart.
std::string plain(std::string name) {
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
    return name;
}

/// Returns one channel.
std::vector<float> values_of(const image::Image& image, int channel) {
    std::vector<float> values;
    values.reserve(image.pixels.size() / static_cast<std::size_t>(image.channels));
    for (auto i = static_cast<std::size_t>(channel); i < image.pixels.size();
         i += static_cast<std::size_t>(image.channels))
        values.push_back(image.pixels[i]);
    return values;
}

// Limits on samples: surfaces converge soon, and light terms are for inspection.
constexpr int max_surface_samples = 64;
constexpr int max_light_samples = 1024;

/// Distance along the camera's axis [m] from what views/ids_depth.frag says.
float axial_distance(float depth, const scene::Camera& camera) {
    const auto* o = std::get_if<scene::Orthographic>(&camera.projection);
    return o ? o->znear + depth * (o->zfar - o->znear) : depth;
}

/// Renders the pictures behind AOVs; the picture of ids only once.
class Pictures {
public:
    Pictures(const AovSource& source, const std::stop_token& stop) : source_(source), stop_(stop) {}

    const image::Image& numbers() {
        if (!numbers_) numbers_ = picture("views/ids_depth.frag", 1, 0);
        return *numbers_;
    }

    image::Image rendered(const Variable& variable) {
        return variable.source == SampleSource::surface
                   ? picture(variable.shader, max_surface_samples, 0)
                   : picture(variable.shader, max_light_samples, source_.scene.light_count());
    }

private:
    image::Image picture(const char* shader, int max_samples, int lights) {
        render::RenderOptions options = source_.options;
        options.shader = shader;
        options.background = vec3(0.0f);
        options.estimator = render::Estimator::sampled; // whose points these shaders take
        options.estimates_error = false;
        options.samples = std::min(max_samples, std::ranges::max(source_.samples));
        render::Renderer renderer(source_.scene, source_.camera, options);
        renderer.use_lights(0, lights);
        do {
            renderer.add_sample();
            glFinish();
        } while (!stop_.stop_requested() && renderer.sample_count() < options.samples);
        return renderer.read_film();
    }

    const AovSource& source_;
    const std::stop_token& stop_;
    std::optional<image::Image> numbers_;
};

/// One value of each pixel, from its four channels.
template<class Value>
std::vector<float> of_each(const image::Image& image, Value value) {
    std::vector<float> values;
    values.reserve(image.pixels.size() / 4);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) values.push_back(value(&image.pixels[i]));
    return values;
}

std::vector<float> depths(const image::Image& numbers, const scene::Camera& camera) {
    return of_each(numbers,
                   [&](const float* v) { return v[3] > 0.0f ? axial_distance(v[2], camera) : 0.0f; });
}

std::vector<float> ids(const image::Image& numbers, std::size_t channel) {
    return of_each(numbers, [=](const float* v) { return v[3] > 0.0f ? v[channel] : -1.0f; });
}

std::vector<float> errors(const AovSource& source) {
    require(source.error.has_value(), "the picture knows its error");
    std::vector<float> errors = source.error->squares;
    for (float& error : errors) error = std::sqrt(error);
    return errors;
}

std::vector<ImageChannel> render_channels(const Variable& aov, Pictures& pictures, const AovSource& source) {
    const std::vector<std::string> names = channels_of(aov);
    switch (aov.finish) {
    case Finish::depth: return {{names[0], depths(pictures.numbers(), source.camera)}};
    case Finish::object: return {{names[0], ids(pictures.numbers(), 0)}};
    case Finish::material: return {{names[0], ids(pictures.numbers(), 1)}};
    case Finish::samples: return {{names[0], {source.samples.begin(), source.samples.end()}}};
    case Finish::error: return {{names[0], errors(source)}};
    case Finish::quotient:
        return {{names[0], of_each(pictures.rendered(aov),
                                   [&](const float* v) { return v[1] > 0.0f ? v[0] / v[1] : aov.without; })}};
    default: break;
    }
    const image::Image picture = pictures.rendered(aov);
    std::vector<ImageChannel> channels;
    for (std::size_t c = 0; c < names.size(); ++c)
        channels.push_back({names[c], values_of(picture, static_cast<int>(c))});
    return channels;
}

template<class Named>
std::string names_as_json(const std::vector<Named>& all) {
    nlohmann::json names = nlohmann::json::array();
    for (const Named& one : all) names.push_back(one.name);
    return names.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace

image::Image with_channels(const image::Image& film, const std::vector<ImageChannel>& channels) {
    require(film.channels == 4, "a film has four channels");
    const std::size_t count = 4 + channels.size();
    image::Image image(film.width, film.height, static_cast<int>(count));
    image.channel_names = {"R", "G", "B", "A"};
    image.attributes = film.attributes;
    for (std::size_t i = 0; i < film.pixels.size(); ++i) image.pixels[i / 4 * count + i % 4] = film.pixels[i];
    for (std::size_t c = 0; c < channels.size(); ++c) {
        require(channels[c].values.size() * 4 == film.pixels.size(), "a channel has the film's size");
        image.channel_names.push_back(channels[c].name);
        for (std::size_t i = 0; i < channels[c].values.size(); ++i)
            image.pixels[i * count + 4 + c] = channels[c].values[i];
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
        const std::string given = plain(std::visit([](const auto& light) { return light.name; }, lights[k]));
        const std::string stem = given.empty() ? fmt::format("light_{}", k) : given;
        std::string name = stem;
        for (int i = 2; is_taken(name); ++i) name = fmt::format("{}_{}", stem, i);
        names.push_back(name);
    }
    return names;
}

std::vector<ImageChannel> render_layers(const std::vector<std::string>& names, render::Renderer& renderer,
                                        const std::function<bool(const std::string& layer)>& add_samples) {
    constexpr std::array colors{"R", "G", "B"};
    std::vector<ImageChannel> channels;
    image::Image dark;
    for (std::size_t layer = 0; layer < names.size(); ++layer) {
        const int lights = static_cast<int>(layer);
        renderer.repeat();
        renderer.use_lights(std::max(lights - 1, 0), lights); // none, then one after the other
        if (!add_samples(names[layer])) return {};
        image::Image picture = renderer.read_film();
        if (layer == 0)
            dark = picture;
        else
            for (std::size_t i = 0; i < dark.pixels.size(); ++i) picture.pixels[i] -= dark.pixels[i];
        for (int c = 0; c < 3; ++c)
            channels.push_back({fmt::format("{}.{}", names[layer], colors[static_cast<std::size_t>(c)]),
                                values_of(picture, c)});
    }
    return channels;
}

std::vector<ImageChannel> render_aovs(const Variables& aovs, const AovSource& source,
                                      const std::stop_token& stop) {
    Pictures pictures(source, stop);
    std::vector<ImageChannel> channels;
    for (const Variable* aov : aovs) {
        std::ranges::move(render_channels(*aov, pictures, source), std::back_inserter(channels));
        if (stop.stop_requested()) return {};
    }
    return channels;
}

std::vector<image::Attribute> name_tables(const Variables& aovs, const scene::Scene& scene) {
    std::vector<image::Attribute> tables;
    if (holds(aovs, Finish::object)) tables.push_back({"steradian:objects", names_as_json(scene.instances)});
    if (holds(aovs, Finish::material))
        tables.push_back({"steradian:materials", names_as_json(scene.materials)});
    return tables;
}

} // namespace sr::output
