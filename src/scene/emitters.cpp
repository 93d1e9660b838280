#include "scene/emitters.hpp"

namespace sr::scene {
EmissiveSurfaces emissive_surfaces(const Scene&) { return {}; }
} // namespace sr::scene
