#pragma once
// Depth of the surfaces in the picture, so that marks over it can show what lies behind them.
#include "image/image.hpp"
#include "render/renderer.hpp"
#include "scene/camera.hpp"

#include <memory>
#include <optional>

namespace sr::viewer {

class SceneDepth {
public:
    /// Is told that the view or a shape has changed.
    void restart() { depth_.reset(); }
    /// Renders the depths in a picture of this size if they are not there. Leaves another framebuffer bound.
    /// @throws Error
    void update(const render::GpuScene& scene, const scene::Camera& camera, int width, int height);
    /// True if a surface lies before this point. Never before update(), nor in an orthographic view.
    bool hides(vec3 point) const;

private:
    std::shared_ptr<render::ShaderLibrary> shaders_;
    std::optional<image::Image> depth_; // third channel: along the view axis [m]; 0: no surface
    scene::Camera camera_{};
};

} // namespace sr::viewer
