#include "render/gpu/light_table.hpp"

#include "core/math.hpp"
#include "render/gpu/light_texels.hpp"
#include "render/gpu/light_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace sr::render {
namespace {

using Texels = std::array<vec4, texels_per_light>;

float inverse_range(float range) { return std::isfinite(range) ? std::min(1.0f / range, 1e30f) : 0.0f; }

/// Keeps products of a quantity within float range, whatever the file states: L and E end where
/// shaders/light/light_sample.glsl bounds a sample, I at 1e30 cd.
vec3 in_range(vec3 quantity, float max) { return glm::min(quantity, vec3(max)); }
constexpr float max_light = 1e15f, max_intensity = 1e30f;

template<class L>
Texels blank(vec3 position, const L& light, vec3 quantity) {
    Texels t{};
    t[0] = vec4(position, scene::light_kind<L>());
    if constexpr (requires { light.I; })
        t[2] = vec4(in_range(quantity, max_intensity), 0.0f);
    else
        t[2] = vec4(in_range(quantity, max_light), 0.0f);
    t[3].w = 1.0f; // no cone: saturate(cos * 0 + 1)
    t[5].w = -1.0f;
    t[6].x = -1.0f;
    return t;
}

/// Packs lights one by one; what they point to collects behind.
class Packer {
public:
    /// `first`: the texel of the table that the payload begins at.
    Packer(const scene::Scene& scene, EmissionMaps& maps, EnvironmentTexels& environments, std::size_t first)
        : scene_(scene), maps_(maps), environments_(environments), first_(first) {}

    Texels operator()(const scene::PointLight& light) {
        Texels t = round(blank(light.position, light, light.I), light.radius);
        t[1].w = inverse_range(light.range);
        if (light.profile < 0) return t;
        t[5].w = static_cast<float>(place_of_profile(light.profile));
        t[1] = vec4(-light.world_from_profile[1], t[1].w);
        t[3] = vec4(light.world_from_profile[0], t[3].w);
        t[4] = vec4(light.world_from_profile[2], 0.0f);
        return t;
    }

    Texels operator()(const scene::SpotLight& light) {
        Texels t = round(blank(light.position, light, light.I), light.radius);
        t[1] = vec4(light.direction, inverse_range(light.range));
        const scene::ConeFalloff cone = light.falloff();
        t[2].w = cone.scale;
        t[3].w = cone.offset;
        return t;
    }

    Texels operator()(const scene::DirectionalLight& light) {
        Texels t = blank(vec3(0.0f), light, light.E);
        t[1] = vec4(light.direction, 0.0f);
        t[5].x = light.angular_radius;
        return t;
    }

    Texels operator()(const scene::RectangleLight& light) { return flat(light); }
    Texels operator()(const scene::DiskLight& light) { return flat(light); }

    Texels operator()(const scene::SphereLight& light) {
        Texels t = blank(light.center, light, light.L);
        t[5].x = light.radius;
        return t;
    }

    Texels operator()(const scene::TubeLight& light) {
        Texels t = blank(light.center, light, light.L);
        t[3] = vec4(light.half_axis, t[3].w);
        t[5].x = light.radius;
        return t;
    }

    Texels operator()(const scene::PolygonLight& light) {
        Texels t = blank(light.center(), light, light.L);
        t[1] = vec4(light.normal(), 0.0f);
        t[4].w = light.is_two_sided ? 1.0f : 0.0f;
        t[5].y = static_cast<float>(end());
        t[5].z = static_cast<float>(light.corners.size());
        for (const vec3 corner : light.corners) payload_.emplace_back(corner, 0.0f);
        return t;
    }

    Texels operator()(const scene::MeshLight& light) {
        Texels t =
            blank(light.triangles.empty() ? vec3(0.0f) : light.triangles[0].corners[0], light, light.L);
        t[4].w = light.is_two_sided ? 1.0f : 0.0f;
        if (light.texture >= 0) t[6].x = static_cast<float>(place_of_map(light.texture));
        t[5].y = static_cast<float>(end());
        t[5].z = static_cast<float>(light.triangles.size());
        append_triangles(light);
        return t;
    }

