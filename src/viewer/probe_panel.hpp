#pragma once
// The equation at a pixel: the table of `steradian probe`, and its directions in the scene.
#include "render/probe.hpp"
#include "viewer/document/light_edits.hpp"
#include "viewer/gizmo.hpp"
#include "viewer/lobe_panel.hpp"

namespace sr::viewer {

/// What a pixel answered.
struct Answer {
    render::PixelTerms terms;
    std::optional<render::PixelTerms> reference; // of an assignment, at the same pixel
    std::optional<Lobe> lobe;                    // absent where nothing reflects
    int column = 0;
    int row = 0;
    int height = 0; // of the picture
    int samples = 0;
};

class ProbePanel {
public:
    std::optional<Answer> answer;

    /// Draws the table, if there is an answer. A row that is clicked selects its lamp in `selected`.
    void draw(const scene::Stage& stage, const LightEditor& lighting, std::optional<std::size_t>& selected,
              float scale);

    /// Draws n, wo, every light's mean wi and the lobe from x, the row's under the pointer thick.
    void draw_directions(const scene::Stage& stage, const Projection& projection, float scale) const;

private:
    void draw_row(int light, const scene::Stage& stage, const LightEditor& lighting,
                  std::optional<std::size_t>& selected);

    LobePanel lobe_;
    int hovered_ = -1;
};

} // namespace sr::viewer
