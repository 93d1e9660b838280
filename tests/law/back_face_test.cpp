// Light that passes the backs of single-sided faces, as the camera looks through them.
#include "scene/stage.hpp"
#include "support/address.hpp"
#include "support/scenes.hpp"

namespace {

using namespace sr;
using namespace sr::testing;
using render::Visibility;

constexpr std::array each_provider{Visibility::ray_on_cpu, Visibility::ray_in_glsl, Visibility::map};

/// A small panel high above the plane, which shines down.
scene::RectangleLight panel(bool passes) {
    scene::RectangleLight light{"", {0, 4, 0}, {0.05f, 0, 0}, {0, 0, 0.05f}, vec3(1600.0f * pi)};
    light.passes_back_faces = passes;
    return light;
}

/// Measures the share of the panel's light that arrives below a sheet in the middle of the plane.
struct Sheet {
    bool faces_up = false;
    bool is_double_sided = false;
    bool is_mirrored = false; // by its instance
    scene::AlphaMode mode = scene::AlphaMode::opaque;
};

float V_under(const Sheet& sheet, bool passes, Visibility visibility) {
    auto scene = lambert_plane(1.0f);
    auto material = lambert();
    material.is_double_sided = sheet.is_double_sided;
    material.alpha_mode = sheet.mode;
    const float side = sheet.faces_up ? -1.0f : 1.0f; // a mirror along X leaves up and down as they are
    auto& instance = add_quad(scene, {0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f * side}, material);
    if (sheet.is_mirrored) instance.world_from_object[0][0] = -1.0f;
    // The camera stands between the sheet and the plane.
    auto camera = camera_from_above(0.1f);
    std::get<scene::Orthographic>(camera.projection).znear = 9.5f;
    const std::vector<scene::Light> lights{panel(passes)};
    const auto lit = picture(lambert_plane(1.0f), lights, camera, 8, 4, 0, Visibility::none);
    const auto image = picture(scene, lights, camera, 8, 4, 0, visibility);
    return image.at(4, 4)[0] / lit.at(4, 4)[0];
}

const Test sheets("law.shadow.light_passes_back_faces", [] {
    for (const Visibility visibility : each_provider)
        for (const bool is_mirrored : {false, true}) {
            const auto V = [&](bool faces_up, bool is_double_sided, bool passes) {
                return V_under({faces_up, is_double_sided, is_mirrored}, passes, visibility);
            };
            EXPECT_NEAR(V(false, false, true), 1.0f, 1e-4f) << "met from behind";
            EXPECT_EQ(V(true, false, true), 0.0f) << "met at its front";
            EXPECT_EQ(V(false, true, true), 0.0f) << "double-sided";
            EXPECT_EQ(V(false, false, false), 0.0f) << "a light of the file";
        }
});

// A mask that cuts nothing away is a sheet like any other.
const Test masked("law.shadow.light_passes_back_faces_of_masks", [] {
    for (const Visibility visibility : each_provider) {
        EXPECT_NEAR(V_under({false, false, false, scene::AlphaMode::mask}, true, visibility), 1.0f, 1e-4f);
        EXPECT_EQ(V_under({true, false, false, scene::AlphaMode::mask}, true, visibility), 0.0f);
    }
});

// Along each axis, so that every face of a cube of depth maps has its turn.
const Test around("law.shadow.light_passes_back_faces_on_every_side", [] {
    for (const Visibility visibility : each_provider)
        for (const bool is_inside_out : {false, true}) {
            scene::Scene scene = lambert_plane(2.0f);
            scene.instances[0].world_from_object[3].y = -1.5f;
            const float side = is_inside_out ? -1.0f : 1.0f;
            add_box(scene, vec3(0.0f), mat3(vec3(0.5f, 0, 0), vec3(0, 0.5f * side, 0), vec3(0, 0, 0.5f)), 1,
                    lambert());
            if (is_inside_out) // the axes are left-handed, and so are the triangles
                for (vec3& normal : scene.meshes[1].normals) normal = -normal;
            auto sphere_of_panels = std::vector<scene::Light>{};
            for (int axis = 0; axis < 3; ++axis)
                for (const float way : {-1.0f, 1.0f}) {
                    vec3 out(0.0f), u(0.0f);
                    out[axis] = way;
                    u[(axis + 1) % 3] = 0.3f;
                    scene::RectangleLight light{"", 1.4f * out, u, -glm::cross(out, u), vec3(10.0f)};
                    light.passes_back_faces = true;
                    sphere_of_panels.emplace_back(light);
                }
            const auto camera = camera_from_above(1.9f);
            const auto image = picture(scene, sphere_of_panels, camera, 32, 8, 0, visibility);
            const auto open = picture(scene, sphere_of_panels, camera, 32, 8, 0, Visibility::none);
            auto blocked_lights = sphere_of_panels;
            for (scene::Light& light : blocked_lights)
                std::get<scene::RectangleLight>(light).passes_back_faces = false;
            const auto blocked = picture(scene, blocked_lights, camera, 32, 8, 0, visibility);
            double sum = 0.0, open_sum = 0.0, blocked_sum = 0.0;
            for (std::size_t i = 0; i < image.pixels.size(); i += 4)
                sum += image.pixels[i], open_sum += open.pixels[i], blocked_sum += blocked.pixels[i];
            if (is_inside_out) // every side is met from behind once, and at its front on the way out
                EXPECT_GT(sum, 1.02 * blocked_sum);
            else
                EXPECT_NEAR(sum / blocked_sum, 1.0, 2e-3)
                    << "a closed box casts the shadow that it always did";
            EXPECT_LT(blocked_sum, open_sum);
        }
});

} // namespace