    Texels operator()(const scene::EnvironmentLight& light) {
        const bool is_dark = light.map && !light.map->has_light();
        Texels t = blank(vec3(0.0f), light, is_dark ? vec3(0.0f) : light.L);
        if (!light.map || is_dark) return t;
        t[1] = vec4(std::cos(light.rotation), std::sin(light.rotation), 0.0f, 0.0f);
        t[3] = vec4(light.map->width(), light.map->height(), 0.0f, t[3].w);
        t[5].y = static_cast<float>(environments_.add(light.map));
        t[5].z = 1.0f;
        return t;
    }

    const std::vector<vec4>& payload() const { return payload_; }

private:
    std::size_t end() const { return first_ + payload_.size(); }

    /// A point or spot with a radius is a sphere of radiance I / (π radius²).
    static Texels round(Texels t, float radius) {
        if (!(radius > 0.0f)) return t;
        t[0].w = static_cast<float>(scene::light_kind<scene::SphereLight>());
        t[2] = vec4(in_range(vec3(t[2]) / std::max(pi * radius * radius, 1e-38f), max_light), t[2].w);
        t[5].x = radius;
        return t;
    }

    template<class Flat>
    Texels flat(const Flat& light) {
        Texels t = blank(light.center, light, light.L);
        t[1] = vec4(light.normal(), 0.0f);
        t[3] = vec4(light.half_u, t[3].w);
        t[4] = vec4(light.half_v, light.is_two_sided ? 1.0f : 0.0f);
        if (!light.map.is_present()) return t;
        t[6] = vec4(place_of_map(light.map.texture), light.map.origin, 0.0f);
        t[7] = vec4(light.map.along_u, light.map.along_v);
        return t;
    }

    /// Five texels a triangle: corners with alias table, then texture coordinates.
    void append_triangles(const scene::MeshLight& light) {
        std::vector<double> power;
        float brightest = 0.0f;
        for (const auto& triangle : light.triangles) {
            const vec3 color =
                light.texture >= 0 ? maps_.mean(scene_, light.texture, triangle.uv) : vec3(1.0f);
            power.push_back(luminance(color));
            brightest = std::max(brightest, luminance(color));
        }
        // 64 points may miss what shines in a dark triangle: none may be left out altogether.
        for (std::size_t i = 0; i < power.size(); ++i) {
            const auto& c = light.triangles[i].corners;
            const double area =
                0.5 * glm::length(glm::cross(glm::dvec3(c[1] - c[0]), glm::dvec3(c[2] - c[0])));
            power[i] = area * std::max(power[i], 0.01 * brightest + 1e-6);
        }
        const std::vector<AliasEntry> table = alias_table(power);
        for (std::size_t i = 0; i < power.size(); ++i) {
            const auto& [corners, uv] = light.triangles[i];
            payload_.emplace_back(corners[0], table[i].keep);
            payload_.emplace_back(corners[1], static_cast<float>(table[i].alias));
            payload_.emplace_back(corners[2], table[i].probability);
            payload_.emplace_back(uv[0], uv[1]);
            payload_.emplace_back(uv[2], 0.0f, 0.0f);
        }
    }

    /// An emission map: its size and its wrap modes, then the blocks of its cells one a texel.
    std::size_t place_of_map(int texture) {
        const auto [entry, is_new] = maps_placed_.try_emplace(texture, end());
        if (is_new) {
            const EmissionMapPlace& place = maps_.add(scene_, texture);
            payload_.emplace_back(place.width, place.height, place.wrap, 0.0f);
            for (const int block : place.blocks) payload_.emplace_back(block, 0.0f, 0.0f, 0.0f);
        }
        return entry->second;
    }

    /// A profile: (γ count, φ count), the angles one a texel, then the columns of intensities.
    std::size_t place_of_profile(int index) {
        const auto [entry, is_new] = profiles_placed_.try_emplace(index, end());
        if (!is_new) return entry->second;
        const scene::LightProfile& profile = scene_.profiles[static_cast<std::size_t>(index)];
        payload_.emplace_back(profile.gamma.size(), profile.phi.size(), 0.0f, 0.0f);
        for (const float angle : profile.gamma) payload_.emplace_back(angle, 0.0f, 0.0f, 0.0f);
        for (const float angle : profile.phi) payload_.emplace_back(angle, 0.0f, 0.0f, 0.0f);
        for (const float I : profile.I) payload_.emplace_back(I, 0.0f, 0.0f, 0.0f);
        return entry->second;
    }

