#pragma once
// What a selected light is taken by: arrows that move it, rings that turn it, squares that pull one of its
// sizes.
#include "scene/lights/light.hpp"
#include "viewer/grip.hpp"

namespace sr::viewer {

struct Handle {
    Verb verb{};
    int axis = 0; // of the world; of scaling the number of the extent
};

struct Handles {
    std::vector<Arrow> arrows;               // none for what is nowhere
    std::array<std::vector<vec2>, 3> rings;  // the half of each that faces the eye, in the window
    std::vector<std::pair<vec2, int>> sizes; // where the squares are, and of which extent
};

/// Those of a light around `center`; `moves`: whether it is somewhere. `scale`: of a HiDPI screen. None
/// behind the eye.
Handles handles_of(const std::vector<scene::LightSize>& extents, vec3 center, bool moves,
                   const Projection& projection, float scale);

/// The one that the pointer is on; absent: none.
std::optional<Handle> handle_under(vec2 pointer, const Handles& handles);

/// Draws them behind the panels; `held` the thickest.
void draw(const Handles& handles, const std::optional<Handle>& held, float scale);

/// What is done, beside the pointer.
void draw_words(const std::string& words, vec2 pointer, float scale);

} // namespace sr::viewer
