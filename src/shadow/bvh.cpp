#include "shadow/bvh.hpp"

#include "core/error.hpp"
#include "shadow/device.hpp"

#include <algorithm>
#include <cmath>
#include <new>

namespace sr::shadow {
namespace {

constexpr unsigned max_leaf_triangles = 4;
constexpr unsigned max_depth = 64;

/// A node as the builder hands it out: two children with their boxes, or a leaf.
struct Built {
    Built* child[2] = {nullptr, nullptr};
    RTCBounds bounds[2] = {};
    std::uint32_t triangles[max_leaf_triangles] = {};
    unsigned count = 0; // of triangles; 0: no leaf
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Built), 16)) Built;
}

void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i)
        static_cast<Built*>(node)->child[i] = static_cast<Built*>(children[i]);
}

void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<Built*>(node)->bounds[i] = *bounds[i];
}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count,
                  void*) {
    auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(Built), 16)) Built;
    leaf->count = static_cast<unsigned>(count);
    for (std::size_t i = 0; i < count; ++i) leaf->triangles[i] = primitives[i].primID;
    return leaf;
}

RTCBounds bounds_of(std::span<const vec3, 3> triangle) {
    const vec3 low = glm::min(triangle[0], glm::min(triangle[1], triangle[2]));
    const vec3 high = glm::max(triangle[0], glm::max(triangle[1], triangle[2]));
    return {low.x, low.y, low.z, 0.0f, high.x, high.y, high.z, 0.0f};
}

/// Numbers that Embree takes: its triangle meshes leave out what is farther than 2^60.6, whose areas would
/// overflow.
bool is_buildable(std::span<const vec3, 3> triangle) {
    constexpr float farthest = 1.844e18f;
    for (const vec3 corner : triangle)
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(corner[i]) < farthest)) return false;
    return true;
}

std::vector<RTCBuildPrimitive> primitives_of(const Casters& casters, bool glass_alone) {
    std::vector<RTCBuildPrimitive> primitives;
    primitives.reserve(casters.triangle_count());
    for (std::size_t i = 0; i < casters.triangle_count(); ++i) {
        const auto triangle = casters.triangle(i);
        if (!is_buildable(triangle)) continue;
        if (glass_alone && casters.casters[casters.caster_of[i]].glass < 0) continue;
        const RTCBounds b = bounds_of(triangle);
        primitives.push_back(
            {b.lower_x, b.lower_y, b.lower_z, 0, b.upper_x, b.upper_y, b.upper_z, static_cast<unsigned>(i)});
    }
    return primitives;
}

RTCBounds together(std::span<const RTCBuildPrimitive> primitives) {
    RTCBounds all{INFINITY, INFINITY, INFINITY, 0.0f, -INFINITY, -INFINITY, -INFINITY, 0.0f};
    for (const RTCBuildPrimitive& p : primitives) {
        all.lower_x = std::min(all.lower_x, p.lower_x);
        all.lower_y = std::min(all.lower_y, p.lower_y);
        all.lower_z = std::min(all.lower_z, p.lower_z);
        all.upper_x = std::max(all.upper_x, p.upper_x);
        all.upper_y = std::max(all.upper_y, p.upper_y);
        all.upper_z = std::max(all.upper_z, p.upper_z);
    }
    return all;
}

float half_area(const RTCBounds& b) {
    const vec3 d(b.upper_x - b.lower_x, b.upper_y - b.lower_y, b.upper_z - b.lower_z);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

void flatten(const Built& node, const RTCBounds& b, Bvh& bvh) {
    const std::size_t index = bvh.nodes.size();
    bvh.nodes.push_back({{b.lower_x, b.lower_y, b.lower_z}, 0, {b.upper_x, b.upper_y, b.upper_z}, 0});
    if (node.count > 0) {
        bvh.nodes[index].leaf = static_cast<std::int32_t>(8 * bvh.order.size() + node.count);
        bvh.order.insert(bvh.order.end(), node.triangles, node.triangles + node.count);
    } else {
        const int first = half_area(node.bounds[0]) >= half_area(node.bounds[1]) ? 0 : 1;
        flatten(*node.child[first], node.bounds[first], bvh);
        flatten(*node.child[1 - first], node.bounds[1 - first], bvh);
    }
    bvh.nodes[index].skip = static_cast<std::int32_t>(bvh.nodes.size());
}

RTCBuildArguments arguments_for(RTCBVH bvh, std::vector<RTCBuildPrimitive>& primitives) {
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = max_depth;
    arguments.maxLeafSize = max_leaf_triangles;
    arguments.bvh = bvh;
    arguments.primitives = primitives.data();
    arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    return arguments;
}

} // namespace

Bvh build_bvh(const Casters& casters, bool glass_alone) {
    std::vector<RTCBuildPrimitive> primitives = primitives_of(casters, glass_alone);
    Bvh result;
    if (primitives.empty()) {
        result.nodes.push_back({vec3(INFINITY), 1, vec3(-INFINITY), 0}); // which nothing meets
        return result;
    }
    const Device device;
    const RTCBounds bounds = together(primitives);
    const RTCBVH bvh = rtcNewBVH(device.handle());
    const RTCBuildArguments arguments = arguments_for(bvh, primitives);
    const auto* root = static_cast<const Built*>(rtcBuildBVH(&arguments));
    if (root) {
        result.order.reserve(primitives.size());
        flatten(*root, bounds, result);
    }
    rtcReleaseBVH(bvh);
    device.require_content();
    require(root, "a builder that does not complain has built");
    return result;
}

} // namespace sr::shadow
