// Cameras of the viewer: what each move keeps.
#include "core/error.hpp"
#include "scene/look_at.hpp"
#include "support/address.hpp"
#include "viewer/bindings.hpp"
#include "viewer/tools/navigate.hpp"

#include <algorithm>
#include <cmath>
#include <random>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

constexpr float aspect = 1.5f;
const scene::Bounds box{vec3(-1.0f, 0.0f, -2.0f), vec3(3.0f, 1.0f, 2.0f)};

scene::Camera camera_of(const Viewpoint& view) { return scene::camera_at(look_at(view), box, aspect); }

Viewpoint any_view(std::mt19937& random) {
    std::uniform_real_distribution<float> number(-1.0f, 1.0f);
    Viewpoint view;
    view.pivot = vec3(number(random), number(random), number(random));
    view.turn = glm::normalize(quat(number(random), number(random), number(random), number(random)));
    view.distance = 3.0f + number(random);
    view.yfov = 0.8f + 0.3f * number(random);
    view.is_orthographic = number(random) > 0.5f;
    return view;
}

void expect_near(vec3 a, vec3 b, float tolerance) { EXPECT_LT(glm::distance(a, b), tolerance); }

// Copied words are the camera itself, so that `render --camera` makes the very picture of the window.
const Test words("unit.scene.look_at.words_are_the_camera_to_the_last_bit", [] {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const scene::LookAt view = look_at(any_view(random));
        const scene::LookAt read = scene::parse_look_at(scene::text_of(view));
        ASSERT_EQ(read.eye, view.eye);
        ASSERT_EQ(read.target, view.target);
        ASSERT_EQ(read.up, view.up);
        ASSERT_EQ(read.ymag, view.ymag);
        ASSERT_TRUE(view.ymag || read.yfov == view.yfov);
    }
});

