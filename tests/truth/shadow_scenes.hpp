#pragma once
// The scenes of the truth tests in which something stands in the light. Shared by the tests and by
// truth_export, which hands the same scenes to Mitsuba.
#include "scene/scene.hpp"

#include <array>
#include <string_view>

namespace sr::truth {

/// Three bundled scenes, and three that are made here: bars cut by an alpha mask under a disk, boxes under an
/// emissive octahedron, a luminous ball that lies on the floor beside a pillar.
inline constexpr std::array<std::string_view, 6> shadow_scenes{"cornell", "veach", "zoo",
                                                               "fence",   "mesh",  "ball"};

/// Edge of their square pictures [pixels].
inline constexpr int shadow_picture_size = 256;

struct ShadowScene {
    scene::Scene scene; // without the surfaces of its lights
    scene::Camera camera;
};

/// How the fence is made: by a texture's alpha, or, for programs whose shadow rays do not read one, by as
/// many boards of the same outline.
enum class Fence { masked, boards };

/// `name` is of the list above.
ShadowScene shadow_scene(std::string_view name, Fence fence = Fence::masked);

} // namespace sr::truth
