#include "mitsuba/emitters.hpp"

#include "scene/lights/emitter.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sr::mitsuba {
namespace {

/// Of an ellipse's outline. The polygon is given the ellipse's area, so that only its outline differs, by
/// 2·10^-5.
constexpr int outline_corners = 512;

mat4 placed(vec3 x, vec3 y, vec3 z, vec3 origin) {
    return {vec4(x, 0.0f), vec4(y, 0.0f), vec4(z, 0.0f), vec4(origin, 1.0f)};
}

Triangles as_triangles(scene::Mesh mesh) {
    Triangles triangles;
    triangles.positions = std::move(mesh.positions);
    triangles.normals = std::move(mesh.normals);
    triangles.uv = std::move(mesh.texcoords[0]);
    triangles.indices = std::move(mesh.indices);
    return triangles;
}

double area_of(const scene::Mesh& mesh) {
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
        area += 0.5 * double{glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)))};
    }
    return area;
}

template<class Flat>
Emission emission_of(const Flat& light) {
    return {light.L, light.map.texture, mat3(1.0f), light.is_two_sided};
}

class Writer {
public:
    explicit Writer(Output& output) : output_(output), xml_(output.xml) {}

    void operator()(const scene::PointLight& light) {
        if (light.radius > 0.0f && light.profile < 0) return glowing(light);
        if (light.radius > 0.0f) warn(light.name, "has a radius and a profile: exported without the radius");
        open_punctual(light.position, vec3(0, 0, -1), light.I, light.range);
        if (light.profile >= 0) profile(light);
        xml_.close();
    }

    void operator()(const scene::SpotLight& light) {
        if (light.radius > 0.0f) warn(light.name, "is a spot with a radius: exported without the radius");
        const scene::ConeFalloff cone = light.falloff();
        open_punctual(light.position, light.direction, light.I, light.range);
        xml_.number("cone_scale", cone.scale);
        xml_.number("cone_offset", cone.offset);
        xml_.close();
    }

    void operator()(const scene::DirectionalLight& light) {
        if (light.angular_radius > 0.0f) return sun(light);
        xml_.open("emitter", "directional");
        xml_.vector("direction", light.direction);
        xml_.color("irradiance", light.E);
        xml_.close();
    }

    void operator()(const scene::EnvironmentLight& light) {
        if (!light.map) {
            xml_.open("emitter", "constant");
            xml_.color("radiance", light.L);
            xml_.close();
            return;
        }
        xml_.open("emitter", "envmap");
        xml_.text("filename", output_.textures.file_of(*light.map, light.L));
        const mat3 half_turn(vec3(-1, 0, 0), vec3(0, 1, 0),
                             vec3(0, 0, -1)); // its left edge shows -Z, not its middle
        xml_.transform("to_world", mat4(glm::transpose(light.map_from_world()) * half_turn));
        xml_.close();
    }

    void operator()(const scene::RectangleLight& light) {
        if (light.map.is_present() || light.is_two_sided)
            return mesh(as_triangles(flat_mesh(light, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})),
                        emission_of(light));
        open("rectangle");
        xml_.transform("to_world", placed(light.half_u, light.half_v, light.normal(), light.center));
        close(light.L);
    }

    void operator()(const scene::DiskLight& light) {
        const float u = glm::length(light.half_u), v = glm::length(light.half_v);
        if (light.map.is_present() || light.is_two_sided || u != v)
            return mesh(outline(light), emission_of(light));
        open("disk"); // Mitsuba's must be scaled alike along all axes
        xml_.transform("to_world", placed(light.half_u, light.half_v, u * light.normal(), light.center));
        close(light.L);
    }

    void operator()(const scene::SphereLight& light) { sphere(light.center, light.radius, light.L); }

    void operator()(const scene::TubeLight& light) {
        // Not a cylinder and two spheres: the last 10⁻³ of a shadow ray's way are not looked at in Mitsuba,
        // which adds the spheres' light to the cylinder's wherever the two nearly touch.
        mesh(capsule(light), {light.L});
    }

    /// A light of any other kind, as the triangles that cameras see.
    template<class Area>
    void operator()(Area light) {
        light.is_visible = true;
        scene::LightSurface surface = *light.surface();
        mesh(as_triangles(std::move(surface.mesh)),
             {surface.L, surface.texture, mat3(1.0f), surface.is_two_sided});
    }

    void operator()(const scene::MeshLight& light) {
        Triangles triangles;
        for (const auto& [corners, uv] : light.triangles) {
            const vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            for (std::size_t i = 0; i < 3; ++i) {
                triangles.indices.push_back(static_cast<std::uint32_t>(triangles.positions.size()));
                triangles.positions.push_back(corners[i]);
                triangles.normals.push_back(normal);
                if (light.texture >= 0) triangles.uv.push_back(uv[i]);
            }
        }
        mesh(triangles, {light.L, light.texture, mat3(1.0f), light.is_two_sided});
    }

