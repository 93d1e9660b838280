#pragma once
// V on the CPU: shadow rays, traced by Embree.
#include "core/math.hpp"
#include "shadow/casters.hpp"

#include <memory>
#include <span>

namespace sr::shadow {

// Origin and end of a shadow ray. Keep in sync with shaders/visibility/origin.glsl.

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

/// The casters as Embree traces them.
class Occlusion {
public:
    static constexpr std::size_t packet = 8; // rays that are traced at once: those of AVX

    /// Builds Embree's tree. `casters` must outlive this. @throws Error if Embree fails.
    explicit Occlusion(const Casters& casters);
    ~Occlusion();

    /// V of each query, for red, green and blue: 1 where nothing stands between x and the emitter's point, 0
    /// where something does, and the product of what transparent surfaces let through. For any number of
    /// threads at once.
    void answer(std::span<const Query> queries, std::span<vec3> V) const;

private:
    struct Tree;
    const Casters& casters_;
    std::unique_ptr<Tree> tree_;
};

} // namespace sr::shadow