    const scene::Scene& scene_;
    EmissionMaps& maps_;
    EnvironmentTexels& environments_;
    std::size_t first_;
    std::vector<vec4> payload_;
    std::map<int, std::size_t> maps_placed_;
    std::map<int, std::size_t> profiles_placed_;
};

} // namespace

// Triangles of equal areas make shares of 1 but for the rounding of their corners, some 1e-6. All of them
// count as full, so that the table, and with it every sample, stays the same when a scene is moved or scaled.
// The error of a triangle's probability is below 1e-5.
constexpr double full_share = 1.0 - 1e-5;

std::vector<AliasEntry> alias_table(std::span<const double> weights) {
    const std::size_t count = weights.size();
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<AliasEntry> table(count);
    std::vector<double> share(count, 1.0); // of the mean
    std::vector<std::size_t> small, large;
    for (std::size_t i = 0; i < count; ++i) {
        if (total > 0.0) share[i] = weights[i] / total * static_cast<double>(count);
        table[i].probability = static_cast<float>(share[i] / static_cast<double>(count));
        table[i].alias = static_cast<int>(i);
        (share[i] < full_share ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const std::size_t needy = small.back(), rich = large.back();
        small.pop_back();
        table[needy].keep = static_cast<float>(share[needy]);
        table[needy].alias = static_cast<int>(rich);
        share[rich] -= 1.0 - share[needy];
        if (share[rich] < full_share) {
            large.pop_back();
            small.push_back(rich);
        }
    }
    return table; // what is left over is full but for rounding, and keeps its share
}

namespace {

/// Appends the first light of each kind, and the next one of its kind after each light:
/// shaders/interface/lights.glsl. `kinds`: of the lights, as the shaders number them.
void append_lists_of_kinds(std::span<const std::size_t> kinds, std::vector<vec4>& table) {
    constexpr float none = 1 << 30;
    std::array<float, scene::light_kind_count> first;
    first.fill(none);
    std::vector<float> next(kinds.size());
    for (std::size_t k = kinds.size(); k-- > 0;)
        next[k] = std::exchange(first[kinds[k]], static_cast<float>(k));
    for (const float k : first) table.emplace_back(k, 0.0f, 0.0f, 0.0f);
    for (const float k : next) table.emplace_back(k, 0.0f, 0.0f, 0.0f);
}

} // namespace

std::vector<vec4> pack_lights(const scene::Scene& scene, std::span<const scene::Light> lights,
                              EmissionMaps& maps, EnvironmentTexels& environments) {
    maps.rewind();
    const std::vector<LightNode> tree = build_light_tree(scene, lights);
    const std::vector<vec4> tree_texels = pack_light_tree(tree);
    const std::size_t first_of_tree = lights.size() * texels_per_light;
    std::vector<float> leaf(lights.size(), -1.0f);
    for (std::size_t i = 0; i < tree.size(); ++i)
        if (tree[i].is_leaf()) leaf[static_cast<std::size_t>(tree[i].light)] = static_cast<float>(i);
    Packer packer(scene, maps, environments, first_of_tree + tree_texels.size());
    std::vector<vec4> table;
    std::vector<std::size_t> kinds;
    table.reserve(first_of_tree + tree_texels.size());
    for (std::size_t k = 0; k < lights.size(); ++k) {
        Texels texels = std::visit([&](const auto& any) { return packer(any); }, lights[k]);
        if (passes_back_faces(lights[k])) texels[4].w += 2.0f; // beside 1 for two sides
        texels[6].w = leaf[k];
        kinds.push_back(static_cast<std::size_t>(texels[0].w));
        table.insert(table.end(), texels.begin(), texels.end());
    }
    table.insert(table.end(), tree_texels.begin(), tree_texels.end());
    table.insert(table.end(), packer.payload().begin(), packer.payload().end());
    const std::size_t lists = table.size();
    append_lists_of_kinds(kinds, table);
    table.emplace_back(static_cast<float>(first_of_tree), tree.size(), lists, 0.0f);
    return table;
}

} // namespace sr::render