private:
    void warn(const std::string& name, std::string_view what) {
        output_.warnings.push_back(fmt::format("light '{}' {}", name, what));
    }

    void open(std::string_view type) {
        const std::string bsdf = output_.materials.black(xml_);
        xml_.open("shape", type);
        xml_.reference(bsdf);
    }

    void close(vec3 L) {
        write_area_emitter(output_, {L});
        xml_.close();
    }

    void mesh(const Triangles& triangles, const Emission& emission) {
        write_mesh(output_, triangles, output_.materials.black(xml_), emission);
    }

    void sphere(vec3 center, float radius, vec3 L) {
        open("sphere");
        xml_.point("center", center);
        xml_.number("radius", radius);
        close(L);
    }

    static Triangles outline(const scene::DiskLight& light) {
        constexpr float step = 2.0f * pi / outline_corners;
        const float scale = std::sqrt(step / std::sin(step)); // n/2 sin(2π/n) scale² = π
        std::vector<vec2> st;
        for (int i = 0; i < outline_corners; ++i) {
            const float angle = step * static_cast<float>(i);
            st.push_back(scale * vec2(std::cos(angle), std::sin(angle)));
        }
        return as_triangles(flat_mesh(light, st));
    }

    void open_punctual(vec3 position, vec3 direction, vec3 I, float range) {
        xml_.open("emitter", "steradian_punctual");
        xml_.vector("position", position);
        xml_.vector("direction", direction);
        xml_.vector("intensity", I);
        if (std::isfinite(range)) xml_.number("inverse_range", 1.0f / range);
    }

    void profile(const scene::PointLight& light) {
        const scene::LightProfile& profile = output_.scene.profiles[static_cast<std::size_t>(light.profile)];
        xml_.text("profile_gamma", fmt::format("{}", fmt::join(profile.gamma, " ")));
        xml_.text("profile_phi", fmt::format("{}", fmt::join(profile.phi, " ")));
        xml_.text("profile_intensity", fmt::format("{}", fmt::join(profile.I, " ")));
        xml_.vector("profile_x", light.world_from_profile[0]);
        xml_.vector("profile_y", light.world_from_profile[1]);
        xml_.vector("profile_z", light.world_from_profile[2]);
    }

    void glowing(const scene::PointLight& light) {
        if (std::isfinite(light.range))
            warn(light.name, "has a radius and a range: exported without the range");
        sphere(light.position, light.radius, light.I / (pi * light.radius * light.radius));
    }

    /// A disk so far away that the scene, which is small against it, sees it under the same angle everywhere.
    void sun(const scene::DirectionalLight& light) {
        const scene::Bounds bounds = scene::bounds_of(output_.scene);
        const float distance = 1000.0f * (bounds.is_empty() ? 1.0f : std::max(bounds.radius(), 1e-3f));
        const float radius = distance * std::tan(light.angular_radius);
        const vec3 center = (bounds.is_empty() ? vec3(0.0f) : bounds.center()) - distance * light.direction;
        const vec3 u = glm::normalize(
            glm::cross(light.direction, std::abs(light.direction.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0)));
        const vec3 v = glm::cross(light.direction, u);
        const float sine = std::sin(light.angular_radius);
        open("disk");
        xml_.transform("to_world", placed(radius * u, radius * v, radius * light.direction, center));
        close(light.E / (pi * sine * sine));
    }

    Output& output_;
    Xml& xml_;
};

bool any_light_is(const scene::Scene& scene, bool visible) {
    for (const scene::Light& light : scene.lights)
        if (scene::visibility_of(light) == visible) return true;
    return false;
}

} // namespace

Triangles capsule(const scene::TubeLight& light) {
    constexpr int around = 192;
    const auto tessellated = [&](float radius) {
        return scene::capsule_mesh(light.center, light.half_axis, radius, around);
    };
    // One Newton step from the inscribed capsule, whose surface of 4π r (r + h) is too small by 10⁻⁴.
    const double r = light.radius, h = glm::length(light.half_axis);
    const double missing = double{light.area()} - area_of(tessellated(light.radius));
    const double slope = 4.0 * double{pi} * (2.0 * r + h);
    return as_triangles(tessellated(static_cast<float>(r + missing / slope)));
}

void write_emitters(Output& output) {
    Writer writer(output);
    for (const scene::Light& light : output.scene.lights) std::visit(writer, light);
    if (any_light_is(output.scene, false) && !hides_emitters(output.scene))
        output.warnings.emplace_back(
            "some lights are invisible, others are not: all are exported as visible");
}

bool hides_emitters(const scene::Scene& scene) {
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (scene.materials[static_cast<std::size_t>(mesh.material)].is_emissive()) return false;
    }
    return any_light_is(scene, false) && !any_light_is(scene, true);
}

} // namespace sr::mitsuba
