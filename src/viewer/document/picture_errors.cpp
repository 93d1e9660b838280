#include "viewer/document/picture_errors.hpp"

#include "compare/compare.hpp"
#include "compare/flip.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

/// @throws Error if their sizes differ
void require_same_size(const image::Image& film, const image::Image& reference) {
    if (film.width == reference.width && film.height == reference.height) return;
    throw Error(fmt::format("the pictures have {}x{} and {}x{} pixels", film.width, film.height,
                            reference.width, reference.height),
                "give the window the size of the reference: --size");
}

/// The first `channels`, under their usual names.
image::Image with_channels(const image::Image& film, int channels) {
    image::Image cut(film.width, film.height, channels);
    const auto count = static_cast<std::size_t>(channels), all = static_cast<std::size_t>(film.channels);
    for (std::size_t i = 0; i < cut.pixels.size(); ++i)
        cut.pixels[i] = film.pixels[i / count * all + i % count];
    return cut;
}

/// The code values that a screen gets, 0 to 1.
image::Image codes_of(const ComparedPicture& picture, const DisplaySettings& display) {
    if (!picture.is_displayed) return image::displayed(picture.film, display.ev100, *display.curve);
    image::Image codes = with_channels(picture.film, 3);
    for (float& value : codes.pixels) value = compare::srgb_encoded_unclamped(value);
    return codes;
}

} // namespace

image::Image with_colors(image::Image film) {
    if (film.channels >= 3) return film;
    image::Image rgb(film.width, film.height, 3);
    for (std::size_t i = 0; i < rgb.pixels.size(); ++i)
        rgb.pixels[i] = film.pixels[i / 3 * static_cast<std::size_t>(film.channels)];
    return rgb;
}

FlipMap flip_map(const ComparedPicture& test, const ComparedPicture& reference,
                 const DisplaySettings& display) {
    require_same_size(test.film, reference.film);
    const float pixels_per_degree = compare::CompareOptions{}.pixels_per_degree;
    const auto light = [&](const ComparedPicture& picture) {
        return picture.is_displayed ? picture.film : compare::screen_light(codes_of(picture, display));
    };
    const compare::Plane plane =
        test.is_displayed || reference.is_displayed
            ? compare::flip(light(test), light(reference), pixels_per_degree)
            : compare::hdr_flip(test.film, reference.film, compare::exposures_for(reference.film),
                                pixels_per_degree);
    FlipMap map{image::Image(test.film.width, test.film.height, 1), compare::mean(plane)};
    std::copy(plane.values.begin(), plane.values.end(), map.film.pixels.begin());
    map.film = with_colors(std::move(map.film));
    return map;
}

compare::Metrics measure_errors(const ComparedPicture& test, const ComparedPicture& reference,
                                const DisplaySettings& display) {
    require_same_size(test.film, reference.film);
    compare::CompareOptions options;
    options.diagnoses = false;
    options.other_layers.emplace();
    if (test.is_displayed || reference.is_displayed) {
        options.encoding = compare::Encoding::display_referred;
        return compare::compare(with_channels(codes_of(test, display), 3),
                                with_channels(codes_of(reference, display), 3), options)
            .metrics;
    }
    const int channels =
        std::min({4, test.film.channels, reference.film.channels}); // with alpha if both have it
    return compare::compare(with_channels(test.film, channels), with_channels(reference.film, channels),
                            options)
        .metrics;
}

} // namespace sr::viewer
