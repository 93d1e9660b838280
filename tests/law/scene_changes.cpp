#include "scene_changes.hpp"

#include <algorithm>

namespace sr::testing {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

/// Changes each kind of light in place.
class LightMover {
public:
    explicit LightMover(const Similarity& similarity)
        : s_(similarity), is_mirror_(glm::determinant(similarity.turn) < 0.0) {}

    void operator()(scene::PointLight& light) const {
        move_point(light);
        light.world_from_profile = mat3(s_.turn * dmat3(light.world_from_profile));
    }
    void operator()(scene::SpotLight& light) const {
        move_point(light);
        light.direction = vec3(s_.turn * dvec3(light.direction));
    }
    void operator()(scene::DirectionalLight& light) const {
        light.direction = vec3(s_.turn * dvec3(light.direction));
    }
    void operator()(scene::RectangleLight& light) const { move_flat(light); }
    void operator()(scene::DiskLight& light) const { move_flat(light); }
    void operator()(scene::SphereLight& light) const {
        light.center = place(light.center);
        scale(light.radius);
    }
    void operator()(scene::TubeLight& light) const {
        light.center = place(light.center);
        light.half_axis = edge(light.half_axis);
        scale(light.radius);
    }
    void operator()(scene::PolygonLight& light) const {
        for (vec3& corner : light.corners) corner = place(corner);
        if (is_mirror_) std::reverse(light.corners.begin(), light.corners.end());
    }
    void operator()(scene::EnvironmentLight&) const {
    }                                           // it turns around +Y alone, so generated scenes have none
    void operator()(scene::MeshLight&) const {} // a surface of the scene: it moves with its instance

private:
    vec3 place(vec3 p) const { return vec3(s_.scale * (s_.turn * dvec3(p)) + s_.translation); }
    vec3 edge(vec3 v) const { return vec3(s_.scale * (s_.turn * dvec3(v))); }
    void scale(float& length) const { length = static_cast<float>(s_.scale * length); }

    template<class Punctual>
    void move_point(Punctual& light) const {
        light.position = place(light.position);
        scale(light.range);
        scale(light.radius);
        light.I = vec3(s_.scale * s_.scale * dvec3(light.I));
    }

    template<class Flat>
    void move_flat(Flat& light) const {
        light.center = place(light.center);
        light.half_u = edge(light.half_u);
        light.half_v = edge(light.half_v);
        if (!is_mirror_) return;
        light.half_v = -light.half_v; // its front is cross(half_u, half_v)
        light.map.along_v = -light.map.along_v;
    }

