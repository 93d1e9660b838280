#pragma once
// Our own measurement of a truth scene.
#include "truth/comparison.hpp"

#include <string_view>

namespace sr::truth {

/// Renders a scene of scenes.hpp by `sampled`, each pixel from 16 × 256 samples: the picture is drawn four
/// times larger, which gives the same box-filtered pixels in a sixteenth of the frames. Needs the tests' GL
/// context.
Measured rendered(std::string_view shape, std::string_view material, std::string_view view);

/// The same of a ball of ball_scenes.hpp, each pixel from 4 × 64 samples, its own shadow included.
Measured rendered_ball(std::string_view brdf, std::string_view light);
Measured stored_ball(std::string_view brdf, std::string_view light);

/// The stored reference: one part of tests/truth/references/SHAPE.VIEW.exr. @throws Error if there is none.
Measured stored(std::string_view shape, std::string_view material, std::string_view view);

} // namespace sr::truth
