#include "truth/ball_scenes.hpp"

#include "core/error.hpp"
#include "scene/conductor.hpp"
#include "truth/textures.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::truth {
namespace {

constexpr int meridians = 64, parallels = 32;

scene::Mesh ball() {
    scene::Mesh mesh;
    mesh.name = "ball";
    for (int i = 0; i <= parallels; ++i)
        for (int j = 0; j <= meridians; ++j) {
            const vec2 uv(static_cast<float>(j) / meridians, static_cast<float>(i) / parallels);
            const float theta = pi * uv.y, phi = 2.0f * pi * uv.x;
            const vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            mesh.positions.push_back(0.5f * n);
            mesh.normals.push_back(n);
            mesh.tangents.emplace_back(std::cos(phi), 0.0f, -std::sin(phi), 1.0f);
            mesh.texcoords[0].push_back(vec2(2.0f, 1.0f) * uv);
        }
    for (int i = 0; i < parallels; ++i)
        for (int j = 0; j < meridians; ++j) {
            const auto a = static_cast<std::uint32_t>(i * (meridians + 1) + j), b = a + meridians + 1;
            if (i + 1 < parallels) mesh.indices.insert(mesh.indices.end(), {a, b, b + 1});
            if (i > 0) mesh.indices.insert(mesh.indices.end(), {a, b + 1, a + 1});
        }
    return mesh;
}

/// A coloured, turned environment of few texels, with black ones and one that is much brighter than the
/// others.
scene::EnvironmentLight sky() {
    constexpr int width = 16, height = 9;
    std::vector<vec3> texels;
    for (int i = 0; i < width * height; ++i)
        texels.push_back(i % 7 == 3 ? vec3(0.0f)
                                    : 0.2f * vec3(1 + i % 5, 1 + i % 3, 2 + i / width)
                                          / static_cast<float>(1 + i % 2));
    texels[3 * width + 1] = vec3(12.0f, 10.0f, 6.0f);
    scene::EnvironmentLight light;
    light.map = std::make_shared<const scene::EnvironmentMap>(width, height, std::move(texels));
    light.rotation = 0.4f;
    light.is_visible = false;
    return light;
}

/// Returns the base material of models and layers: copper of roughness 0.45.
scene::Material metal() {
    scene::Material m;
    m.base_color = vec4(0.95f, 0.64f, 0.54f, 1.0f);
    m.roughness = 0.45f;
    return m;
}

/// A dielectric.
scene::Material clay() {
    scene::Material m = metal();
    m.base_color = vec4(0.6f, 0.3f, 0.15f, 1.0f);
    m.metallic = 0.0f;
    return m;
}

scene::Material of_model(scene::Material material, scene::Model model) {
    material.model = model;
    return material;
}

scene::Material model_named(std::string_view name) {
    using enum scene::Model;
    if (name == "lambert") return of_model(clay(), lambert);
    scene::Material m = of_model(clay(), *scene::model_named(name == "brushed" ? "ggx" : name));
    if (name == "oren_nayar") m.roughness = 0.8f;
    if (name == "phong" || name == "blinn_phong") {
        m.exponent = name == "phong" ? 25.0f : 90.0f;
        m.specular_color = vec3(0.3f, 0.35f, 0.4f);
    }
    if (name == "brushed") {
        m.roughness = 0.65f;
        m.roughness_across = 0.3f;
    }
    if (name == "conductor") {
        m.base_color = vec4(1.0f);
        m.conductor = scene::fit_ior(*scene::measured_metal("gold"));
    }
    if (name == "merl") m.measured = 0;
    return m;
}

void add_anisotropy(scene::Material& m, float degrees) {
    m.roughness = 0.35f;
    m.anisotropy = 0.75f;
    m.anisotropy_rotation = degrees * pi / 180.0f;
}

void add_clearcoat(scene::Material& m) {
    m.clearcoat = 0.9f;
    m.clearcoat_roughness = 0.3f;
}

void add_sheen(scene::Material& m) {
    m.sheen_color = vec3(0.7f, 0.8f, 0.9f);
    m.sheen_roughness = 0.5f;
}

void add_film(scene::Material& m, float ior, float thickness) {
    m.iridescence = 0.9f;
    m.film_ior = ior;
    m.max_film_thickness = thickness;
}

scene::Material layered(std::string_view name) {
    scene::Material m = name == "clearcoat" || name == "sheen" || name == "plastic_film" ? clay() : metal();
    if (name == "clearcoat")
        add_clearcoat(m);
    else if (name == "sheen")
        add_sheen(m);
    else if (name == "thin_film")
        add_film(m, 1.33f, 420.0f);
    else if (name == "plastic_film")
        add_film(m, 1.8f, 600.0f);
    else if (name == "anisotropy_00")
        add_anisotropy(m, 0.0f);
    else if (name == "anisotropy_30")
        add_anisotropy(m, 30.0f);
    else if (name == "anisotropy_90")
        add_anisotropy(m, 90.0f);
    else {
        require(name == "layers", "the BRDF is one of the list");
        add_anisotropy(m, 20.0f);
        add_clearcoat(m);
        add_sheen(m);
        add_film(m, 1.5f, 500.0f);
    }
    return m;
}

bool is_model(std::string_view name) { return name == "brushed" || scene::model_named(name).has_value(); }

} // namespace

