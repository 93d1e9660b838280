#include "scene/emitters.hpp"

#include "scene/transform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace sr::scene {
namespace {

using Triangle = std::array<vec3, 3>;

/// The corner of a triangle at which its edges are perpendicular; absent if there is none.
std::optional<int> right_angle(const Triangle& t) {
    for (int i = 0; i < 3; ++i) {
        const vec3 a = t[(i + 1) % 3] - t[i];
        const vec3 b = t[(i + 2) % 3] - t[i];
        const float lengths = glm::length(a) * glm::length(b);
        if (lengths > 0.0f && std::abs(glm::dot(a, b)) <= 1e-3f * lengths) return i;
    }
    return std::nullopt;
}

bool is_near(vec3 a, vec3 b, float tolerance) { return glm::distance(a, b) <= tolerance; }

/// The rectangle that two triangles make: both have a right angle, they share the hypotenuse, and they face
/// the same way. Counter-clockwise triangles give a rectangle whose front is theirs.
std::optional<RectangleLight> rectangle(const Triangle& a, const Triangle& b) {
    const auto i = right_angle(a);
    const auto j = right_angle(b);
    if (!i || !j) return std::nullopt;
    const vec3 corner = a[*i];
    const vec3 u = a[(*i + 1) % 3] - corner;
    const vec3 v = a[(*i + 2) % 3] - corner;
    const float tolerance = 1e-3f * std::min(glm::length(u), glm::length(v));
    // Going round the same way, b's right angle lies opposite and its next corner is a's last.
    if (!is_near(b[*j], corner + u + v, tolerance) || !is_near(b[(*j + 1) % 3], corner + v, tolerance)
        || !is_near(b[(*j + 2) % 3], corner + u, tolerance))
        return std::nullopt;
    RectangleLight light;
    light.center = corner + 0.5f * (u + v);
    light.half_u = 0.5f * u;
    light.half_v = 0.5f * v;
    return light;
}

/// All triangles in world space with an area; `map` says where a texture is read, null if there is none.
std::vector<MeshLight::Triangle> triangles_of(const Mesh& mesh, const mat4& world_from_object,
                                              const TextureSlot* map) {
    const bool is_mirrored = mirrors(world_from_object);
    std::vector<MeshLight::Triangle> triangles;
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        MeshLight::Triangle triangle{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex =
                mesh.indices[t + (is_mirrored ? 2 - i : i)]; // keeps the front in front
            triangle.corners[i] = vec3(world_from_object * vec4(mesh.positions[vertex], 1.0f));
            if (!map) continue;
            const std::vector<vec2>& uv = mesh.texcoords[map->texcoord];
            if (!uv.empty()) triangle.uv[i] = vec2(map->uv_transform * vec3(uv[vertex], 1.0f));
        }
        const auto& c = triangle.corners;
        const float doubled_area = glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
        if (doubled_area > 0.0f && std::isfinite(doubled_area)) triangles.push_back(triangle);
    }
    return triangles;
}

/// All rectangles of a mesh in world space; absent if a triangle is left over.
std::optional<std::vector<RectangleLight>> rectangles_of(const Mesh& mesh, const mat4& world_from_object) {
    // Lamps have few triangles; a sculpture that glows is not made of rectangles, and pairing it would take
    // long.
    constexpr std::size_t most_triangles = 256;
    const std::size_t count = mesh.indices.size() / 3;
    if (count == 0 || count % 2 != 0 || count > most_triangles) return std::nullopt;
    std::vector<Triangle> triangles;
    for (const MeshLight::Triangle& triangle : triangles_of(mesh, world_from_object, nullptr))
        triangles.push_back(triangle.corners);
    std::vector<RectangleLight> found;
    while (!triangles.empty()) {
        const Triangle first = triangles.back();
        triangles.pop_back();
        bool paired = false;
        for (std::size_t t = 0; t < triangles.size() && !paired; ++t) {
            if (const auto light = rectangle(first, triangles[t])) {
                found.push_back(*light);
                triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(t));
                paired = true;
            }
        }
        if (!paired) return std::nullopt;
    }
    return found;
}

MeshLight mesh_light(const Mesh& mesh, const mat4& world_from_object, const Material& material) {
    MeshLight light;
    const bool is_textured = material.emission_texture.is_present();
    light.triangles =
        triangles_of(mesh, world_from_object, is_textured ? &material.emission_texture : nullptr);
    light.L = material.emission;
    light.is_two_sided = material.is_double_sided;
    light.texture = material.emission_texture.texture;
    return light;
}

void append_emitters_of(const Instance& instance, const Scene& scene, std::vector<Light>& lights) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (!mesh.is_surface() || !material.is_emissive() || material.is_unlit) return;
    const std::string& name = instance.name.empty() ? mesh.name : instance.name;
    auto rectangles = material.emission_texture.is_present()
                          ? std::nullopt
                          : rectangles_of(mesh, instance.world_from_object);
    if (!rectangles) {
        MeshLight light = mesh_light(mesh, instance.world_from_object, material);
        light.name = name;
        if (!light.triangles.empty()) lights.emplace_back(std::move(light));
        return;
    }
    for (RectangleLight& light : *rectangles) {
        light.name = name;
        light.L = material.emission;
        light.is_two_sided = material.is_double_sided;
        lights.emplace_back(std::move(light));
    }
}

} // namespace

std::vector<Light> emitters_of(const Scene& scene) {
    std::vector<Light> lights = scene.lights;
    for (const Instance& instance : scene.instances) append_emitters_of(instance, scene, lights);
    return lights;
}

std::vector<Light> assign_emitters(Scene& scene) {
    std::vector<Light> lights = scene.lights;
    for (Instance& instance : scene.instances) {
        instance.emits_as.first = static_cast<int>(lights.size());
        append_emitters_of(instance, scene, lights);
        instance.emits_as.end = static_cast<int>(lights.size());
    }
    return lights;
}

} // namespace sr::scene
