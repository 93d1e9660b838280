#include "scene/emitters.hpp"

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

/// All rectangles of a mesh in world space; absent if a triangle is left over.
std::optional<std::vector<RectangleLight>> rectangles_of(const Mesh& mesh, const mat4& world_from_object) {
    // Lamps have few triangles; a sculpture that glows is not made of rectangles, and pairing it would take
    // long.
    constexpr std::size_t most_triangles = 256;
    const std::size_t count = mesh.indices.size() / 3;
    if (count == 0 || count % 2 != 0 || count > most_triangles) return std::nullopt;
    const bool mirrors = glm::determinant(mat3(world_from_object)) < 0.0f;
    std::vector<Triangle> triangles(count);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t corner = mirrors ? 2 - i : i; // keeps the front in front
            triangles[t][i] =
                vec3(world_from_object * vec4(mesh.positions[mesh.indices[3 * t + corner]], 1.0f));
        }
    }
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

} // namespace

Emitters emitters_of(const Scene& scene) {
    Emitters emitters{scene.lights, {}};
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const Material& material = scene.materials[mesh.material];
        if (!material.is_emissive() || material.is_unlit) continue;
        auto rectangles = material.emission_texture.is_present()
                              ? std::nullopt
                              : rectangles_of(mesh, instance.world_from_object);
        if (!rectangles) {
            emitters.seen_only.push_back(instance.name.empty() ? mesh.name : instance.name);
            continue;
        }
        for (RectangleLight& light : *rectangles) {
            light.name = instance.name;
            light.L = material.emission;
            light.is_two_sided = material.is_double_sided;
            emitters.lights.emplace_back(light);
        }
    }
    return emitters;
}

void add_light_surfaces(Scene& scene) {
    for (const Light& any : scene.lights) {
        const auto* light = std::get_if<RectangleLight>(&any);
        if (!light || !light->is_visible) continue;
        Material material;
        material.name = light->name;
        material.base_color = vec4(0.0f, 0.0f, 0.0f, 1.0f);
        material.metallic = 0.0f;
        material.specular = 0.0f;
        material.emission = light->L;
        material.is_double_sided = light->is_two_sided;
        Mesh mesh;
        mesh.name = light->name;
        const vec3 u = light->half_u, v = light->half_v;
        mesh.positions = {light->center - u - v, light->center + u - v, light->center + u + v,
                          light->center - u + v};
        mesh.normals.assign(4, light->normal());
        mesh.indices = {0, 1, 2, 0, 2, 3};
        mesh.material = static_cast<int>(scene.materials.size());
        scene.materials.push_back(material);
        scene.meshes.push_back(mesh);
        scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, mat4(1.0f), light->name});
    }
}

} // namespace sr::scene
