#include "shadow/casters.hpp"

#include "core/error.hpp"
#include "scene/transform.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace sr::shadow {
namespace {

using scene::AlphaMode;

/// Collects the casters of a scene instance by instance.
class Collector {
public:
    Collector(const scene::Scene& scene, std::span<const scene::Light> lights)
        : scene_(scene), lights_(lights) {
        for (const scene::Light& light : lights)
            all_.passes_back_faces.push_back(scene::passes_back_faces(light));
        has_passing_lights_ = std::ranges::find(all_.passes_back_faces, true) != all_.passes_back_faces.end();
    }

    void append(const scene::Instance& instance) {
        const scene::Mesh& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
        const scene::Material& material = scene_.materials[static_cast<std::size_t>(mesh.material)];
        Caster caster;
        caster.emits_as = clipped(instance.emits_as);
        caster.own_share = own_share(caster.emits_as);
        caster.alpha_mode = material.alpha_mode;
        caster.alpha_cutoff = scene::min_opaque_alpha(material);
        if (has_passing_lights_ && !material.is_double_sided && !material.is_transmissive())
            caster.front = scene::mirrors(instance.world_from_object) ? -1.0f : 1.0f;
        caster.first_triangle = static_cast<int>(all_.caster_of.size());
        if (material.is_transmissive()) {
            caster.first_corner = static_cast<int>(all_.glass_corners.size());
            caster.glass = static_cast<int>(all_.glass.size());
            append_glass(instance, mesh, material);
        } else if (material.alpha_mode != AlphaMode::opaque) {
            caster.first_corner = static_cast<int>(all_.alpha_corners.size());
            caster.alpha_map = map_of(material.base_color_texture.texture, Planes::alpha);
            append_alpha(mesh, material);
        }
        // Triangles are counted, so those of a hidden instance shrink to a point instead of leaving.
        for (const std::uint32_t index : mesh.indices)
            all_.corners.push_back(
                vec3(instance.world_from_object
                     * vec4(mesh.positions[instance.is_hidden ? mesh.indices.front() : index], 1.0f)));
        all_.caster_of.resize(all_.corners.size() / 3, static_cast<std::uint32_t>(all_.casters.size()));
        all_.casters.push_back(caster);
    }

    Casters take() { return std::move(all_); }

private:
    /// Where a renderer is given other lights than the RenderScene's, none is a surface of the scene.
    scene::LightRange clipped(scene::LightRange range) const {
        return range.end <= static_cast<int>(lights_.size()) ? range : scene::LightRange{};
    }

    float own_share(scene::LightRange range) const {
        if (range.is_empty()) return 0.0f;
        const scene::Light& first = lights_[static_cast<std::size_t>(range.first)];
        const bool is_alone =
            range.end - range.first == 1 && !std::holds_alternative<scene::MeshLight>(first);
        return is_alone ? whole_ray : last_thousandth;
    }

    /// The planes that are read from a texture: a channel, or the colours and alpha of one that is
    /// sRGB-encoded.
    enum class Planes { red, green, blue, alpha, colors };

    int map_of(int texture, Planes planes) {
        if (texture < 0) return -1;
        const auto [entry, is_new] =
            maps_.try_emplace({texture, planes}, static_cast<int>(all_.alpha_maps.size()));
        if (!is_new) return entry->second;
        const scene::Texture& source = scene_.textures[static_cast<std::size_t>(texture)];
        const scene::TextureImage& image = scene_.images[static_cast<std::size_t>(source.image)];
        all_.alpha_maps.push_back({static_cast<int>(all_.alpha_texels.size()), image.width, image.height,
                                   source.sampler.wrap_u, source.sampler.wrap_v});
        const auto append = [&](std::size_t channel, bool is_srgb) {
            const std::vector<std::uint16_t> texels = channel_of(image, channel, is_srgb);
            all_.alpha_texels.insert(all_.alpha_texels.end(), texels.begin(), texels.end());
        };
        if (planes == Planes::colors)
            for (std::size_t channel = 0; channel < 4; ++channel) append(channel, channel < 3);
        else
            append(static_cast<std::size_t>(planes), false);
        return entry->second;
    }

    void append_glass(const scene::Instance& instance, const scene::Mesh& mesh, const scene::Material& m) {
        const mat4& world = instance.world_from_object;
        const float r = (m.ior - 1.0f) / (m.ior + 1.0f);
        const vec3 F0 = glm::min((m.ior == 0.0f ? 1.0f : r * r) * m.specular_color, vec3(1.0f));
        Glass glass;
        glass.transmission = m.transmission;
        glass.metallic = m.metallic;
        glass.F0 = std::max({F0.x, F0.y, F0.z});
        glass.specular = m.specular;
        glass.clearcoat = m.clearcoat;
        glass.optical_depth = scene::attenuation_coefficient(m) * (m.thickness * scene::length_scale(world));
        glass.front = scene::mirrors(world) ? -1.0f : 1.0f;
        glass.is_body = scene::is_body_of_glass(mesh, m);
        const std::array slots{&m.base_color_texture, &m.transmission_texture, &m.thickness_texture,
                               &m.metallic_roughness_texture};
        glass.base_map = map_of(slots[0]->texture, Planes::colors);
        glass.transmission_map = map_of(slots[1]->texture, Planes::red);
        glass.thickness_map = map_of(slots[2]->texture, Planes::green);
        glass.metallic_map = map_of(slots[3]->texture, Planes::blue);
        all_.glass.push_back(glass);
        for (const std::uint32_t index : mesh.indices) {
            GlassCorner corner;
            for (std::size_t i = 0; i < slots.size(); ++i) {
                const std::vector<vec2>& uv = mesh.texcoords[slots[i]->texcoord];
                corner.uv[i] = vec2(slots[i]->uv_transform * vec3(uv.empty() ? vec2(0.0f) : uv[index], 1.0f));
            }
            corner.color = m.base_color * (mesh.colors.empty() ? vec4(1.0f) : mesh.colors[index]);
            all_.glass_corners.push_back(corner);
        }
    }

