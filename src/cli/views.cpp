#include "cli/views.hpp"

#include "core/error.hpp"
#include "core/luminance.hpp"
#include "image/colormap.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sr::cli {
namespace {

constexpr std::array views{
    View{"visibility", "views/visibility.frag", "V, the mean over the lights, weighted by what they send",
         ViewKind::share, "1", true, 1.0f},
    View{"irradiance", "views/irradiance.frag", "E, shadows included", ViewKind::light, "lx", false, 0.0f},
    View{"cosine", "views/cosine.frag", "cosθ_i, the mean over what arrives", ViewKind::share, "1", true,
         0.0f},
    View{"emission", "views/emission.frag", "L_e", ViewKind::light, nullptr, false, 0.0f},
    View{"albedo", "views/albedo.frag", "the base colour", ViewKind::share, "1", false, 0.0f},
    View{"luminance", "forward.frag", "L_o in false colours, a decade a colour", ViewKind::luminance, nullptr,
         false, 0.0f},
    View{"leaks", "views/leaks.frag",
         "of the light, shadows aside, the share that leaks through from behind the triangle in R and that "
         "its back "
         "has to keep out in G",
         ViewKind::leak, "1", true, 0.0f},
};

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

void divide(const View& view, float* p) {
    const float nothing = p[3] > 0.0f ? view.without : 0.0f;
    if (view.kind == ViewKind::leak) {
        const float all = p[2];
        p[0] = all > 0.0f ? p[0] / all : nothing;
        p[1] = all > 0.0f ? p[1] / all : nothing;
        p[2] = 0.0f;
    } else {
        std::fill_n(p, 3, p[1] > 0.0f ? p[0] / p[1] : nothing);
    }
}

} // namespace

std::span<const View> all_views() { return views; }

const View* view_named(const std::string& name) {
    const auto found =
        std::ranges::find(views, name, [](const View& view) { return std::string(view.name); });
    return found == views.end() ? nullptr : &*found;
}

image::Image numbers_of(const View& view, const image::Image& film) {
    image::Image numbers = film;
    for (std::size_t i = 0; i < numbers.pixels.size(); i += 4) {
        float* p = &numbers.pixels[i];
        if (view.is_quotient) divide(view, p);
        if (view.kind == ViewKind::luminance) std::fill_n(p, 3, luminance(p[0], p[1], p[2]));
    }
    return numbers;
}

image::Image colors_of(const View& view, const image::Image& numbers) {
    require(view.kind != ViewKind::light, "light is exposed");
    if (view.kind == ViewKind::luminance) return image::luminance_colors(numbers);
    if (view.kind == ViewKind::leak) return three_channels(numbers, leak_color);
    return three_channels(numbers, [](std::span<const float> number, std::span<float> color) {
        std::ranges::transform(number.first(3), color.begin(), image::srgb_encoded);
    });
}

} // namespace sr::cli
