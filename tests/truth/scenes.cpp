#include "truth/scenes.hpp"

#include "core/error.hpp"
#include "truth/textures.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::truth {
namespace {

constexpr vec3 L{10.0f, 8.0f, 5.0f}; // radiance of every emitter [cd/m²]

struct View {
    float angle;    // between the normal and the central ray [rad]
    float yfov;     // full angle of the picture [rad]; 0: orthographic
    float distance; // from the picture's centre on the receiver to the camera [m]
    float light;    // … and to the emitter's centre [m]
};

View view_named(std::string_view name) {
    constexpr float degree = pi / 180.0f;
    if (name == "steep") return {15.0f * degree, 24.0f * degree, 2.0f, 1.5f}; // corners: 30°
    if (name == "middle") return {60.0f * degree, 0.0f, 2.0f, 1.5f};
    require(name == "grazing", "the view is one of the list");
    return {80.0f * degree, 9.9f * degree, 1.5f, 2.0f};
}

/// Axes of an emitter whose picture in a mirror the camera sees: where it is, and its own frame. It faces the
/// picture's centre, roughly: turned by 20° about its own axis and 15° aside.
struct Place {
    vec3 center;
    vec3 u, v, n; // orthonormal
};

Place place_in(const View& view) {
    const vec3 towards(0.0f, std::cos(view.angle), -std::sin(view.angle));
    mat4 turn(1.0f);
    turn = glm::rotate(turn, 15.0f * pi / 180.0f, glm::cross(vec3(1, 0, 0), towards));
    turn = glm::rotate(turn, 20.0f * pi / 180.0f, towards);
    const vec3 n = mat3(turn) * -towards;
    const vec3 u = mat3(turn) * vec3(1, 0, 0);
    return {view.light * towards, u, glm::cross(n, u), n};
}

scene::Material material_named(std::string_view name) {
    scene::Material material;
    material.name = name;
    if (name.starts_with("ggx_")) {
        material.base_color = vec4(0.95f, 0.64f, 0.54f, 1.0f); // copper
        material.roughness = 0.1f * static_cast<float>(10 * (name[4] - '0') + (name[5] - '0'));
        return material;
    }
    require(name == "lambert" || name == "dielectric" || name == "textured" || name == photograph,
            "the material is one of the list");
    material.base_color = vec4(0.8f, 0.5f, 0.3f, 1.0f);
    material.metallic = 0.0f;
    material.roughness = 0.4f;
    material.specular = name == "lambert" ? 0.0f : 1.0f;
    return material;
}

scene::Mesh receiver() {
    scene::Mesh mesh;
    mesh.name = "receiver";
    constexpr float e = 5.0f; // [m]
    mesh.positions = {{-e, 0, e}, {e, 0, e}, {e, 0, -e}, {-e, 0, -e}};
    mesh.normals.assign(4, vec3(0, 1, 0));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A luminaire whose uneven beam of 1 rad across ends within the picture.
void add_profile(scene::Scene& scene, const Place& p) {
    scene::LightProfile profile{"beam", {0.0f, 0.02f, 0.05f, 0.1f, 0.2f, 0.25f}, {}, {}};
    for (int column = 0; column <= 8; ++column) {
        profile.phi.push_back(2.0f * pi * static_cast<float>(column) / 8.0f);
        for (int row = 0; row < 6; ++row)
            profile.I.push_back(10.0f + static_cast<float>((row * 7 + (column % 8) * 5) % 11));
    }
    scene.profiles.push_back(profile);
    scene::PointLight light{"", p.center, 0.1f * L};
    light.profile = 0;
    const vec3 y = glm::normalize(p.center); // away from the picture
    const vec3 x = glm::normalize(glm::cross(y, p.v));
    light.world_from_profile = mat3(x, y, glm::cross(x, y));
    scene.lights.push_back(light);
}

void add_emitter(scene::Scene& scene, std::string_view shape, const Place& p) {
    if (shape == "sun") {
        scene.lights.push_back(scene::DirectionalLight{"", -glm::normalize(p.center), L, 0.15f});
    } else if (shape == "spot") { // the cone's edge and the range's window are in every picture
        scene.lights.push_back(
            scene::SpotLight{"", p.center, glm::normalize(-p.center), L, 3.0f, 0.05f, 0.25f});
    } else if (shape == "profile") {
        add_profile(scene, p);
    } else if (shape == "rectangle") {
        scene.lights.push_back(
            scene::RectangleLight{"", p.center, 0.40f * p.u, 0.25f * p.v, L, false, false, {}});
    } else if (shape == "textured_rectangle") {
        scene::RectangleLight light{"", p.center, 0.40f * p.u, 0.35f * p.v, L, false, false, {}};
        light.map.texture = add_pattern(scene, scene::ColorSpace::srgb, {});
        scene.lights.push_back(light);
    } else if (shape == "disk") {
        scene.lights.push_back(scene::DiskLight{"", p.center, 0.35f * p.u, 0.35f * p.v, L, false, false, {}});
    } else if (shape == "sphere") {
        scene.lights.push_back(scene::SphereLight{"", p.center, 0.30f, L, false});
    } else if (shape == "tube") {
        scene.lights.push_back(scene::TubeLight{"", p.center, 0.45f * p.u, 0.08f, L, false});
    } else if (shape == "polygon") {
        std::vector<vec3> corners;
        for (const vec2 st :
             {vec2(0.45f, 0.0f), vec2(0.2f, 0.35f), vec2(-0.3f, 0.3f), vec2(-0.4f, -0.1f), vec2(0.1f, -0.3f)})
            corners.push_back(p.center + st.x * p.u + st.y * p.v);
        scene.lights.push_back(scene::PolygonLight{"", corners, L, false, false});
    } else {
        require(shape == "mesh", "the shape is one of the list");
        add_octahedron(scene, p.center, mat3(p.u, p.v, p.n));
    }
}

} // namespace

void add_octahedron(scene::Scene& scene, vec3 center, const mat3& axes) {
    scene::Material material;
    material.name = "emissive";
    material.base_color = vec4(0, 0, 0, 1);
    material.emission = L;
    scene::Mesh mesh;
    mesh.name = "octahedron";
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    const std::array<vec3, 6> tips{0.40f * axes[0],  -0.30f * axes[0], 0.25f * axes[1],
                                   -0.35f * axes[1], 0.20f * axes[2],  -0.30f * axes[2]};
    for (const std::uint32_t a : {0u, 1u})
        for (const std::uint32_t b : {2u, 3u})
            for (const std::uint32_t c : {4u, 5u}) {
                const bool is_turned = (a + (b - 2) + (c - 4)) % 2 == 1; // keeps the front outside
                for (const std::uint32_t tip : {a, is_turned ? c : b, is_turned ? b : c}) {
                    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
                    mesh.positions.push_back(center + tips[tip]);
                }
                const std::size_t first = mesh.positions.size() - 3;
                const vec3 normal =
                    glm::normalize(glm::cross(mesh.positions[first + 1] - mesh.positions[first],
                                              mesh.positions[first + 2] - mesh.positions[first]));
                mesh.normals.insert(mesh.normals.end(), 3, normal);
            }
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), mat4(1.0f), "octahedron"});
    scene.meshes.push_back(mesh);
}

scene::Scene scene_of(std::string_view shape, std::string_view material, std::string_view view) {
    scene::Scene scene;
    scene.materials.push_back(material_named(material));
    scene.meshes.push_back(receiver());
    scene.instances.push_back({0, mat4(1.0f), "receiver"});
    if (material == "textured") add_textures(scene);
    if (material == photograph) add_photograph(scene);
    add_emitter(scene, shape, place_in(view_named(view)));
    return scene;
}

scene::Camera camera_of(std::string_view name) {
    const View view = view_named(name);
    const vec3 wo(0.0f, std::cos(view.angle), std::sin(view.angle));
    scene::Camera camera;
    camera.name = name;
    camera.world_from_camera = glm::inverse(glm::lookAt(view.distance * wo, vec3(0.0f), vec3(0, 0, -1)));
    if (view.yfov > 0.0f)
        camera.projection = scene::Perspective{view.yfov, std::nullopt, 0.01f, 100.0f};
    else
        camera.projection = scene::Orthographic{0.35f, 0.35f, 0.01f, 100.0f};
    return camera;
}

} // namespace sr::truth
