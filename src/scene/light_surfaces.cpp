#include "scene/light_surfaces.hpp"

#include <cmath>

namespace sr::scene {
namespace {

// A chord of 1/128 of a turn leaves the circle by 1 - cos(π/128) = 0.03 % of the radius.
constexpr int around = 128;
constexpr int quarter_rings = 32; // of a hemisphere

vec2 on_circle(int i) {
    const float angle = 2.0f * pi * static_cast<float>(i % around) / static_cast<float>(around);
    return {std::cos(angle), std::sin(angle)};
}

/// Flat outlines are fans around their first corner.
Mesh fan(const std::vector<vec3>& corners, vec3 normal) {
    Mesh mesh;
    mesh.positions = corners;
    mesh.normals.assign(corners.size(), normal);
    for (std::uint32_t i = 2; i < corners.size(); ++i) mesh.indices.insert(mesh.indices.end(), {0, i - 1, i});
    return mesh;
}

/// The uv of the points center + s*half_u + t*half_v, for each of the (s, t).
void map_onto(Mesh& mesh, const EmissionMap& map, const std::vector<vec2>& st) {
    if (!map.is_present()) return;
    for (const vec2 p : st) mesh.texcoords[0].push_back(map.origin + p.x * map.along_u + p.y * map.along_v);
}

template<class Flat>
Mesh flat(const Flat& light, const std::vector<vec2>& st) {
    std::vector<vec3> corners;
    for (const vec2 p : st) corners.push_back(light.center + p.x * light.half_u + p.y * light.half_v);
    Mesh mesh = fan(corners, light.normal());
    map_onto(mesh, light.map, st);
    return mesh;
}

Mesh surface_of(const RectangleLight& light) {
    return flat(light, {{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}});
}

Mesh surface_of(const DiskLight& light) {
    std::vector<vec2> st;
    for (int i = 0; i < around; ++i) st.push_back(on_circle(i));
    return flat(light, st);
}

Mesh surface_of(const PolygonLight& light) { return fan(light.corners, light.normal()); }

/// Rings of latitude around `pole`, those of the far half shifted by `half_axis`, those of the near by its
/// opposite.
Mesh capsule(vec3 center, vec3 half_axis, vec3 pole, float radius) {
    const vec3 slanted = std::abs(pole.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 u = glm::normalize(glm::cross(slanted, pole));
    const vec3 v = glm::cross(pole, u);
    Mesh mesh;
    const auto ring = [&](int latitude, vec3 middle) {
        const float angle = 0.5f * pi * static_cast<float>(latitude) / static_cast<float>(quarter_rings);
        for (int i = 0; i < around; ++i) {
            const vec2 c = on_circle(i);
            const vec3 n = std::cos(angle) * (c.x * u + c.y * v) + std::sin(angle) * pole;
            mesh.normals.push_back(n);
            mesh.positions.push_back(middle + radius * n);
        }
    };
    for (int latitude = -quarter_rings; latitude <= 0; ++latitude) ring(latitude, center - half_axis);
    for (int latitude = 0; latitude <= quarter_rings; ++latitude) ring(latitude, center + half_axis);
    const auto rings = static_cast<int>(mesh.positions.size()) / around;
    for (int r = 0; r + 1 < rings; ++r) {
        for (int i = 0; i < around; ++i) {
            const auto at = [&](int row, int column) {
                return static_cast<std::uint32_t>(row * around + column % around);
            };
            mesh.indices.insert(mesh.indices.end(), {at(r, i), at(r, i + 1), at(r + 1, i + 1)});
            mesh.indices.insert(mesh.indices.end(), {at(r, i), at(r + 1, i + 1), at(r + 1, i)});
        }
    }
    return mesh;
}

Mesh sphere(vec3 center, float radius) { return capsule(center, vec3(0.0f), vec3(0, 1, 0), radius); }

Mesh surface_of(const SphereLight& light) { return sphere(light.center, light.radius); }
Mesh surface_of(const TubeLight& light) {
    const float length = glm::length(light.half_axis);
    return capsule(light.center, light.half_axis, length > 0.0f ? light.half_axis / length : vec3(0, 1, 0),
                   light.radius);
}

/// What a light looks like: a mesh, what it emits, and whether on both sides.
struct Looks {
    Mesh mesh;
    vec3 L{0.0f};
    bool is_two_sided = false;
    int texture = -1;
};

void append(Scene& scene, const std::string& name, Looks looks) {
    Material material;
    material.name = name;
    material.base_color = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    material.metallic = 0.0f;
    material.specular = 0.0f;
    material.emission = looks.L;
    material.emission_texture.texture = looks.texture;
    material.is_double_sided = looks.is_two_sided;
    looks.mesh.name = name;
    looks.mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(looks.mesh));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, mat4(1.0f), name});
}

template<class Flat>
void append_flat(Scene& scene, const Flat& light, int texture) {
    if (light.is_visible)
        append(scene, light.name, {surface_of(light), light.L, light.is_two_sided, texture});
}

struct Append {
    Scene& scene;

    void operator()(const PointLight& light) const {
        if (!light.is_visible || !(light.radius > 0.0f) || light.profile >= 0) return;
        append(scene, light.name,
               {sphere(light.position, light.radius), light.I / (pi * light.radius * light.radius)});
    }
    void operator()(const SpotLight&) const {} // its radiance, as a profile's, depends on the direction
    void operator()(const DirectionalLight&) const {}
    void operator()(const EnvironmentLight&) const {} // seen behind everything, not as a surface
    void operator()(const MeshLight&) const {}        // its surface is the mesh that it came from
    void operator()(const RectangleLight& light) const { append_flat(scene, light, light.map.texture); }
    void operator()(const DiskLight& light) const { append_flat(scene, light, light.map.texture); }
    void operator()(const PolygonLight& light) const { append_flat(scene, light, -1); }
    void operator()(const SphereLight& light) const {
        if (light.is_visible) append(scene, light.name, {surface_of(light), light.L});
    }
    void operator()(const TubeLight& light) const {
        if (light.is_visible) append(scene, light.name, {surface_of(light), light.L});
    }
};

} // namespace

int add_light_surfaces(Scene& scene) {
    const std::size_t before = scene.instances.size();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::size_t first = scene.instances.size();
        std::visit(Append{scene}, scene.lights[i]);
        for (std::size_t s = first; s < scene.instances.size(); ++s)
            scene.instances[s].emits_as = {static_cast<int>(i), static_cast<int>(i) + 1};
    }
    return static_cast<int>(scene.instances.size() - before);
}

} // namespace sr::scene