    Similarity s_;
    bool is_mirror_;
};

void move_camera(scene::Camera& camera, const Similarity& s) {
    dmat4 m(camera.world_from_camera);
    dmat3 axes = s.turn * dmat3(m);
    if (glm::determinant(s.turn) < 0.0) axes[0] = -axes[0];
    camera.world_from_camera = mat4(dmat4(axes));
    camera.world_from_camera[3] = vec4(vec3(s.scale * (s.turn * dvec3(m[3])) + s.translation), 1.0f);
    const auto scaled = [&](float length) { return static_cast<float>(s.scale * length); };
    if (auto* lens = std::get_if<scene::Perspective>(&camera.projection)) {
        lens->znear = scaled(lens->znear);
        if (lens->zfar) lens->zfar = scaled(*lens->zfar);
    } else {
        auto& box = std::get<scene::Orthographic>(camera.projection);
        for (float* length : {&box.xmag, &box.ymag, &box.znear, &box.zfar}) *length = scaled(*length);
    }
}

dvec3 unit(const dvec3& v) { return glm::length(v) > 0.0 ? glm::normalize(v) : v; }

scene::Mesh baked_mesh(scene::Mesh mesh, const dmat4& m) {
    const dmat3 linear(m);
    const bool is_mirror = glm::determinant(linear) < 0.0;
    const dmat3 of_normals = glm::transpose(glm::inverse(linear));
    for (vec3& p : mesh.positions) p = vec3(m * dvec4(p, 1.0));
    for (vec3& n : mesh.normals) n = vec3(unit(of_normals * dvec3(n)));
    for (vec4& t : mesh.tangents) t = vec4(vec3(unit(linear * dvec3(t))), is_mirror ? -t.w : t.w);
    for (std::size_t i = 0; is_mirror && i + 2 < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    return mesh;
}

const scene::Material& material_of(const scene::Scene& scene, const scene::Mesh& mesh) {
    return scene.materials[static_cast<std::size_t>(mesh.material)];
}

bool keeps_its_triangles(const scene::Material& material) {
    return material.is_emissive() || material.alpha_mode == scene::AlphaMode::blend;
}

void shuffle_triangles(scene::Mesh& mesh, Random& random) {
    const std::vector<std::uint32_t> before = mesh.indices;
    mesh.indices.clear();
    for (const int t : random.order(before.size() / 3)) {
        const int first = random.below(3);
        for (int i = 0; i < 3; ++i)
            mesh.indices.push_back(before[static_cast<std::size_t>(3 * t + (first + i) % 3)]);
    }
}

} // namespace

scene::Scene placed(scene::Scene scene, const Similarity& s) {
    dmat4 move(s.scale * s.turn);
    move[3] = dvec4(s.translation, 1.0);
    for (scene::Instance& instance : scene.instances)
        instance.world_from_object = mat4(move * dmat4(instance.world_from_object));
    for (scene::Light& light : scene.lights) std::visit(LightMover(s), light);
    for (scene::Camera& camera : scene.cameras) move_camera(camera, s);
    return scene;
}

scene::Scene without_minification(scene::Scene scene) {
    for (scene::Texture& texture : scene.textures) {
        texture.sampler.minification = texture.sampler.magnification;
        texture.sampler.mipmap = scene::Mipmap::none;
    }
    return scene;
}

scene::Scene baked(const scene::Scene& scene) {
    scene::Scene result = scene;
    result.meshes.clear();
    for (scene::Instance& instance : result.instances) {
        result.meshes.push_back(baked_mesh(scene.meshes[static_cast<std::size_t>(instance.mesh)],
                                           dmat4(instance.world_from_object)));
        instance.mesh = static_cast<int>(result.meshes.size()) - 1;
        instance.world_from_object = mat4(1.0f);
    }
    return result;
}

scene::Scene split(const scene::Scene& scene, Random& random) {
    scene::Scene result = scene;
    std::vector<int> other(scene.meshes.size(), -1); // the second part of a mesh
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        if (keeps_its_triangles(material_of(scene, scene.meshes[i]))) continue;
        scene::Mesh first = scene.meshes[i], second = scene.meshes[i];
        first.indices.clear(), second.indices.clear();
        for (std::size_t t = 0; t + 2 < scene.meshes[i].indices.size(); t += 3) {
            auto& to = random.has_chance(0.5) ? first.indices : second.indices;
            for (std::size_t k = 0; k < 3; ++k) to.push_back(scene.meshes[i].indices[t + k]);
        }
        result.meshes[i] = first;
        other[i] = static_cast<int>(result.meshes.size());
        result.meshes.push_back(second);
    }
    for (const scene::Instance& instance : scene.instances) {
        const int second = other[static_cast<std::size_t>(instance.mesh)];
        if (second < 0) continue;
        result.instances.push_back(instance);
        result.instances.back().mesh = second;
    }
    return result;
}

scene::Scene shuffled(const scene::Scene& scene, Random& random) {
    scene::Scene result = scene;
    const std::vector<int> materials = random.order(scene.materials.size());
    for (std::size_t i = 0; i < materials.size(); ++i)
        result.materials[static_cast<std::size_t>(materials[i])] = scene.materials[i];
    const std::vector<int> meshes = random.order(scene.meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        scene::Mesh& mesh = result.meshes[static_cast<std::size_t>(meshes[i])];
        mesh = scene.meshes[i];
        if (!keeps_its_triangles(material_of(scene, mesh))) shuffle_triangles(mesh, random);
        mesh.material = materials[static_cast<std::size_t>(mesh.material)];
    }
    const std::vector<int> instances = random.order(scene.instances.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
        scene::Instance& instance = result.instances[static_cast<std::size_t>(instances[i])];
        instance = scene.instances[i];
        instance.mesh = meshes[static_cast<std::size_t>(instance.mesh)];
    }
    const std::vector<int> lights = random.order(scene.lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i)
        result.lights[static_cast<std::size_t>(lights[i])] = scene.lights[i];
    return result;
}

} // namespace sr::testing
