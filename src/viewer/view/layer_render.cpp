#include "viewer/view/layer_render.hpp"

#include <algorithm>
#include <chrono>

namespace sr::viewer {
namespace {

constexpr int max_samples = 64; // of a picture to try out lights

/// Few samples first, and four times as many in all after each round.
std::vector<int> rounds_of(int samples) {
    std::vector<int> rounds;
    int taken = 0;
    for (int all = 4; taken < samples; all *= 4) {
        rounds.push_back(std::min(all, samples) - taken);
        taken += rounds.back();
    }
    return rounds;
}

float brightness_of(const LightEditor& lights, std::size_t entry) {
    const vec3 quantity = quantity_of(lights.lights_of(entry).front());
    return std::max({quantity.r, quantity.g, quantity.b});
}

} // namespace

LayerRender::LayerRender(SceneView& scene, const render::RenderOptions& options, const scene::Camera& camera)
    : scene_(scene),
      options_(options),
      camera_(camera),
      rounds_(rounds_of(std::min(options.samples, max_samples))),
      layers_(scene.lights().entries().size()) {
    options_.lights = render::LightSampling::all;
    options_.estimates_error = false;
    for (std::size_t i = 0; i < layers_.lights(); ++i)
        brightness_.push_back(brightness_of(scene.lights(), i));
    shaders_ = render::Renderer::programs(options_);
}

/// Lights the scene by one light, or by none.
void LayerRender::begin_layer() {
    LightEditor lights = scene_.lights();
    const std::size_t count = layers_.lights();
    for (std::size_t i = 0; i < count; ++i)
        if (i == layer_)
            lights.set_quantity(i, vec3(brightness_[i]));
        else
            lights.enable(i, false);
    scene_.light_by(std::move(lights));
    render::RenderOptions options = options_;
    options.samples = rounds_[round_];
    options.seed += static_cast<std::uint32_t>(round_);
    renderer_.emplace(scene_.gpu(), camera_, options, shaders_);
    if (layer_ == count) return renderer_->use_lights(0, 0);
    const std::vector<int>& own = scene_.lights().entries()[layer_].lights;
    const auto [first, last] = std::ranges::minmax(own);
    renderer_->use_lights(first, last + 1);
}

bool LayerRender::advance() {
    constexpr auto budget = std::chrono::milliseconds(40);
    constexpr int parts = 12; // of a sample, between which the window can draw
    const auto end = std::chrono::steady_clock::now() + budget;
    while (!is_done() && std::chrono::steady_clock::now() < end) {
        if (!renderer_) begin_layer();
        renderer_->add_rows(1 + options_.height / parts);
        if (renderer_->sample_count() < rounds_[round_]) continue;
        layers_.add(layer_, renderer_->read_film(), rounds_[round_]);
        renderer_.reset();
        if (++layer_ <= layers_.lights()) continue;
        layer_ = 0;
        ++round_;
        return true;
    }
    return false;
}

std::vector<vec3> LayerRender::weights_of(const LightEditor& lights) const {
    std::vector<vec3> weights;
    for (std::size_t i = 0; i < brightness_.size(); ++i)
        weights.push_back(lights.entries()[i].is_enabled
                              ? quantity_of(lights.lights_of(i).front()) / brightness_[i]
                              : vec3(0.0f));
    return weights;
}

} // namespace sr::viewer
