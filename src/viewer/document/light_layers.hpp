#pragma once
// Pictures of a scene by one light each, and their sum with other quantities. Plain data: no GL.
#include "core/math.hpp"
#include "image/image.hpp"

#include <span>
#include <vector>

namespace sr::viewer {

/// L_o is linear in the lights, so that any mix of them is a sum of their pictures:
///
///   L_o = D + Σ_k w_k (L_k - D)
///
/// D is the picture without lights, L_k the one of light k alone. w_k is the light's quantity over the one it
/// has in its picture, for red, green and blue.
class LightLayers {
public:
    explicit LightLayers(std::size_t lights) : layers_(lights + 1) {}

    std::size_t lights() const { return layers_.size() - 1; }
    /// Adds samples to the picture of a light, or to the one without lights (index lights()). `film`: their
    /// mean.
    void add(std::size_t index, const image::Image& film, int samples);
    /// Samples that all pictures have.
    int samples() const;

    /// The sum with one weight for each light, with three channels. Only if samples() > 0.
    image::Image mix(std::span<const vec3> weights) const;

private:
    struct Layer {
        image::Image mean; // three channels
        int samples = 0;
    };
    std::vector<Layer> layers_; // the last one without lights
};

} // namespace sr::viewer
