#pragma once
// Bounding volume hierarchy that shaders walk.
#include "shadow/casters.hpp"

namespace sr::shadow {

/// Node of a binary tree in depth-first order. A ray that meets the box continues with the next node, a ray
/// that misses it with node `skip`, so no stack is needed. 32 bytes. Keep in sync with
/// shaders/visibility/bvh.glsl.
struct BvhNode {
    vec3 low{0.0f}; // [m]
    std::int32_t skip = 0;
    vec3 high{0.0f};
    std::int32_t leaf = 0; // 0: no leaf; else 8 * (place of its first triangle) + (how many, 1 to 4)
};
static_assert(sizeof(BvhNode) == 32);

struct Bvh {
    std::vector<BvhNode> nodes;       // never empty; beyond the last is the end
    std::vector<std::uint32_t> order; // the triangles' indices as leaves name them
};

/// Builds the tree with Embree's builder (surface area heuristic). Leaves out triangles with corners that are
/// no numbers or beyond 1.8e18 m. Of two boxes the larger comes first, since any hit will do. With
/// `glass_alone` other surfaces are left out. @throws Error if Embree fails.
Bvh build_bvh(const Casters& casters, bool glass_alone = false);

} // namespace sr::shadow
