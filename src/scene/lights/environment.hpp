#pragma once
// Light from every direction.
#include "scene/environment.hpp"
#include "scene/lights/emitter.hpp"

#include <memory>

namespace sr::scene {

/// Light from infinitely far, from every direction: the same radiance in all of them, or that of a map.
struct EnvironmentLight {
    static constexpr std::string_view kind = "environment";

    std::string name;
    vec3 L{1.0f};                                // radiance [cd/m²]; with a map: its factor [1]
    std::shared_ptr<const EnvironmentMap> map{}; // null: the same radiance in every direction
    float rotation = 0.0f;          // of the map around +Y, counter-clockwise seen from above [rad]
    bool is_visible = true;         // false: it lights the scene but cameras do not see it
    bool passes_back_faces = false; // see passes_back_faces() in light.hpp

    /// To the map's own axes, from the world.
    mat3 map_from_world() const;
    /// From the unit direction w, in the world [cd/m²].
    vec3 radiance(vec3 w) const { return map ? L * map->radiance(map_from_world() * w) : L; }
    std::optional<double> quantity_from(Quantity quantity, double value) const;
    void transform(const Motion& by);
    /// A direction, with the density of shaders/light/environment.glsl.
    EmitterPoint sample_point(vec3 u) const;
    /// It has none: what comes from above.
    EmitterPoint middle() const;
};

} // namespace sr::scene
