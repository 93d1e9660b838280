#pragma once
// The lobe at the pixel that was asked: in the scene, and as a curve in the plane of incidence.
#include "viewer/gizmo.hpp"
#include "viewer/lobe.hpp"

namespace sr::viewer {

class LobePanel {
public:
    /// The choices and the curve, in the current window. `hovered`: the light whose row the pointer is on, or
    /// -1.
    void draw(const Lobe& lobe, int hovered, float scale);

    /// The lobe around x, as large on the screen wherever x is; of a mirror an arrow.
    void draw_in_scene(const Lobe& lobe, vec3 x, const Projection& projection, float scale) const;

private:
    bool is_shown_ = true;
    LobeLook look_;
};

} // namespace sr::viewer
