// alphaMode MASK shows alpha >= cutoff (glTF 2.0, section 3.9.4), in the picture and in every kind of
// shadow. And flat emitters send nothing to their own plane.
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

namespace {

using namespace sr;
using namespace sr::testing;
using render::Visibility;
using sr::testing::Test;

/// The factors of an alpha.
struct Masked {
    float factor = 1.0f;
    float vertex = 1.0f;
    int texel = 255;         // of 255
    int other_texel = 255;   // of every second column; 255 or `texel`
    bool has_texture = true; // false: texels do not count
    double cutoff_over_alpha = 1.0;

    double alpha() const { return double{factor} * double{vertex} * (has_texture ? texel / 255.0 : 1.0); }
    std::string text() const {
        return fmt::format("{} x {} x {}/255 ({} beside it), cutoff {} of that", factor, vertex, texel,
                           other_texel, cutoff_over_alpha);
    }
};

void add_texture(scene::Scene& scene, const Masked& masked) {
    scene::TextureImage image;
    image.width = image.height = 8;
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 64; ++i)
        for (const int value : {255, 255, 255, i % 2 == 0 ? masked.texel : masked.other_texel})
            texels.push_back(static_cast<std::uint8_t>(value));
    image.texels = texels;
    scene.images.push_back(image);
    scene.textures.push_back({0, scene::Sampler{}, scene::ColorSpace::srgb});
}

/// A white plane, and over it a red masked plate that the camera sees at the middle. Parallel light at 45°
/// throws its shadow to x = 0.25 … 0.75.
scene::Scene plate_over_plane(const Masked& masked) {
    scene::Scene scene = lambert_plane(2.0f);
    scene::Material material = lambert(vec3(1, 0, 0));
    material.alpha_mode = scene::AlphaMode::mask;
    material.base_color.a = masked.factor;
    material.alpha_cutoff = static_cast<float>(masked.alpha() * masked.cutoff_over_alpha);
    if (masked.has_texture) {
        add_texture(scene, masked);
        material.base_color_texture.texture = 0;
    }
    const int mesh = add_quad(scene, vec3(0, 0.5f, 0), vec3(0, 0, 0.25f), vec3(0.25f, 0, 0), material).mesh;
    scene.meshes[static_cast<std::size_t>(mesh)].colors.assign(4, vec4(1, 1, 1, masked.vertex));
    return scene;
}

void expect_plate(const Masked& masked, bool is_there) {
    const scene::Scene scene = plate_over_plane(masked);
    scene::DirectionalLight sun;
    sun.direction = glm::normalize(vec3(1, -1, 0));
    const std::vector<scene::Light> lights{sun};
    constexpr int size = 32;
    for (const Visibility visibility : {Visibility::ray_on_cpu, Visibility::ray_in_glsl, Visibility::map}) {
        const image::Image picture =
            sr::testing::picture(scene, lights, camera_from_above(1.0f), size, 1, 0, visibility);
        for (int row = 13; row < 19; ++row)
            for (int i = -3; i < 3; ++i) {
                const float shadow = picture.at(24 + i, row)[1], plate = picture.at(16 + i, row)[1];
                EXPECT_EQ(shadow == 0.0f, is_there) << masked.text() << ": the shadow of "
                                                    << render::name_of(visibility) << " has " << shadow;
                EXPECT_EQ(plate == 0.0f, is_there) << masked.text() << ": the picture has green " << plate;
            }
    }
}

const Test equal("law.mask.an_alpha_that_equals_the_cutoff_is_opaque", [] {
    for (const float factor : {0.1f, 0.7f}) expect_plate({factor, 1.0f, 255, 255, false}, true);
    expect_plate({0.7f, 1.0f / 3.0f, 255, 255, false}, true);
    for (const int texel : {1, 128, 201}) expect_plate({0.7f, 0.6f, texel, texel}, true);
    expect_plate({1.0f, 1.0f, 85, 255}, true); // more in between
});

const Test below("law.mask.an_alpha_below_the_cutoff_is_cut", [] {
    expect_plate({1.0f, 1.0f, 128, 128, true, 128.5 / 128.0}, false);
    expect_plate({0.7f, 0.6f, 200, 200, true, 1.002}, false);
});

/// A square light in a plane through `center`, of each flat kind.
std::vector<scene::Light> flat_lights(vec3 center, vec3 u, vec3 v) {
    scene::RectangleLight rectangle;
    rectangle.center = center, rectangle.half_u = u, rectangle.half_v = v, rectangle.is_two_sided = true;
    scene::DiskLight disk;
    disk.center = center, disk.half_u = u, disk.half_v = v, disk.is_two_sided = true;
    scene::PolygonLight polygon;
    polygon.corners = {center - u - v, center + u - v, center + u + v, center - u + v};
    polygon.is_two_sided = true;
    scene::MeshLight mesh;
    mesh.triangles = {{{center - u - v, center + u - v, center + u + v}, {}},
                      {{center - u - v, center + u + v, center - u + v}, {}}};
    mesh.is_two_sided = true;
    return {rectangle, disk, polygon, mesh};
}

const Test own_plane("law.light.flat.nothing_arrives_in_its_own_plane", [] {
    int kind = 0;
    for (const glm::quat turn :
         {glm::quat(1, 0, 0, 0), glm::normalize(glm::quat(0.8f, 0.31f, -0.22f, 0.47f))})
        for (const vec3 offset : {vec3(0.0f), vec3(0.37f, -1.9f, 6.3f)}) {
            const mat3 axes = glm::mat3_cast(turn);
            scene::Scene scene;
            scene::Material white = lambert();
            white.is_double_sided = true;
            add_quad(scene, offset, 2.0f * axes[0], 2.0f * axes[1], white);
            scene::Camera camera;
            camera.world_from_camera = mat4(axes);
            camera.world_from_camera[3] = vec4(offset + 3.0f * axes[2], 1.0f);
            camera.projection = scene::Orthographic{1.9f, 1.9f, 0.1f, 6.0f};
            for (const scene::Light& light : flat_lights(offset, 0.7f * axes[0], 0.4f * axes[1]))
                for (const Visibility visibility : {Visibility::none, Visibility::ray, Visibility::map}) {
                    const image::Image picture =
                        sr::testing::picture(scene, std::span(&light, 1), camera, 24, 4, 0, visibility);
                    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
                        ASSERT_EQ(picture.pixels[i], i % 4 == 3 ? 1.0f : 0.0f) << "kind " << kind % 4;
                    ++kind;
                }
        }
});

} // namespace
