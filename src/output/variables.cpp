#include "output/variables.hpp"

#include "core/error.hpp"
#include "core/math.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <array>

namespace sr::output {
namespace {

constexpr std::array variables{
    Variable{"depth", "views/ids_depth.frag",
             "distance from the camera's plane along its axis; 0: no surface", "m", "Z", SampleSource::ids,
             Finish::depth, Display::none},
    Variable{"normal", "views/normal.frag", "shading normal in world space, on the viewer's side", "1",
             "X Y Z", SampleSource::surface, Finish::rgb, Display::none},
    Variable{"albedo", "views/albedo.frag", "the base colour", "1", "R G B", SampleSource::surface,
             Finish::rgb, Display::share},
    Variable{"visibility", "views/visibility.frag", "V, the mean over the lights, weighted by what they send",
             "1", "V", SampleSource::lights, Finish::quotient, Display::share, 1.0f},
    Variable{"cosine", "views/cosine.frag", "cosθ_i, the mean over what arrives", "1", "cos",
             SampleSource::lights, Finish::quotient, Display::share},
    Variable{"irradiance", "views/irradiance.frag", "E, shadows included", "lx", "R G B",
             SampleSource::lights, Finish::rgb, Display::exposed},
    Variable{"object", "views/ids_depth.frag", "index into the attribute steradian:objects; -1: no surface",
             "1", "id", SampleSource::ids, Finish::object, Display::none},
    Variable{"material", "views/ids_depth.frag",
             "index into the attribute steradian:materials; -1: no surface", "1", "id", SampleSource::ids,
             Finish::material, Display::none},
    Variable{"samples", nullptr, "number of the pixel's samples", "1", "N", SampleSource::picture,
             Finish::samples, Display::none},
    Variable{"error", nullptr, "the pixel's estimated relative error", "1", "relative", SampleSource::picture,
             Finish::error, Display::none},
    Variable{"roughness", "views/roughness.frag", "the roughness, times its texture", "1", "",
             SampleSource::surface, Finish::rgb, Display::share},
    Variable{"metallic", "views/metallic.frag", "0: a dielectric, 1: a metal; times its texture", "1", "",
             SampleSource::surface, Finish::rgb, Display::share},
    Variable{"uv", "views/uv.frag",
             "the first texture coordinates, u in R and v in G, without their whole numbers", "1", "",
             SampleSource::surface, Finish::rgb, Display::share},
    Variable{"triangles", "views/triangles.frag", "a colour for each triangle, which means nothing else", "1",
             "", SampleSource::surface, Finish::rgb, Display::share},
    Variable{"wireframe", "views/wireframe.frag",
             "the edges of the triangles that are seen: 1 on an edge, fainter in dense meshes", "1", "",
             SampleSource::surface, Finish::rgb, Display::share},
    Variable{"overdraw", "views/overdraw.frag",
             "surfaces one behind the other: a depth pass draws them all, and an opaque pixel is shaded once",
             "surfaces", "", SampleSource::surface, Finish::rgb, Display::count},
    Variable{"emission", "views/emission.frag", "L_e", nullptr, "", SampleSource::surface, Finish::rgb,
             Display::exposed},
    Variable{"luminance", "forward.frag", "L_o in false colours, a decade a colour", nullptr, "",
             SampleSource::lights, Finish::luminance, Display::false_color},
    Variable{"leaks", "views/leaks.frag",
             "of the light, shadows aside, the share that leaks through from behind the triangle in R and "
             "that its back has to keep out in G",
             "1", "", SampleSource::lights, Finish::leaks, Display::leaks},
};

bool is_aov(const Variable& variable) { return *variable.channels; }
bool is_view(const Variable& variable) { return variable.display != Display::none; }

const Variable* named(std::string_view name, bool (*is_meant)(const Variable&)) {
    const auto* found =
        std::ranges::find_if(variables, [&](const Variable& v) { return v.name == name && is_meant(v); });
    return found == variables.end() ? nullptr : found;
}

image::Image three_channels(const image::Image& numbers, auto color) {
    image::Image colors(numbers.width, numbers.height, 3);
    for (int y = 0; y < numbers.height; ++y)
        for (int x = 0; x < numbers.width; ++x) color(numbers.at(x, y), colors.at(x, y));
    return colors;
}

/// Surfaces are grey, what leaks is red, what is kept out blue.
void leak_color(std::span<const float> number, std::span<float> color) {
    constexpr float grey = 0.1f;
    const float leaks = number[0], kept_out = std::max(number[1] - leaks, 0.0f);
    const float base = grey * number[3] * (1.0f - leaks - kept_out);
    color[0] = image::srgb_encoded(base + leaks);
    color[1] = image::srgb_encoded(base);
    color[2] = image::srgb_encoded(base + kept_out);
}

void divide(const Variable& view, float* p) {
    const float nothing = p[3] > 0.0f ? view.without : 0.0f;
    if (view.finish == Finish::leaks) {
        const float all = p[2];
        p[0] = all > 0.0f ? p[0] / all : nothing;
        p[1] = all > 0.0f ? p[1] / all : nothing;
        p[2] = 0.0f;
    } else {
        std::fill_n(p, 3, p[1] > 0.0f ? p[0] / p[1] : nothing);
    }
}

} // namespace

std::span<const Variable> all_variables() { return variables; }

const Variable* aov_named(std::string_view name) { return named(name, is_aov); }

const Variable* view_named(std::string_view name) { return named(name, is_view); }

std::vector<std::string> aov_names() {
    std::vector<std::string> names;
    for (const Variable& variable : variables)
        if (is_aov(variable)) names.emplace_back(variable.name);
    return names;
}

std::vector<std::string> channels_of(const Variable& variable) {
    std::vector<std::string> names;
    const std::string_view channels = variable.channels;
    for (std::size_t begin = 0; begin < channels.size();) {
        const std::size_t end = std::min(channels.find(' ', begin), channels.size());
        names.push_back(std::string(variable.name) + "." + std::string(channels.substr(begin, end - begin)));
        begin = end + 1;
    }
    return names;
}

std::optional<Variables> parse_aovs(const std::string& text) {
    Variables aovs;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto comma = std::min(text.find(',', begin), text.size());
        const Variable* aov = aov_named(std::string_view(text).substr(begin, comma - begin));
        if (!aov || std::ranges::find(aovs, aov) != aovs.end()) return std::nullopt;
        aovs.push_back(aov);
        begin = comma + 1;
    }
    return aovs;
}

