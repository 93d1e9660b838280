#include "render/view.hpp"

#include "support/address.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using sr::testing::Test;

namespace {

scene::Camera perspective(std::optional<float> aspect, std::optional<float> zfar) {
    scene::Camera camera;
    camera.projection = scene::Perspective{1.0f, aspect, 0.5f, zfar};
    return camera;
}

vec3 projected(const render::View& view, vec3 p) {
    const vec4 clip = view.clip_from_world * vec4(p, 1.0f);
    return vec3(clip) / clip.w;
}

const Test depth("unit.render.view.near_and_far_reach_the_ends_of_clip_space", [] {
    const auto view = render::view_of(perspective(std::nullopt, 10.0f), 100, 100, vec2(0.5f));
    EXPECT_NEAR(projected(view, {0, 0, -0.5f}).z, -1.0f, 1e-5f);
    EXPECT_NEAR(projected(view, {0, 0, -10.0f}).z, 1.0f, 1e-5f);
    const auto endless = render::view_of(perspective(std::nullopt, std::nullopt), 100, 100, vec2(0.5f));
    EXPECT_NEAR(projected(endless, {0, 0, -0.5f}).z, -1.0f, 1e-5f);
    EXPECT_NEAR(projected(endless, {0, 0, -1e6f}).z, 1.0f, 1e-5f);
});

const Test fits("unit.render.view.the_cameras_frame_is_wholly_in_the_picture", [] {
    const float tan_y = std::tan(0.5f);
    const auto corner = [&](float x, float y) { return vec3(2.0f * tan_y * x, tan_y * y, -1.0f); };
    for (const auto& [width, height] : {std::pair{200, 100}, {100, 100}, {400, 100}}) {
        const auto view = render::view_of(perspective(2.0f, 10.0f), width, height, vec2(0.5f));
        const vec3 p = projected(view, corner(1, 1));
        EXPECT_LE(p.x, 1.0f + 1e-5f);
        EXPECT_LE(p.y, 1.0f + 1e-5f);
        EXPECT_NEAR(std::max(p.x, p.y), 1.0f, 1e-5f) << "as large as it fits";
        EXPECT_NEAR(p.x / p.y, 2.0f * static_cast<float>(height) / static_cast<float>(width), 1e-5f)
            << "and undistorted";
    }
});

// A point at the upper left of a pixel appears at the pixel's centre if that is where the sample is to look.
const Test offset("unit.render.view.sub_pixel_points_right_and_down", [] {
    const auto centre = render::view_of(perspective(std::nullopt, 10.0f), 100, 50, vec2(0.5f));
    const auto moved = render::view_of(perspective(std::nullopt, 10.0f), 100, 50, vec2(0.75f, 0.25f));
    const vec3 a = projected(centre, {0.1f, 0.1f, -2.0f}), b = projected(moved, {0.1f, 0.1f, -2.0f});
    EXPECT_NEAR((a.x - b.x) * 100 / 2, 0.25f, 1e-5f);
    EXPECT_NEAR((a.y - b.y) * 50 / 2, 0.25f, 1e-5f);
});

} // namespace
