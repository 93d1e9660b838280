// Depth of the surfaces in a picture: what lies behind them is hidden.
#include "viewer/view/scene_depth.hpp"

#include "support/address.hpp"
#include "support/gl.hpp"
#include "viewer/document/loaded_scene.hpp"
#include "viewer/view/projection.hpp"

#include <filesystem>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

const std::filesystem::path scenes = STERADIAN_SCENES;

const Test hidden("unit.viewer.depth.a_point_is_hidden_behind_the_first_surface_along_its_ray", [] {
    sr::testing::context();
    const LoadedScene loaded = load_scene(scenes / "spheres.gltf", {}, 4.0f / 3.0f);
    const render::GpuScene gpu(loaded.stage.scene, loaded.stage.lights, render::Visibility::none, false);
    const scene::Camera& camera = loaded.stage.scene.cameras.front();
    SceneDepth depth;
    EXPECT_FALSE(depth.hides(vec3(0.0f))) << "nothing is known yet";
    depth.update(gpu, camera, 160, 120);
    int tried = 0;
    for (float y = 0.1f; y < 1.0f; y += 0.1f)
        for (float x = 0.1f; x < 1.0f; x += 0.1f) {
            const PickRay ray = ray_through(camera, 4.0f / 3.0f, {x, y});
            const auto hit = first_hit(loaded.stage.scene, ray);
            if (!hit) continue;
            ++tried;
            EXPECT_FALSE(depth.hides(ray.origin + 0.98f * hit->distance * ray.direction)) << x << " " << y;
            EXPECT_FALSE(depth.hides(hit->point)) << "on the surface " << x << " " << y;
        }
    EXPECT_GT(tried, 40);
    const PickRay middle = ray_through(camera, 4.0f / 3.0f, {0.5f, 0.9f}); // the front of the lowest step
    const auto hit = first_hit(loaded.stage.scene, middle);
    ASSERT_TRUE(hit);
    EXPECT_TRUE(depth.hides(middle.origin + 1.2f * hit->distance * middle.direction));
});

} // namespace