bool is_lit(std::string_view brdf, std::string_view light) { return brdf != "mirror" || light != "point"; }

scene::Scene ball_scene(std::string_view brdf, std::string_view light) {
    scene::Scene scene;
    scene.materials.push_back(is_model(brdf) ? model_named(brdf) : layered(brdf));
    scene.materials[0].name = brdf;
    scene.meshes.push_back(ball());
    scene.instances.push_back(
        {0, glm::rotate(mat4(1.0f), 0.6f, glm::normalize(vec3(1.0f, 0.3f, 0.5f))), "ball"});
    if (brdf == "merl") scene.measured.push_back(made_measurement());
    if (brdf == "layers") add_layer_textures(scene);
    const vec3 place(-1.6f, 1.2f, 1.8f), towards = glm::normalize(-place);
    const vec3 u = glm::normalize(glm::cross(vec3(0, 1, 0), towards));
    if (light == "rectangle") {
        scene.lights.push_back(scene::RectangleLight{
            "", place, 0.9f * u, 0.5f * glm::cross(towards, u), vec3(10.0f, 8.0f, 5.0f), false, false, {}});
    } else if (light == "environment") {
        scene.lights.push_back(sky());
    } else {
        require(light == "point", "the light is one of the list");
        scene.lights.push_back(scene::PointLight{"", place, vec3(20.0f, 16.0f, 10.0f)});
    }
    return scene;
}

scene::Camera ball_camera() {
    scene::Camera camera;
    camera.name = "front";
    camera.world_from_camera[3] = vec4(0.0f, 0.0f, 2.0f, 1.0f);
    camera.projection = scene::Orthographic{0.55f, 0.55f, 0.01f, 10.0f};
    return camera;
}

scene::MeasuredBrdf made_measurement() {
    scene::MeasuredBrdf made{"made", {}, 0.25f};
    made.values.reserve(scene::merl_cells);
    for (std::size_t cell = 0; cell < scene::merl_cells; ++cell) {
        const auto [wi, wo] = scene::merl_directions(cell);
        const vec3 h = glm::normalize(wi + wo);
        const float retro = 1.0f - glm::dot(h, wi), along = wi.x * wo.x + wi.y * wo.y;
        made.values.push_back(vec3(0.1f, 0.05f, 0.03f) * (1.0f + 0.5f * along)
                              + std::pow(std::max(h.z, 0.0f), 60.0f)
                                    * (vec3(0.8f, 0.9f, 1.0f) + 2.0f * retro * retro));
    }
    return made;
}

} // namespace sr::truth
