#pragma once
// Probe panel: the equation at a pixel as the table of `steradian probe`, and the BRDF lobe there.
#include "render/probe.hpp"
#include "viewer/document/light_selection.hpp"
#include "viewer/panels/lobe.hpp"
#include "viewer/ui.hpp"
#include "viewer/view/projection.hpp"

#include <array>

namespace sr::viewer {

/// Terms of the equation at a pixel.
struct ProbeResult {
    render::PixelTerms terms;
    std::optional<render::PixelTerms> reference; // at the same pixel, by the reference of an assignment
    std::optional<Lobe> lobe;                    // absent where nothing reflects
    int column = 0;
    int row = 0;
    int height = 0; // of the picture
    int samples = 0;
    std::array<bool, 4> has{}; // kinds of terms that are known, by render::Probing::Kind
    bool is_complete = false;  // false: the terms are being refined
};

/// Lobe in the scene, and as a curve in the plane of incidence.
class LobePanel {
public:
    /// Draws the settings and the curve in the current window. `hovered`: the light whose row is under the
    /// pointer, or -1.
    void draw(const Lobe& lobe, int hovered, float scale);

    /// Draws the lobe around x with a constant size on the screen; of a mirror an arrow.
    void draw_in_scene(const Lobe& lobe, vec3 x, const Projection& projection, float scale) const;

private:
    bool is_shown_ = true;
    LobeSettings settings_;
};

class ProbePanel {
public:
    std::optional<ProbeResult>& result;

    explicit ProbePanel(std::optional<ProbeResult>& probed) : result(probed) {}

    /// Draws the table below the picture, if there is a result. A click on a row selects its light in
    /// `selected`.
    void draw(const scene::RenderScene& stage, const LightEditor& lights, LightSelection& selected,
              Layout& layout, const Ui& ui);

    /// Draws n, wo, the mean wi of every light and the lobe at x.
    void draw_directions(const scene::RenderScene& stage, const Projection& projection, float scale) const;

private:
    void place_floating();
    static void draw_head(const Ui& ui, bool& is_open);
    void draw_terms(const scene::RenderScene& stage, const LightEditor& lights, LightSelection& selected);
    void draw_table(const scene::RenderScene& stage, const LightEditor& lights, LightSelection& selected);
    void draw_row(int light, const scene::RenderScene& stage, const LightEditor& lights,
                  LightSelection& selected);

    LobePanel lobe_;
    int hovered_ = -1;
    vec2 size_{700.0f, 300.0f}; // at the last frame
    float table_width_ = 0.0f;  // that its columns want
    bool is_placed_ = false;
    int frames_to_place_ = 0; // a new window learns its size by being drawn
};

} // namespace sr::viewer
