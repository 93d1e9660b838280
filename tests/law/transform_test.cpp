// Normals and normal maps under a node's transform.
#include "scene/transform.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

namespace {

using namespace sr;
using namespace sr::testing;

/// A material whose normal map says (0.6, 0, 0.8) everywhere, to a 16-bit texel.
scene::Material leaning(scene::Scene& scene) {
    scene::TextureImage image;
    image.width = image.height = 1;
    const auto texel = [](float v) { return static_cast<std::uint16_t>(std::lround((v + 1.0f) * 32767.5f)); };
    image.texels = std::vector<std::uint16_t>{texel(0.6f), texel(0.0f), texel(0.8f), 65535};
    scene.images.push_back(image);
    scene::Sampler sampler;
    sampler.mipmap = scene::Mipmap::none;
    scene.textures.push_back({0, sampler, scene::ColorSpace::linear});
    scene::Material material = lambert();
    material.normal_texture.texture = 0;
    return material;
}

/// A square of edge 2 in z = 0, its front towards +Z, its tangent along +X.
scene::Scene square(bool has_map) {
    scene::Scene scene;
    const scene::Material material = has_map ? leaning(scene) : lambert();
    add_quad(scene, vec3(0.0f), {1, 0, 0}, {0, 1, 0}, material);
    scene.meshes[0].tangents.assign(4, vec4(1, 0, 0, 1));
    return scene;
}

/// An orthographic camera in front of the square, far enough for whatever is seen.
scene::Camera in_front(float half_extent) {
    scene::Camera camera;
    camera.world_from_camera[3] = vec4(0, 0, 10.0f * half_extent, 1);
    camera.projection = scene::Orthographic{half_extent, half_extent, 0.0f, 20.0f * half_extent};
    return camera;
}

/// The middle pixel of a view of the scene's first instance under `transform`.
vec3 middle_of(scene::Scene scene, const mat4& transform, const std::string& shader,
               std::span<const scene::Light> lights = {}, float half_extent = 0.0f) {
    scene.instances[0].world_from_object = transform;
    context();
    const render::GpuScene gpu_scene(scene, lights);
    render::RenderOptions options;
    options.width = options.height = 3;
    options.samples = 1;
    options.shader = shader;
    const float reach = half_extent > 0.0f ? half_extent : std::abs(transform[0][0]);
    render::Renderer renderer(gpu_scene, in_front(reach), options);
    renderer.add_sample();
    const image::Image film = renderer.read_film();
    return {film.at(1, 1)[0], film.at(1, 1)[1], film.at(1, 1)[2]};
}

mat4 scaled(float x, float y, float z) {
    return mat4(vec4(x, 0, 0, 0), vec4(0, y, 0, 0), vec4(0, 0, z, 0), vec4(0, 0, 0, 1));
}

void expect_near(vec3 value, vec3 expected, float tolerance, const std::string& what) {
    EXPECT_LT(glm::distance(value, expected), tolerance)
        << what << ": " << value.x << " " << value.y << " " << value.z;
}

const Test map_scale("law.transform.a_normal_map_is_the_same_at_every_scale", [] {
    const auto scene = square(true);
    for (const float s : {1.0f, 0.01f, 4.0f, 1.0f / 16384.0f, 1e-12f, 1e-18f, 1e12f})
        expect_near(middle_of(scene, scaled(s, s, s), "views/normal.frag"), {0.6f, 0, 0.8f}, 1e-4f,
                    std::to_string(s));
    for (const vec3 s : {vec3(1, 1, 10), vec3(1, 1, 0.1f), vec3(2, 5, 0.3f), vec3(0.01f, 0.02f, 30),
                         vec3(1, 1, 1e-20f), vec3(1, 1, 0)})
        expect_near(middle_of(scene, scaled(s.x, s.y, s.z), "views/normal.frag"), {0.6f, 0, 0.8f}, 1e-4f,
                    std::to_string(s.z));
});

// A node that mirrors along X mirrors what the map says; along Y nothing is to be seen of it.
const Test map_mirror("law.transform.a_normal_map_is_mirrored_with_its_node", [] {
    const auto scene = square(true);
    expect_near(middle_of(scene, scaled(-1, 1, 1), "views/normal.frag"), {-0.6f, 0, 0.8f}, 1e-4f, "x");
    expect_near(middle_of(scene, scaled(1, -1, 1), "views/normal.frag"), {0.6f, 0, 0.8f}, 1e-4f, "y");
    expect_near(middle_of(scene, scaled(-3e-15f, 3e-15f, 3e-15f), "views/normal.frag"), {-0.6f, 0, 0.8f},
                1e-4f, "tiny");
});

// A square that is seen at all is lit as every other, whatever happened to the axis across it.
const Test flat("law.transform.a_flattened_surface_is_lit", [] {
    const std::vector<scene::Light> lamp{scene::PointLight{"", {0, 0, 1}, vec3(pi)}};
    for (const float z : {1.0f, 1e-30f, 0.0f}) {
        expect_near(middle_of(square(false), scaled(1, 1, z), "forward.frag", lamp, 0.01f), vec3(1.0f), 1e-4f,
                    std::to_string(z));
        expect_near(middle_of(square(false), scaled(1, 1, z), "views/normal.frag"), {0, 0, 1}, 1e-6f,
                    std::to_string(z));
    }
});

const Test smooth("law.transform.normals_follow_the_surface", [] {
    // The tangent plane at the normal n of a sphere is that of the ellipsoid that the sphere becomes.
    const mat4 m = scaled(-3.0f, 0.5f, 2e-7f);
    const mat3 transform = scene::normal_transform(m);
    for (const vec3 n : {vec3(1, 0, 0), vec3(0.6f, 0.8f, 0), vec3(0.48f, 0.64f, 0.6f)}) {
        const vec3 t = glm::normalize(glm::cross(n, vec3(0.3f, -0.4f, 0.9f)));
        const vec3 b = glm::cross(n, t);
        const vec3 turned = scene::unit_or(transform * n, vec3(0.0f));
        EXPECT_NEAR(glm::length(turned), 1.0f, 1e-6f);
        for (const vec3 along : {t, b})
            EXPECT_NEAR(glm::dot(turned, scene::unit_or(mat3(m) * along, vec3(0.0f))), 0.0f, 1e-5f);
        EXPECT_GT(glm::dot(turned, scene::unit_or(mat3(m) * n, vec3(0.0f))), 0.0f) << "outside stays outside";
    }
    EXPECT_TRUE(scene::mirrors(m));
    EXPECT_TRUE(scene::mirrors(scaled(-1e-30f, 1e-30f, 1e-30f)));
    EXPECT_FALSE(scene::mirrors(scaled(-1, 1, 0)));
    EXPECT_FALSE(scene::mirrors(scaled(-1, -1, 1)));
});

} // namespace
