#include "viewer/extents.hpp"

#include "core/error.hpp"

#include <cmath>

namespace sr::viewer {
namespace {

/// Semi-axes of one length, but for rounding.
bool is_circle(const scene::DiskLight& disk) {
    const float u = glm::length(disk.half_u), v = glm::length(disk.half_v);
    return std::abs(u - v) <= 1e-5f * u;
}

std::vector<Extent> sides(vec3 half_u, vec3 half_v) {
    return {{"width", 2.0f * glm::length(half_u), half_u}, {"height", 2.0f * glm::length(half_v), half_v}};
}

void stretch(vec3& half, float by) { half *= by; }

} // namespace

std::vector<Extent> extents_of(const scene::Light& light) {
    if (const auto* flat = std::get_if<scene::RectangleLight>(&light))
        return sides(flat->half_u, flat->half_v);
    if (const auto* disk = std::get_if<scene::DiskLight>(&light)) {
        if (!is_circle(*disk)) return sides(disk->half_u, disk->half_v);
        return {{"radius", glm::length(disk->half_u), disk->half_u}};
    }
    if (const auto* tube = std::get_if<scene::TubeLight>(&light))
        return {{"length", 2.0f * glm::length(tube->half_axis), tube->half_axis}, {"radius", tube->radius}};
    if (const auto* sphere = std::get_if<scene::SphereLight>(&light)) return {{"radius", sphere->radius}};
    const float radius = std::visit(
        [](const auto& l) {
            if constexpr (requires { l.position; }) return l.radius;
            return 0.0f;
        },
        light);
    if (radius > 0.0f) return {{"radius", radius}};
    return {};
}

bool has_size(const scene::Light& light) {
    return !extents_of(light).empty() || std::holds_alternative<scene::PolygonLight>(light)
           || std::holds_alternative<scene::MeshLight>(light);
}

void set_size(scene::Light& light, std::size_t extent, float size) {
    const std::vector<Extent> extents = extents_of(light);
    require(extent < extents.size() && size > 0.0f, "the light has the extent, and keeps it");
    const float by = size / extents[extent].size;
    std::visit(
        [&](auto& l) {
            if constexpr (requires { l.half_u; }) {
                if (extent == 0) stretch(l.half_u, by);
                if (extent == 1 || extents.size() == 1) stretch(l.half_v, by);
            } else if constexpr (requires { l.half_axis; }) {
                if (extent == 0)
                    stretch(l.half_axis, by);
                else
                    l.radius = size;
            } else if constexpr (requires { l.radius; }) {
                l.radius = size;
            }
        },
        light);
}

} // namespace sr::viewer
