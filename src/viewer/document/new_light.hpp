#pragma once
// New lights of every kind that a file can get, as large and as bright as suits the scene.
#include "core/math.hpp"
#include "scene/lights/light.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace sr::viewer {

/// A kind of light that can be added, and the letter that chooses it.
struct NewLightKind {
    std::string_view kind; // as light_kind_names() has it
    char key;
};
inline constexpr std::array<NewLightKind, 7> new_light_kinds{{{"point", 'P'},
                                                              {"spot", 'S'},
                                                              {"directional", 'D'},
                                                              {"rectangle", 'R'},
                                                              {"disk", 'K'},
                                                              {"sphere", 'H'},
                                                              {"tube", 'T'}}};

/// Where a new light is, and what it shall do.
struct NewLightPlace {
    vec3 at{0.0f};     // [m]
    vec3 target{0.0f}; // that it shines on [m]
    float size = 1.0f; // of an area light, from edge to edge [m]
    float E = 100.0f;  // at the target, on a surface that faces the light [lx]
};

/// A light of a kind of new_light_kinds. What is small beside its distance makes E at the target.
scene::Light new_light(std::string_view kind, const NewLightPlace& place);

/// A copy of a light beside it, with another name; absent for a light that a file cannot get
/// (gltf::is_addable()).
std::optional<scene::Light> duplicate_of(const scene::Light& light, float offset);

} // namespace sr::viewer