    void append_alpha(const scene::Mesh& mesh, const scene::Material& material) {
        const scene::TextureSlot& slot = material.base_color_texture;
        const std::vector<vec2>& uv = mesh.texcoords[slot.texcoord];
        for (const std::uint32_t index : mesh.indices) {
            AlphaCorner corner;
            corner.uv = vec2(slot.uv_transform * vec3(uv.empty() ? vec2(0.0f) : uv[index], 1.0f));
            corner.alpha = material.base_color.w * (mesh.colors.empty() ? 1.0f : mesh.colors[index].w);
            all_.alpha_corners.push_back(corner);
        }
    }

    const scene::Scene& scene_;
    std::span<const scene::Light> lights_;
    Casters all_;
    std::map<std::pair<int, Planes>, int> maps_; // by texture
    bool has_passing_lights_ = false;
};

} // namespace

Casters collect_casters(const scene::Scene& scene, std::span<const scene::Light> lights) {
    constexpr std::size_t max_triangles = std::size_t{1} << 24; // shaders count triangles in floats
    const std::size_t count = scene::triangle_count(scene);
    if (count > max_triangles)
        throw Error(fmt::format("{} triangles, shadows are for {} at most", count, max_triangles),
                    "simplify the scene, or render with --visibility none");
    Collector collector(scene, lights);
    for (const scene::Instance& instance : scene.instances) collector.append(instance);
    return collector.take();
}

namespace {

/// Returns the transmittance of a surface of this alpha whose material transmits T.
vec3 with_alpha(const Caster& caster, float alpha, vec3 T) {
    if (caster.alpha_mode == AlphaMode::opaque) return T;
    if (caster.alpha_mode == AlphaMode::mask) return alpha < caster.alpha_cutoff ? vec3(1.0f) : T;
    return glm::mix(vec3(1.0f), T, std::clamp(alpha, 0.0f, 1.0f));
}

vec3 through_glass(const Casters& casters, const Caster& caster, std::uint32_t triangle, std::size_t corner,
                   vec3 weights, vec3 w) {
    const Glass& glass = casters.glass[static_cast<std::size_t>(caster.glass)];
    const std::span<const GlassCorner, 3> corners(&casters.glass_corners[corner], 3);
    const GlassPoint point = glass_at(glass, corners, weights, casters.alpha_maps, casters.alpha_texels);
    const auto p = casters.triangle(triangle);
    const vec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    return with_alpha(caster, point.alpha, straight_transmittance(glass, point, n, w));
}

} // namespace

bool is_passed_from_behind(const Casters& casters, std::uint32_t triangle, int light, vec3 ray_direction) {
    const float front = casters.casters[casters.caster_of[triangle]].front;
    if (front == 0.0f || !casters.passes_back_faces[static_cast<std::size_t>(light)]) return false;
    const auto corners = casters.triangle(triangle);
    return front * glm::dot(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), ray_direction)
           < 0.0f;
}

vec3 transmittance(const Casters& casters, std::uint32_t triangle, float u, float v, vec3 direction) {
    const Caster& caster = casters.casters[casters.caster_of[triangle]];
    if (caster.first_corner < 0) return vec3(0.0f);
    const std::size_t local = triangle - static_cast<std::uint32_t>(caster.first_triangle);
    const std::size_t first = static_cast<std::size_t>(caster.first_corner) + 3 * local;
    const float w = 1.0f - u - v;
    if (caster.glass >= 0) return through_glass(casters, caster, triangle, first, {w, u, v}, direction);
    const AlphaCorner* corner = &casters.alpha_corners[first];
    float alpha = w * corner[0].alpha + u * corner[1].alpha + v * corner[2].alpha;
    if (caster.alpha_map >= 0) {
        const vec2 uv = w * corner[0].uv + u * corner[1].uv + v * corner[2].uv;
        alpha *= map_alpha(casters.alpha_maps[static_cast<std::size_t>(caster.alpha_map)],
                           casters.alpha_texels, uv);
    }
    if (caster.alpha_mode == AlphaMode::mask) return vec3(alpha < caster.alpha_cutoff ? 1.0f : 0.0f);
    return vec3(1.0f - std::clamp(alpha, 0.0f, 1.0f));
}

} // namespace sr::shadow