const Test bad_words("unit.scene.look_at.says_what_is_wrong", [] {
    const auto complaint = [](const char* text) -> std::string {
        try {
            scene::parse_look_at(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(complaint(" eye = 0,0,5 ; target = 0,0,0 ; fov = 40 ; "), "none");
    EXPECT_NE(complaint("eye=0,0,5;target=0,0").find("target takes three numbers"), std::string::npos);
    EXPECT_NE(complaint("eye=0,0,x;target=0,0,0").find("'x', which is no number"), std::string::npos);
    EXPECT_NE(complaint("eye=0,0,5").find("both needed"), std::string::npos);
    EXPECT_NE(complaint("eye=0,0,5;target=0,0,5").find("same point"), std::string::npos);
    EXPECT_NE(complaint("eye=0,5,0;target=0,0,0").find("up points along"), std::string::npos);
    EXPECT_NE(complaint("eye=0,0,5;target=0,0,0;fov=200").find("field of view"), std::string::npos);
    EXPECT_NE(complaint("eye=0,0,5;target=0,0,0;zoom=2").find("no 'zoom'"), std::string::npos);
});

const Test viewpoint_round_trip("unit.viewer.viewpoint.is_the_camera_it_was_taken_from", [] {
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
        const scene::Camera camera = camera_of(any_view(random));
        const scene::Camera again = camera_of(viewpoint_of(camera, aspect, vec3(0.0f)));
        for (const vec3 corner : {box.min, box.max, box.center()}) {
            const auto a = projected(camera, aspect, corner), b = projected(again, aspect, corner);
            ASSERT_EQ(a.has_value(), b.has_value());
            ASSERT_TRUE(!a || glm::distance(*a, *b) < 2e-4f * (1.0f + glm::length(*a)));
        }
    }
});

const Test moves("unit.viewer.viewpoint.keeps_what_each_move_should", [] {
    std::mt19937 random(3);
    for (int i = 0; i < 100; ++i) {
        const Viewpoint start = any_view(random);
        Viewpoint view = start;
        orbit(view, {0.3f, -0.2f});
        EXPECT_EQ(view.pivot, start.pivot);
        EXPECT_EQ(view.distance, start.distance);
        EXPECT_GT(glm::distance(view.eye(), start.eye()), 0.1f);

        view = start;
        pan(view, {0.1f, 0.2f}); // heights of the picture
        const auto place = projected(camera_of(view), aspect, start.pivot);
        ASSERT_TRUE(place);
        EXPECT_NEAR(place->x, 0.5f + 0.1f / aspect, 1e-4f);
        EXPECT_NEAR(place->y, 0.5f + 0.2f, 1e-4f);

        view = start;
        const vec3 point = start.pivot + 0.3f * start.right() - 0.2f * start.up() + 0.1f * start.back();
        const auto before = projected(camera_of(view), aspect, point);
        dolly_to(view, 0.5f, point);
        EXPECT_LT(glm::distance(*before, *projected(camera_of(view), aspect, point)), 1e-4f);
        EXPECT_NEAR(glm::distance(view.eye(), point), 0.5f * glm::distance(start.eye(), point), 1e-4f);

        view = start;
        look_around(view, {0.4f, 0.1f});
        expect_near(view.eye(), start.eye(), 1e-5f);

        view = start;
        level(view);
        EXPECT_NEAR(view.right().y, 0.0f, 1e-5f);
        expect_near(view.back(), start.back(), 1e-5f);
    }
});

const Test framing("unit.viewer.viewpoint.frames_everything_and_little_more", [] {
    std::mt19937 random(4);
    for (const float shape : {0.5f, 1.5f}) {
        Viewpoint view = any_view(random);
        view.is_orthographic = false;
        frame(view, box, shape);
        float farthest = 0.0f;
        for (int corner = 0; corner < 8; ++corner) {
            const vec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                         corner & 4 ? box.max.z : box.min.z);
            const auto place = projected(scene::camera_at(look_at(view), box, shape), shape, p);
            ASSERT_TRUE(place);
            const vec2 off = glm::abs(*place - 0.5f);
            farthest = std::max({farthest, off.x, off.y});
        }
        EXPECT_LE(farthest, 0.5f);
        EXPECT_GT(farthest, 0.2f);
    }
});

const Test rays("unit.viewer.viewpoint.rays_go_through_their_pixels", [] {
    std::mt19937 random(5);
    for (int i = 0; i < 100; ++i) {
        const scene::Camera camera = camera_of(any_view(random));
        const vec2 place(0.3f, 0.8f);
        const PickRay ray = ray_through(camera, aspect, place);
        const auto seen = projected(camera, aspect, ray.origin + 2.0f * ray.direction);
        ASSERT_TRUE(seen);
        EXPECT_LT(glm::distance(*seen, place), 1e-4f);
    }
});

const Test click_and_drag("unit.viewer.navigation.a_click_is_no_drag", [] {
    Navigation navigation;
    Viewpoint view;
    const auto nothing = [](vec2) { return std::optional<vec3>{}; };
    const auto take = [&](const Event& event) { return navigation.handle(event, view, {100, 100}, nothing); };
    take(MotionEvent{{50, 50}});
    take(ButtonEvent{Button::left, no_modifier, true});
    EXPECT_FALSE(take(MotionEvent{{52, 51}}).has_moved);
    EXPECT_EQ(take(ButtonEvent{Button::left, no_modifier, false}).clicked, vec2(52, 51));
    take(ButtonEvent{Button::left, no_modifier, true});
    EXPECT_TRUE(take(MotionEvent{{60, 51}}).has_moved);
    EXPECT_FALSE(take(ButtonEvent{Button::left, no_modifier, false}).clicked);
});

const Test inertia("unit.viewer.navigation.glides_only_if_asked_and_let_go_in_motion", [] {
    const auto nothing = [](vec2) { return std::optional<vec3>{}; };
    const auto frames_of_gliding = [&](bool has_inertia, double last_frame, float by) {
        Navigation navigation(has_inertia);
        Viewpoint view;
        const auto take = [&](const Event& event) { navigation.handle(event, view, {100, 100}, nothing); };
        take(MotionEvent{{50, 50}});
        take(ButtonEvent{Button::left, shift, true});
        for (int i = 1; i <= 10; ++i) {
            take(MotionEvent{{50.0f + by * static_cast<float>(i), 50}});
            navigation.advance(i < 10 ? 0.02 : last_frame, view);
        }
        take(ButtonEvent{Button::left, shift, false});
        int frames = 0;
        for (float before = view.pivot.x; navigation.advance(0.02, view); before = view.pivot.x, ++frames)
            EXPECT_GT((view.pivot.x - before) * -by, 0.0f) << "it glides on in the direction of the drag";
        EXPECT_FALSE(navigation.is_gliding());
        return frames;
    };
    EXPECT_EQ(frames_of_gliding(false, 0.02, 4.0f), 0);
    EXPECT_GT(frames_of_gliding(true, 0.02, 4.0f), 10);
    EXPECT_GT(frames_of_gliding(true, 0.02, 4.0f), frames_of_gliding(true, 0.02, 1.0f));
    EXPECT_EQ(frames_of_gliding(true, 10.0, 4.0f), 0) << "the pointer rested before the release";
});

constexpr double frame = 0.05; // [s] that is aimed at

/// Scales of a machine that takes `whole` seconds for the whole picture, `fixed` for any, and `others`
/// besides.
std::vector<float> scales(double whole, double fixed, double others, int frames) {
    Resolution resolution(frame);
    std::vector<float> result;
    for (int i = 0; i < frames; ++i) {
        resolution.took_besides(others);
        resolution.took(fixed + whole * resolution.scale() * resolution.scale());
        result.push_back(resolution.scale());
    }
    return result;
}

const Test resolution("unit.viewer.resolution.shrinks_soon_returns_and_is_steady", [] {
    EXPECT_EQ(scales(0.01, 0.001, 0.0, 20).back(), 1.0f);
    for (const double whole : {0.05, 0.2, 0.5, 1.0, 1.6})
        for (const double others : {0.0, 0.01, 0.025}) {
            const auto scale = scales(whole, 0.004, others, 80);
            const auto whole_frame = [&](std::size_t i) {
                return 0.004 + whole * scale[i] * scale[i] + others;
            };
            EXPECT_LE(whole_frame(3), 0.066) << whole << ": four frames are enough";
            EXPECT_LE(whole_frame(79), 0.060) << whole << ": above 15 frames a second";
            EXPECT_TRUE(whole_frame(79) >= 0.030 || scale[79] == 1.0f)
                << whole << ": not smaller than it must be";
            EXPECT_EQ(scale[50], scale[79]) << whole << ": no back and forth";
        }
    Resolution back(frame);
    for (int i = 0; i < 5; ++i) back.took(0.4);
    EXPECT_EQ(back.scale(), 0.125f);
    for (int i = 0; i < 80; ++i) back.took(0.002);
    EXPECT_EQ(back.scale(), 1.0f);
});

const Test one_late_frame("unit.viewer.resolution.a_single_late_frame_is_no_reason", [] {
    Resolution picture(frame);
    for (int i = 0; i < 30; ++i) picture.took(i % 3 == 0 ? 0.09 : 0.04);
    EXPECT_EQ(picture.scale(), 0.25f);
    picture.took(0.09);
    picture.took(0.09);
    EXPECT_LT(picture.scale(), 0.25f);
});

} // namespace
