#include "scene/receiver.hpp"

namespace sr::scene {
namespace {

/// Lambertian, of albedo 1.
Material white() {
    Material material;
    material.name = "receiver";
    material.metallic = 0.0f;
    material.specular = 0.0f;
    return material;
}

/// Two triangles, counter-clockwise seen from the front. They reach a little beyond the receiver: rounding
/// would leave some samples at the border of the picture uncovered.
Mesh rectangle_of(const Receiver& receiver, vec3 offset) {
    constexpr float low = -1e-3f, high = 1.0f + 1e-3f;
    Mesh mesh;
    mesh.name = "receiver";
    for (const vec2 st : {vec2(low, low), vec2(high, low), vec2(high, high), vec2(low, high)})
        mesh.positions.push_back(receiver.at(st.x, st.y) + offset);
    mesh.normals.assign(4, receiver.normal());
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

} // namespace

vec3 Receiver::normal() const { return glm::normalize(glm::cross(u, v)); }

Receiver horizontal_receiver(const Bounds& bounds, float height) {
    return {{bounds.min.x, bounds.min.y + height, bounds.max.z},
            {bounds.max.x - bounds.min.x, 0.0f, 0.0f},
            {0.0f, 0.0f, bounds.min.z - bounds.max.z}};
}

Camera add_receiver(Scene& scene, const Receiver& receiver) {
    // The camera sees no deeper than this, so that nothing else is in the picture. Half of it lies between
    // the receiver and a surface in the same place, a floor for example, which would be drawn as well.
    const float width = glm::length(receiver.u), height = glm::length(receiver.v);
    const float depth = 4e-5f * std::max(width, height);
    const vec3 normal = receiver.normal();

    Mesh mesh = rectangle_of(receiver, 0.5f * depth * normal);
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(white());
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), mat4(1.0f), mesh.name});
    scene.meshes.push_back(std::move(mesh));

    Camera camera;
    camera.name = "receiver";
    camera.world_from_camera = mat4(vec4(receiver.u / width, 0.0f), vec4(receiver.v / height, 0.0f),
                                    vec4(normal, 0.0f), vec4(receiver.at(0.5f, 0.5f) + depth * normal, 1.0f));
    camera.projection = Orthographic{0.5f * width, 0.5f * height, 0.0f, 0.75f * depth};
    return camera;
}

} // namespace sr::scene
