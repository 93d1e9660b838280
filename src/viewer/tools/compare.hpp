#pragma once
// Comparison tool: a wipe, a difference or a ꟻLIP map between the render and a reference, which is a kept
// render or a file.
#include "viewer/panels/file_dialog.hpp"
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

/// ꟻLIP error of each pixel, in the red channel, 0 to 1, and its mean.
struct FlipMap {
    image::Image film;
    double mean = 0.0;
};

class Compare : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    Changes draw_section() override;
    FilmSum reference_film() const override;
    Activity activity() const override { return flipping_ ? Activity::waiting : Activity::idle; }

private:
    Changes keep_render();
    Changes load(const std::string& file);
    Changes next_mode();
    void begin_flip();
    Changes draw_methods();
    Changes draw_modes();
    Changes set_estimator(render::Estimator estimator);
    Changes set_visibility(render::Visibility visibility);

    FileDialog dialog_;
    std::optional<Reference> flip_; // the map, as a film
    std::optional<std::future<FlipMap>> flipping_;
    std::string flip_result_;
};

} // namespace sr::viewer
