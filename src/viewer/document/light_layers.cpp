#include "viewer/document/light_layers.hpp"

#include "core/error.hpp"

#include <algorithm>

namespace sr::viewer {

void LightLayers::add(std::size_t index, const image::Image& film, int samples) {
    require(film.channels >= 3, "a film has colours");
    Layer& layer = layers_[index];
    if (layer.samples == 0) layer.mean = image::Image(film.width, film.height, 3);
    const float share = static_cast<float>(samples) / static_cast<float>(layer.samples + samples);
    const auto channels = static_cast<std::size_t>(film.channels);
    for (std::size_t i = 0; i < layer.mean.pixels.size(); ++i) {
        float& mean = layer.mean.pixels[i];
        const float sample = film.pixels[i / 3 * channels + i % 3];
        mean = layer.samples == 0 ? sample : mean + share * (sample - mean);
    }
    layer.samples += samples;
}

int LightLayers::samples() const { return std::ranges::min(layers_, {}, &Layer::samples).samples; }

image::Image LightLayers::mix(std::span<const vec3> weights) const {
    require(samples() > 0 && weights.size() == lights(), "each light has a picture and a weight");
    const image::Image& dark = layers_.back().mean;
    image::Image sum = dark;
    for (std::size_t k = 0; k < lights(); ++k) {
        const vec3 w = weights[k];
        if (w == vec3(0.0f)) continue;
        const std::vector<float>& lit = layers_[k].mean.pixels;
        for (std::size_t i = 0; i + 2 < sum.pixels.size(); i += 3)
            for (std::size_t c = 0; c < 3; ++c)
                sum.pixels[i + c] += w[static_cast<int>(c)] * (lit[i + c] - dark.pixels[i + c]);
    }
    return sum;
}

} // namespace sr::viewer
