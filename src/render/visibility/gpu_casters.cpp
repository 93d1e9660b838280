#include "render/visibility/gpu_casters.hpp"

#include "render/gpu/blocks.hpp"

#include <numeric>

namespace sr::render {
namespace {

using shadow::Caster;
using shadow::Casters;

constexpr std::size_t texels_per_caster = 2;
constexpr std::size_t texels_per_alpha_corner = 1;
constexpr std::size_t texels_per_glass = 7;
constexpr std::size_t texels_per_glass_corner = 3;

// First texels of the parts of the casters' data, which shaders/interface/casters.glsl describes.
std::size_t first_alpha_corner(const Casters& casters) { return casters.casters.size() * texels_per_caster; }
std::size_t first_glass(const Casters& casters) {
    return first_alpha_corner(casters) + casters.alpha_corners.size() * texels_per_alpha_corner;
}
std::size_t first_glass_corner(const Casters& casters) {
    return first_glass(casters) + casters.glass.size() * texels_per_glass;
}

vec4 packed_map(const Casters& casters, int index) {
    if (index < 0) return vec4(0.0f);
    const shadow::AlphaMap& map = casters.alpha_maps[static_cast<std::size_t>(index)];
    return vec4(map.first, map.width, map.height,
                static_cast<int>(map.wrap_u) + 4 * static_cast<int>(map.wrap_v));
}

void append_glass(const Casters& casters, std::vector<vec4>& texels) {
    for (const shadow::Glass& g : casters.glass) {
        texels.emplace_back(g.transmission, g.metallic, g.F0, g.specular);
        texels.emplace_back(g.optical_depth, g.clearcoat);
        texels.emplace_back(g.front, g.is_body ? 1.0f : 0.0f, 0.0f, 0.0f);
        for (const int map : {g.base_map, g.transmission_map, g.thickness_map, g.metallic_map})
            texels.push_back(packed_map(casters, map));
    }
    for (const shadow::GlassCorner& corner : casters.glass_corners) {
        texels.emplace_back(corner.uv[0], corner.uv[1]);
        texels.emplace_back(corner.uv[2], corner.uv[3]);
        texels.push_back(corner.color);
    }
}

std::vector<vec4> packed_data(const Casters& casters) {
    std::vector<vec4> texels;
    for (const Caster& caster : casters.casters) {
        const bool has_map = caster.alpha_map >= 0;
        const shadow::AlphaMap map =
            has_map ? casters.alpha_maps[static_cast<std::size_t>(caster.alpha_map)] : shadow::AlphaMap{};
        const int modes = static_cast<int>(caster.alpha_mode) + 4 * static_cast<int>(map.wrap_u)
                          + 16 * static_cast<int>(map.wrap_v)
                          + 64
                                * (caster.front == 0.0f  ? 0
                                   : caster.front > 0.0f ? 1
                                                         : 2);
        texels.emplace_back(caster.emits_as.first, caster.emits_as.end, caster.own_share, modes);
        texels.emplace_back(caster.alpha_cutoff, map.first, map.width, map.height);
    }
    for (const shadow::AlphaCorner& corner : casters.alpha_corners)
        texels.emplace_back(corner.uv, corner.alpha, 0.0f);
    append_glass(casters, texels);
    return texels;
}

/// Returns the w components of a triangle's corners: the first texels of its caster, corners and glass.
vec3 links_of(const Casters& casters, std::uint32_t triangle) {
    const std::uint32_t index = casters.caster_of[triangle];
    const Caster& caster = casters.casters[index];
    if (caster.is_plain()) return vec3(-1.0f);
    const auto caster_texel = static_cast<float>(index * texels_per_caster);
    if (caster.first_corner < 0) return {caster_texel, -1.0f, 0.0f};
    const std::size_t local = triangle - static_cast<std::uint32_t>(caster.first_triangle);
    const std::size_t corner = static_cast<std::size_t>(caster.first_corner) + 3 * local;
    if (caster.glass < 0)
        return {caster_texel, first_alpha_corner(casters) + corner * texels_per_alpha_corner, 0.0f};
    return {caster_texel, first_glass_corner(casters) + corner * texels_per_glass_corner,
            first_glass(casters) + static_cast<std::size_t>(caster.glass) * texels_per_glass};
}

std::vector<vec4> packed_triangles(const Casters& casters, const shadow::Bvh& bvh) {
    std::vector<vec4> texels;
    texels.reserve(3 * bvh.order.size());
    for (const std::uint32_t triangle : bvh.order) {
        const auto corners = casters.triangle(triangle);
        const vec3 links = links_of(casters, triangle);
        texels.emplace_back(corners[0], links.x);
        texels.emplace_back(corners[1], links.y);
        texels.emplace_back(corners[2], links.z);
    }
    return texels;
}

std::vector<std::int32_t> places_of(const Casters& casters, const shadow::Bvh& bvh) {
    std::vector<std::int32_t> places(casters.triangle_count(), -1);
    for (std::size_t place = 0; place < bvh.order.size(); ++place)
        places[bvh.order[place]] = static_cast<std::int32_t>(place);
    return places;
}

/// All triangles in their own order, and behind them once more those of glass, in the only boxes.
shadow::Bvh boxes_of_glass(const Casters& casters) {
    const std::size_t count = casters.triangle_count();
    shadow::Bvh bvh;
    bvh.order.resize(count);
    std::iota(bvh.order.begin(), bvh.order.end(), 0u);
    if (!casters.is_tinted()) return bvh;
    const shadow::Bvh glass = shadow::build_bvh(casters, true);
    bvh.order.insert(bvh.order.end(), glass.order.begin(), glass.order.end());
    bvh.nodes = glass.nodes;
    for (shadow::BvhNode& node : bvh.nodes)
        if (node.leaf != 0) node.leaf += static_cast<std::int32_t>(8 * count);
    return bvh;
}

} // namespace

GpuCasters::GpuCasters(const Casters& casters) : GpuCasters(casters, boxes_of_glass(casters)) {}

GpuCasters::GpuCasters(const Casters& casters, const shadow::Bvh& bvh) {
    constexpr auto what_to_do = "render with --visibility none, or simplify the scene";
    nodes_.upload(bvh.nodes, what_to_do);
    triangles_.upload(packed_triangles(casters, bvh), what_to_do);
    places_.upload(places_of(casters, bvh), what_to_do);
    data_.upload(packed_data(casters), what_to_do);
    alphas_.upload(casters.alpha_texels, what_to_do);
}

void GpuCasters::bind() const {
    GLuint unit = first_caster_unit;
    for (const BufferTexture* texture : {&nodes_, &triangles_, &places_, &data_, &alphas_})
        texture->bind(unit++);
}

} // namespace sr::render
