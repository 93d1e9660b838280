#include "cli/aovs.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <variant>

namespace sr::cli {
namespace {

constexpr std::array all_aovs{Aov::depth,      Aov::normal, Aov::albedo,   Aov::visibility, Aov::cosine,
                              Aov::irradiance, Aov::object, Aov::material, Aov::samples,    Aov::error};

// What these pictures take at most: the surface alone converges soon, and what arrives is no more than a
// look.
constexpr int most_surface_samples = 64;
constexpr int most_light_samples = 1024;

/// Distance along the camera's axis [m] from what views/numbers.frag says.
float axial_distance(float depth, const scene::Camera& camera) {
    const auto* o = std::get_if<scene::Orthographic>(&camera.projection);
    return o ? o->znear + depth * (o->zfar - o->znear) : depth;
}

/// Makes the pictures, those that several AOVs need only once.
class Pictures {
public:
    Pictures(const AovSource& source, const std::function<bool()>& goes_on)
        : source_(source), goes_on_(goes_on) {}

    bool was_stopped() const { return was_stopped_; }

    const image::Image& numbers() {
        if (!numbers_) numbers_ = picture("views/numbers.frag", 1, 0);
        return *numbers_;
    }

    image::Image surface(const char* shader) { return picture(shader, most_surface_samples, 0); }
    image::Image arriving(const char* shader) {
        return picture(shader, most_light_samples, source_.scene.light_count());
    }

private:
    image::Image picture(const char* shader, int most_samples, int lights) {
        render::RenderOptions options = source_.options;
        options.shader = shader;
        options.background = vec3(0.0f);
        options.estimator = render::Estimator::sampled; // whose points these shaders take
        options.estimates_error = false;
        options.samples = std::min(most_samples, std::ranges::max(source_.samples));
        render::Renderer renderer(source_.scene, source_.camera, options);
        renderer.use_lights(0, lights);
        do {
            renderer.add_sample();
            glFinish();
            was_stopped_ = was_stopped_ || !goes_on_();
        } while (!was_stopped_ && renderer.sample_count() < options.samples);
        return renderer.film();
    }

    const AovSource& source_;
    const std::function<bool()>& goes_on_;
    std::optional<image::Image> numbers_;
    bool was_stopped_ = false;
};

/// One value of each pixel, from its four channels.
template<class Value>
std::vector<float> of_each(const image::Image& image, Value value) {
    std::vector<float> values;
    values.reserve(image.pixels.size() / 4);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) values.push_back(value(&image.pixels[i]));
    return values;
}

/// r / g; `without` where g is 0.
std::vector<float> quotients(const image::Image& image, float without) {
    return of_each(image, [=](const float* v) { return v[1] > 0.0f ? v[0] / v[1] : without; });
}

std::vector<Plane> three(const std::string& layer, std::array<const char*, 3> channels,
                         const image::Image& image) {
    std::vector<Plane> planes;
    for (int c = 0; c < 3; ++c)
        planes.push_back({layer + "." + channels[static_cast<std::size_t>(c)], values_of(image, c)});
    return planes;
}

std::vector<Plane> from_numbers(Aov aov, const image::Image& numbers, const scene::Camera& camera) {
    if (aov == Aov::depth)
        return {{"depth.Z", of_each(numbers, [&](const float* v) {
                     return v[3] > 0.0f ? axial_distance(v[2], camera) : 0.0f;
                 })}};
    const std::size_t channel = aov == Aov::object ? 0 : 1;
    return {{fmt::format("{}.id", name_of(aov)),
             of_each(numbers, [=](const float* v) { return v[3] > 0.0f ? v[channel] : -1.0f; })}};
}

std::vector<Plane> planes_of(Aov aov, Pictures& pictures, const AovSource& source) {
    switch (aov) {
    case Aov::depth:
    case Aov::object:
    case Aov::material: return from_numbers(aov, pictures.numbers(), source.camera);
    case Aov::normal: return three("normal", {"X", "Y", "Z"}, pictures.surface("views/normal.frag"));
    case Aov::albedo: return three("albedo", {"R", "G", "B"}, pictures.surface("views/albedo.frag"));
    case Aov::irradiance:
        return three("irradiance", {"R", "G", "B"}, pictures.arriving("views/irradiance.frag"));
    case Aov::visibility:
        return {{"visibility.V", quotients(pictures.arriving("views/visibility.frag"), 1.0f)}};
    case Aov::cosine: return {{"cosine.cos", quotients(pictures.arriving("views/cosine.frag"), 0.0f)}};
    case Aov::samples: return {{"samples.N", {source.samples.begin(), source.samples.end()}}};
    case Aov::error: break;
    }
    require(source.error.has_value(), "the picture knows its error");
    std::vector<float> errors = source.error->squares;
    for (float& error : errors) error = std::sqrt(error);
    return {{"error.relative", std::move(errors)}};
}

template<class Named>
std::string names_as_json(const std::vector<Named>& all) {
    nlohmann::json names = nlohmann::json::array();
    for (const Named& one : all) names.push_back(one.name);
    return names.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace

const char* name_of(Aov aov) {
    constexpr std::array names{"depth",      "normal", "albedo",   "visibility", "cosine",
                               "irradiance", "object", "material", "samples",    "error"};
    return names[static_cast<std::size_t>(aov)];
}

std::vector<std::string> aov_names() {
    std::vector<std::string> names;
    for (const Aov aov : all_aovs) names.emplace_back(name_of(aov));
    return names;
}

std::string aov_help() {
    return fmt::format(
        "further channels of .exr files, separated by commas; src/cli/README.md describes them: {}",
        fmt::join(aov_names(), ", "));
}

std::optional<std::vector<Aov>> parsed_aovs(const std::string& text) {
    std::vector<Aov> aovs;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto comma = std::min(text.find(',', begin), text.size());
        const std::string name = text.substr(begin, comma - begin);
        const auto found =
            std::ranges::find(all_aovs, name, [](Aov aov) { return std::string(name_of(aov)); });
        if (found == all_aovs.end() || std::ranges::find(aovs, *found) != aovs.end()) return std::nullopt;
        aovs.push_back(*found);
        begin = comma + 1;
    }
    return aovs;
}

std::vector<Plane> aov_planes(const std::vector<Aov>& aovs, const AovSource& source,
                              const std::function<bool()>& goes_on) {
    Pictures pictures(source, goes_on);
    std::vector<Plane> planes;
    for (const Aov aov : aovs) {
        std::ranges::move(planes_of(aov, pictures, source), std::back_inserter(planes));
        if (pictures.was_stopped()) return {};
    }
    return planes;
}

std::vector<image::Attribute> name_tables(const std::vector<Aov>& aovs, const scene::Scene& scene) {
    std::vector<image::Attribute> tables;
    if (std::ranges::find(aovs, Aov::object) != aovs.end())
        tables.push_back({"steradian:objects", names_as_json(scene.instances)});
    if (std::ranges::find(aovs, Aov::material) != aovs.end())
        tables.push_back({"steradian:materials", names_as_json(scene.materials)});
    return tables;
}

} // namespace sr::cli
