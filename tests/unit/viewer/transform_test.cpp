// The transform tool: what the pointer and typed numbers do to a light.
#include "viewer/tools/transform.hpp"

#include "support/address.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/gtc/matrix_transform.hpp>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

const vec3 center(0.2f, 0.1f, -0.3f);

/// From 4 m in front of the centre, a little from above and from the right.
scene::Camera camera() {
    scene::Camera camera;
    camera.world_from_camera =
        glm::inverse(glm::lookAt(center + vec3(1.0f, 1.5f, 3.5f), center, vec3(0, 1, 0)));
    camera.projection = scene::Perspective{0.8f, {}, 0.1f, {}};
    return camera;
}

vec3 applied(const mat4& m, vec3 p) { return vec3(m * vec4(p, 1.0f)); }

const Test turning("unit.viewer.transform.a_ring_turns_what_is_under_the_pointer", [] {
    const scene::Camera eye = camera();
    const Projection projection{eye, 1.5f, {vec2(0.0f), {600.0f, 400.0f}}};
    for (int axis = 0; axis < 3; ++axis) {
        vec3 u(0.0f), about(0.0f);
        about[axis] = 1.0f;
        u[(axis + 1) % 3] = 1.0f;
        TransformDrag drag{.mode = TransformMode::turn, .axis = axis, .center = center};
        drag.from = *projection(center + 0.5f * u);
        for (const float angle : {0.4f, -1.1f}) {
            const mat4 turn = glm::rotate(mat4(1.0f), angle, about);
            const vec2 pointer = *projection(center + 0.5f * applied(turn, u));
            const TransformDelta pull = evaluate(drag, projection, pointer, false);
            EXPECT_LT(glm::distance(applied(pull.transform, center + u), center + applied(turn, u)), 1e-3f)
                << axis;
            EXPECT_LT(glm::distance(applied(pull.transform, center), center), 1e-5f);
        }
    }
    TransformDrag typed{.mode = TransformMode::turn, .axis = 1, .center = center};
    for (const int key : {GLFW_KEY_MINUS, GLFW_KEY_3, GLFW_KEY_0, GLFW_KEY_KP_DECIMAL, GLFW_KEY_5})
        EXPECT_TRUE(type_digit(typed.typed, key));
    EXPECT_FALSE(type_digit(typed.typed, GLFW_KEY_Q));
    const TransformDelta pull = evaluate(typed, projection, {0.0f, 0.0f}, false);
    EXPECT_EQ(pull.description, "turned by -30.5 deg about Y");
    typed.typed.clear();
    typed.from = {300.0f, 300.0f};
    EXPECT_EQ(evaluate(typed, projection, {340.0f, 290.0f}, true).description.find("turned by 1"), 0u)
        << "15 deg, a step";
});

const Test moving("unit.viewer.transform.what_is_moved_stays_under_the_pointer", [] {
    const scene::Camera eye = camera();
    const Projection projection{eye, 1.5f, {vec2(0.0f), {600.0f, 400.0f}}};
    TransformDrag drag{.mode = TransformMode::move, .center = center};
    drag.from = *projection(center);
    const vec2 pointer = drag.from + vec2(70.0f, -20.0f);
    const vec3 there = applied(evaluate(drag, projection, pointer, false).transform, center);
    EXPECT_LT(glm::distance(*projection(there), pointer), 0.1f);
    EXPECT_NEAR(glm::dot(there - center, vec3(eye.world_from_camera[2])), 0.0f, 1e-2f) << "across the view";
    drag.constrain_to(2);
    const vec3 along =
        applied(evaluate(drag, projection, *projection(center + vec3(0, 0, 0.7f)), false).transform, center);
    EXPECT_LT(glm::distance(along, center + vec3(0, 0, 0.7f)), 1e-3f);
});

const Test sizing("unit.viewer.transform.an_edge_goes_to_the_pointer", [] {
    const scene::Camera eye = camera();
    const Projection projection{eye, 1.5f, {vec2(0.0f), {600.0f, 400.0f}}};
    scene::Light light = scene::RectangleLight{"plate", center, {0.4f, 0, 0}, {0, 0.3f, 0}};
    TransformDrag drag{
        .mode = TransformMode::scale, .axis = 0, .center = center, .extents = scene::sizes_of(light)};
    drag.from = *projection(center + vec3(0.4f, 0, 0));
    const TransformDelta pull = evaluate(drag, projection, *projection(center + vec3(0.6f, 0, 0)), false);
    EXPECT_NEAR(pull.size, 1.2f, 1e-3f);
    set_size(light, 0, pull.size);
    EXPECT_NEAR(std::get<scene::RectangleLight>(light).half_u.x, 0.6f, 1e-3f);
    EXPECT_FLOAT_EQ(std::get<scene::RectangleLight>(light).half_v.y, 0.3f);
    drag.constrain_to(2); // a rectangle has no third extent
    EXPECT_FALSE(drag.axis);
});

const Test found("unit.viewer.transform.handles_are_found_where_they_are_drawn", [] {
    const scene::Camera eye = camera();
    const Projection projection{eye, 1.5f, {vec2(0.0f), {600.0f, 400.0f}}};
    const scene::Light light = scene::TubeLight{"tube", center, {0.8f, 0, 0}, 0.4f};
    const Handles handles = handles_of(scene::sizes_of(light), center, true, projection, 1.0f);
    EXPECT_EQ(handles.arrows.size(), 3u);
    EXPECT_EQ(handles.sizes.size(), 4u) << "two for the length, two for the radius";
    ASSERT_TRUE(handles.middle);
    const auto middle = handle_under(*handles.middle, handles);
    ASSERT_TRUE(middle);
    EXPECT_EQ(middle->mode, TransformMode::move);
    EXPECT_LT(middle->axis, 0) << "across the view";
    for (const auto& [at, extent] : handles.sizes) {
        const auto handle = handle_under(at, handles);
        ASSERT_TRUE(handle);
        EXPECT_EQ(handle->mode, TransformMode::scale);
        EXPECT_EQ(handle->axis, extent);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto handle = handle_under(handles.rings[static_cast<std::size_t>(axis)][24], handles);
        ASSERT_TRUE(handle) << axis;
        EXPECT_EQ(handle->mode, TransformMode::turn);
        EXPECT_EQ(handle->axis, axis);
    }
    EXPECT_FALSE(handle_under({5.0f, 5.0f}, handles));
    EXPECT_TRUE(handles_of({}, center, false, projection, 1.0f).arrows.empty()) << "the sun only turns";
});

} // namespace
