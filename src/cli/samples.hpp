#pragma once
// The bundled scenes, for `samples` and the viewer's first page.
#include "viewer/options.hpp"

#include <vector>

namespace sr::cli {

/// All of them, in the order in which people look at them; none if they are not installed.
std::vector<viewer::SampleScene> sample_scenes();

} // namespace sr::cli
