#include "output/denoise.hpp"

#include "render/shadow_filter.hpp"

#include <algorithm>

namespace sr::output {
namespace {

/// The scene without shadows, under the lights [0, lights), with the samples that the picture has.
image::Image without_shadows(const AovSource& source, int lights, const std::stop_token& stop) {
    render::RenderOptions options = source.options;
    options.has_shadows = false;
    render::Renderer renderer(source.scene, source.camera, options);
    renderer.use_lights(0, lights);
    const int samples = std::ranges::max(source.samples);
    do {
        renderer.add_sample();
        glFinish();
    } while (renderer.sample_count() < samples && !stop.stop_requested());
    return renderer.film();
}

render::Guides guides_of(const AovSource& source, const std::stop_token& stop) {
    std::vector<Plane> planes =
        aov_planes({aov_named("normal"), aov_named("depth"), aov_named("object")}, source, stop);
    if (planes.empty()) return {};
    image::Image normals(source.options.width, source.options.height, 3);
    for (std::size_t i = 0; i < normals.pixels.size(); ++i) normals.pixels[i] = planes[i % 3].values[i / 3];
    return {std::move(normals), std::move(planes[3].values), std::move(planes[4].values)};
}

/// V of each pixel, and in A the variance that its halves show; negative where no light would arrive.
image::Image ratio_of(const image::Image& film, const image::Image& first_half, const image::Image& dark,
                      const image::Image& bright) {
    image::Image ratio(film.width, film.height, 4);
    for (std::size_t i = 0; i < film.pixels.size(); i += 4) {
        float variance = 0.0f, divisors = 0.0f;
        for (std::size_t c = i; c < i + 3; ++c) {
            const float L_r = bright.pixels[c] - dark.pixels[c];
            ratio.pixels[c] = L_r > 0.0f ? (film.pixels[c] - dark.pixels[c]) / L_r : 1.0f;
            if (!(L_r > 0.0f)) continue;
            const float off = (first_half.pixels[c] - film.pixels[c]) / L_r;
            variance += off * off;
            divisors += 1.0f;
        }
        ratio.pixels[i + 3] = divisors > 0.0f ? variance / divisors : -1.0f;
    }
    return ratio;
}

} // namespace

image::Image denoised(const render::Renderer& renderer, const AovSource& source,
                      const std::stop_token& stop) {
    image::Image film = renderer.film();
    const image::Image dark = without_shadows(source, 0, stop);
    const image::Image bright = without_shadows(source, source.scene.light_count(), stop);
    const render::Guides guides = guides_of(source, stop);
    if (stop.stop_requested()) return film;
    const image::Image V =
        render::filtered_ratio(ratio_of(film, renderer.first_half(), dark, bright), guides);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const float L_r = bright.pixels[i] - dark.pixels[i];
        if (i % 4 != 3 && L_r > 0.0f) film.pixels[i] = dark.pixels[i] + L_r * V.pixels[i];
    }
    return film;
}

} // namespace sr::output
