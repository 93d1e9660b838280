#pragma once
// Origin and end of a shadow ray. Keep in sync with shaders/visibility/origin.glsl.
#include "core/math.hpp"

#include <span>

namespace sr::shadow {

/// What the shader asks: does the emitter's point see x?
struct Query {
    vec3 x{0.0f};             // the point as it was interpolated [m]
    int triangle = 0;         // that it lies on: index among the casters; negative: on a line or point
    vec3 to_emitter{0.0f};    // from x to the emitter's point [m]; wi where the light has no place
    bool is_infinite = false; // it has none
    int light = 0;
};

/// The points origin + t direction for 0 <= t <= end.
struct Ray {
    vec3 origin{0.0f};
    vec3 direction{0.0f}; // not unit where the light has a place: t = 1 is the emitter's point
    float end = 1.0f;
};

/// A ray that does not meet the triangle that it leaves. The point is put into the triangle's plane, where
/// interpolation left it off by rounding, and from there moved along the geometric normal to the side of the
/// emitter by 2^-17 (64 units in the last place) of the triangle's largest coordinate, to which all rounding
/// is proportional. The idea of an offset in such units is Wächter & Binder's (2019, "A Fast and Robust
/// Method for Avoiding Self-Intersection"), who take those of the point itself. A finite ray ends 2^-15 of
/// its length before the emitter's point, so that an emitter that lies in the plane of another surface is not
/// shadowed by it. A point of a line has no plane and moves along the ray.
Ray ray_of(const Query& query, std::span<const vec3, 3> triangle);
Ray ray_from_line(const Query& query);

} // namespace sr::shadow
