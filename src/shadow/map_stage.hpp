#pragma once
// Contents of the depth maps: the lights, and for each light the surfaces that it reaches.
#include "shadow/casters.hpp"
#include "shadow/map_view.hpp"

namespace sr::shadow {

struct MapStage {
    std::vector<scene::Light> lights;
    std::vector<Ball> casters;   // around each caster
    Ball all;                    // around all of them
    std::vector<Ball> receivers; // around what each light shines on: surfaces that reflect, but its own
};

/// `casters` are those of the scene under these lights.
MapStage map_stage_of(const scene::Scene& scene, std::span<const scene::Light> lights,
                      const Casters& casters);

/// Returns whether the caster can stand in the way of that light; the only surface of a flat or convex
/// emitter cannot stand in its own.
bool stands_in_light(const Caster& caster, int light);

/// Returns whether it is drawn into the maps of that light. Glass is not: it has a colour, which rays tell.
bool is_in_maps(const Caster& caster, int light);

} // namespace sr::shadow
