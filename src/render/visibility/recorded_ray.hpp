#pragma once
// Shadow rays as shaders write them down for the CPU.
#include "shadow/occlusion.hpp"

#include <cmath>

namespace sr::render {

/// Rows [first, first + count) of the picture, counted from its lower edge.
struct RowRange {
    int first = 0;
    int count = 0;
};

/// The rays that the CPU traced, and its time for them.
struct TracedRays {
    std::size_t count = 0;
    double seconds = 0.0;
};

/// A ray as shaders/visibility/named_ray.glsl states it.
struct RecordedRay {
    vec4 named{0.0f};

    bool is_finite() const { return std::isfinite(named.x + named.y + named.z); }
    /// Returns what the name counts, from 0.
    int number() const { return static_cast<int>(std::abs(named.w)) - 1; }

    /// `x`: the receiver [m]; `triangle`: that it lies on.
    shadow::Query query(vec3 x, int triangle, int light) const {
        return {x, triangle, vec3(named), named.w < 0.0f, light};
    }
};

} // namespace sr::render
