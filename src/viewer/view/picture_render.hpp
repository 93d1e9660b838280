#pragma once
// Render of a picture of any size, in short turns beside the render of the window.
#include "render/adaptive/convergence.hpp"
#include "render/renderer.hpp"

#include <optional>

namespace sr::viewer {

class PictureRender {
public:
    /// `guess`: the time that a sample is expected to take [s]. @throws Error if the driver refuses the size;
    /// ShaderError
    PictureRender(const render::GpuScene& scene, const scene::Camera& camera,
                  const render::RenderOptions& options, const render::StopRule& rule, double guess);

    /// Begins another picture of the same scene and size.
    void look_from(const scene::Camera& camera);
    /// Works for a short while, or for a tenth of a sample where that takes longer. @throws Error
    void advance();
    bool is_done() const { return monitor_.stopped_by().has_value(); }

    int samples() const { return renderer_.sample_count(); }
    /// The samples by their rows: 2.5 after half of the third one.
    double progress() const;
    const render::StopMonitor& monitor() const { return monitor_; }
    int light_choices() const { return renderer_.light_choices(); }
    image::Image read_film() const { return renderer_.read_film(); }

private:
    render::Renderer renderer_;
    render::StopMonitor monitor_;
    double expected_;    // time of a sample [s]
    double spent_ = 0.0; // on the sample at hand [s]
    int rows_ = 0;       // of it that are done
};

} // namespace sr::viewer
