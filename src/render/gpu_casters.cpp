#include "render/gpu_casters.hpp"

#include "render/blocks.hpp"

#include <numeric>

namespace sr::render {
namespace {

using shadow::Caster;
using shadow::Casters;

constexpr std::size_t texels_per_caster = 2;

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
    return texels;
}

/// What w says of a triangle: the texels of its caster and of its alpha corners.
vec2 links_of(const Casters& casters, std::uint32_t triangle) {
    const std::uint32_t index = casters.caster_of[triangle];
    const Caster& caster = casters.casters[index];
    if (caster.is_plain()) return vec2(-1.0f);
    const auto caster_texel = static_cast<float>(index * texels_per_caster);
    if (caster.first_corner < 0) return {caster_texel, -1.0f};
    const std::size_t local = triangle - static_cast<std::uint32_t>(caster.first_triangle);
    const std::size_t first =
        casters.casters.size() * texels_per_caster + static_cast<std::size_t>(caster.first_corner);
    return {caster_texel, static_cast<float>(first + 3 * local)};
}

std::vector<vec4> packed_triangles(const Casters& casters, const shadow::Bvh& bvh) {
    std::vector<vec4> texels;
    texels.reserve(3 * bvh.order.size());
    for (const std::uint32_t triangle : bvh.order) {
        const auto corners = casters.triangle(triangle);
        const vec2 links = links_of(casters, triangle);
        texels.emplace_back(corners[0], links.x);
        texels.emplace_back(corners[1], links.y);
        texels.emplace_back(corners[2], 0.0f);
    }
    return texels;
}

std::vector<std::int32_t> places_of(const Casters& casters, const shadow::Bvh& bvh) {
    std::vector<std::int32_t> places(casters.triangle_count(), -1);
    for (std::size_t place = 0; place < bvh.order.size(); ++place)
        places[bvh.order[place]] = static_cast<std::int32_t>(place);
    return places;
}

shadow::Bvh without_boxes(const Casters& casters) {
    shadow::Bvh bvh;
    bvh.order.resize(casters.triangle_count());
    std::iota(bvh.order.begin(), bvh.order.end(), 0u);
    return bvh;
}

} // namespace

GpuCasters::GpuCasters(const Casters& casters) : GpuCasters(casters, without_boxes(casters)) {}

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
