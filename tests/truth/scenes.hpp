#pragma once
// The scenes of the truth tests: a receiver of one material under one emitter, which nothing shadows, from
// one view. Shared by the tests and by truth_export, which hands the same scenes to Mitsuba.
#include "scene/scene.hpp"

#include <array>
#include <string_view>

namespace sr::truth {

/// Kinds of emitters. A mesh is emissive triangles of an instance, the sun a directional light with an
/// angular radius; all others are what they are called.
inline constexpr std::array<std::string_view, 10> shapes{
    "rectangle", "disk", "sphere", "tube", "polygon", "mesh", "textured_rectangle", "sun", "spot", "profile"};

/// Lambert, glTF's metals of roughness 0.1 to 1, its dielectric of roughness 0.4, and one that reads every
/// texture.
inline constexpr std::array<std::string_view, 8> materials{"lambert", "ggx_01", "ggx_03",     "ggx_05",
                                                           "ggx_07",  "ggx_10", "dielectric", "textured"};

/// A metal with an sRGB-encoded base colour and a normal map of 8 bits, both enlarged: what software GL would
/// filter in 8 bits. Under a rectangle alone.
inline constexpr std::string_view photograph = "photograph";

/// Angles between the normal and the viewer: 0 to 30° and 75 to 85° (perspective), 60° (orthographic).
inline constexpr std::array<std::string_view, 3> views{"steep", "middle", "grazing"};

/// Edge of the square picture that references hold of each material [pixels].
inline constexpr int cell_size = 16;

/// The instance 0 is the receiver; further ones are emissive. `shape`, `material` and `view` are of the lists
/// above; the emitter stands where the mirrored view sees it, so that every lobe's peak is in the picture.
scene::Scene scene_of(std::string_view shape, std::string_view material, std::string_view view);

scene::Camera camera_of(std::string_view view);

/// Adds an irregular octahedron of 0.4 m, along the orthonormal `axes`, as an instance that emits.
void add_octahedron(scene::Scene& scene, vec3 center, const mat3& axes);

} // namespace sr::truth
