#pragma once
// Render of the lights of a scene one by one, in rounds, so that all of them are there soon and are refined
// then.
#include "viewer/document/light_layers.hpp"
#include "viewer/view/scene_view.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace sr::viewer {

class LayerRender {
public:
    /// Renders each entry of scene.lights() in white, as bright as its brightest colour, enabled or not.
    /// `options`: of the picture; at most 64 samples are taken. The scene is lit by single lights until
    /// SceneView::relight().
    LayerRender(SceneView& scene, const render::RenderOptions& options, const scene::Camera& camera);

    /// Works for a short while. @return true if all lights have more samples than before. @throws Error,
    /// ShaderError
    bool advance();
    bool is_done() const { return round_ == rounds_.size(); }

    const LightLayers& layers() const { return layers_; }
    /// Weights of the layers for the quantities that `lights` has now.
    std::vector<vec3> weights_of(const LightEditor& lights) const;
    /// Pictures that are complete in this round, and their number.
    std::pair<std::size_t, std::size_t> progress() const { return {layer_, layers_.lights() + 1}; }

private:
    void begin_layer();

    SceneView& scene_;
    render::RenderOptions options_;
    scene::Camera camera_;
    std::vector<int> rounds_;       // samples of each
    std::vector<float> brightness_; // of each light in its picture
    LightLayers layers_;
    std::shared_ptr<render::ShaderLibrary> shaders_;
    std::optional<render::Renderer> renderer_; // of the layer at hand
    std::size_t round_ = 0;
    std::size_t layer_ = 0;
};

} // namespace sr::viewer
