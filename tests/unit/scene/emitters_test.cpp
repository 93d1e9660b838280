#include "scene/prepare.hpp"

#include "support/address.hpp"

#include <glm/gtc/matrix_transform.hpp>

using namespace sr;
using namespace sr::scene;
using sr::testing::Test;

namespace {

/// An emissive quad of 2 m × 1 m in the plane z = 0, facing +Z, split along either diagonal.
Scene lamp(bool other_diagonal, mat4 world_from_object = mat4(1.0f)) {
    Scene scene;
    Material material;
    material.emission = vec3(3.0f);
    scene.materials.push_back(material);
    Mesh mesh;
    mesh.positions = {{-1, -0.5f, 0}, {1, -0.5f, 0}, {1, 0.5f, 0}, {-1, 0.5f, 0}};
    mesh.normals.assign(4, vec3(0, 0, 1));
    mesh.indices = other_diagonal ? std::vector<std::uint32_t>{0, 1, 3, 3, 1, 2}
                                  : std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({0, world_from_object, "lamp"});
    return scene;
}

RectangleLight only_rectangle(const Scene& scene) {
    const std::vector<Light> lights = emitters_of(scene);
    EXPECT_EQ(lights.size(), 1u);
    return lights.empty() ? RectangleLight{} : std::get<RectangleLight>(lights.front());
}

const Test quad("unit.scene.emitters.a_quad_is_a_rectangle", [] {
    for (const bool other_diagonal : {false, true}) {
        const RectangleLight light = only_rectangle(lamp(other_diagonal));
        EXPECT_FLOAT_EQ(light.area(), 2.0f);
        EXPECT_LT(glm::distance(light.normal(), vec3(0, 0, 1)), 1e-6f) << "its front is the triangles' front";
        EXPECT_LT(glm::length(light.center), 1e-6f);
        EXPECT_EQ(light.L, vec3(3.0f));
    }
});

const Test transformed("unit.scene.emitters.a_transform_moves_and_scales_it", [] {
    const mat4 m = glm::scale(glm::translate(mat4(1.0f), vec3(1, 2, 3)), vec3(2, 2, 2));
    const RectangleLight light = only_rectangle(lamp(false, m));
    EXPECT_FLOAT_EQ(light.area(), 8.0f);
    EXPECT_LT(glm::distance(light.center, vec3(1, 2, 3)), 1e-6f);
});

const Test mirrored("unit.scene.emitters.a_mirrored_lamp_keeps_its_front", [] {
    const RectangleLight light = only_rectangle(lamp(false, glm::scale(mat4(1.0f), vec3(-1, 1, 1))));
    EXPECT_LT(glm::distance(light.normal(), vec3(0, 0, 1)), 1e-6f);
});

const Test sheared("unit.scene.emitters.a_sheared_quad_is_a_mesh", [] {
    mat4 shear(1.0f);
    shear[1][0] = 0.5f;
    const std::vector<Light> lights = emitters_of(lamp(false, shear));
    ASSERT_EQ(lights.size(), 1u);
    const auto& light = std::get<MeshLight>(lights.front());
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.triangles.size(), 2u);
    EXPECT_FLOAT_EQ(light.area(), 2.0f);
});

const Test folded("unit.scene.emitters.a_folded_quad_is_a_mesh", [] {
    Scene scene = lamp(false);
    scene.meshes[0].positions[3].z = 0.3f;
    EXPECT_TRUE(std::holds_alternative<MeshLight>(emitters_of(scene).front()));
});

const Test two("unit.scene.emitters.a_mesh_of_two_quads_is_two_lights", [] {
    Scene scene = lamp(false);
    Mesh& mesh = scene.meshes[0];
    for (int i = 0; i < 4; ++i)
        mesh.positions.push_back(mesh.positions[static_cast<std::size_t>(i)] + vec3(0, 0, -1));
    mesh.indices = {0, 1, 2, 4, 5, 6, 0, 2, 3, 4, 6, 7};
    EXPECT_EQ(emitters_of(scene).size(), 2u);
});

// A visible light gets a surface that emits exactly its radiance and is not mistaken for a further light by
// its maker.
const Test surface("unit.scene.emitters.a_light_gets_a_surface", [] {
    Scene scene;
    scene.lights.emplace_back(RectangleLight{"panel", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, vec3(7.0f)});
    scene.lights.emplace_back(
        RectangleLight{"hidden", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, vec3(7.0f), false, false});
    add_light_surfaces(scene);
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.materials[0].emission, vec3(7.0f));
    scene.lights.clear();
    const RectangleLight again = only_rectangle(scene);
    EXPECT_LT(glm::distance(again.normal(), vec3(0, -1, 0)), 1e-6f);
    EXPECT_FLOAT_EQ(again.area(), 4.0f);
});

// A point with a radius is a sphere of radiance I / (π radius²); a spot or a profile would look different
// from every side.
const Test bulbs("unit.scene.emitters.a_point_with_a_radius_gets_a_surface", [] {
    Scene scene;
    PointLight bulb;
    bulb.I = vec3(2.0f);
    scene.lights.emplace_back(bulb);
    bulb.radius = 0.5f;
    scene.lights.emplace_back(bulb);
    bulb.profile = 0;
    scene.lights.emplace_back(bulb);
    SpotLight spot;
    spot.radius = 0.5f;
    scene.lights.emplace_back(spot);
    EXPECT_EQ(add_light_surfaces(scene), 1);
    EXPECT_FLOAT_EQ(scene.materials.at(0).emission.r, 2.0f / (pi * 0.25f));
});

} // namespace