std::string unit_of(const Variable* view, scene::UnitSystem units) {
    if (!view || !view->unit) return std::string(scene::radiance_unit(units));
    const bool is_irradiance = std::string_view(view->unit) == "lx";
    return is_irradiance && units == scene::UnitSystem::radiometric ? "W/m^2" : view->unit;
}

bool holds(const Variables& variables, Finish finish) {
    return std::ranges::any_of(variables, [=](const Variable* v) { return v->finish == finish; });
}

image::Image numbers_of(const Variable& view, const image::Image& film) {
    image::Image numbers = film;
    const bool is_divided = view.finish == Finish::quotient || view.finish == Finish::leaks;
    for (std::size_t i = 0; i < numbers.pixels.size(); i += 4) {
        float* p = &numbers.pixels[i];
        if (is_divided) divide(view, p);
        if (view.finish == Finish::luminance) std::fill_n(p, 3, luminance(p[0], p[1], p[2]));
    }
    return numbers;
}

image::Image colors_of(const Variable& view, const image::Image& numbers) {
    require(view.display != Display::exposed, "light is exposed");
    if (view.display == Display::false_color) return image::luminance_colors(numbers);
    if (view.display == Display::count)
        return three_channels(numbers, [](std::span<const float> number, std::span<float> color) {
            const vec3 rgb = image::luminance_color(number[0], count_decades);
            for (int c = 0; c < 3; ++c) color[static_cast<std::size_t>(c)] = rgb[c];
        });
    if (view.display == Display::leaks) return three_channels(numbers, leak_color);
    return three_channels(numbers, [](std::span<const float> number, std::span<float> color) {
        std::ranges::transform(number.first(3), color.begin(), image::srgb_encoded);
    });
}

} // namespace sr::output
