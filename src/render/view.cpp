#include "render/view.hpp"

namespace sr::render {
namespace {

// glTF 2.0, section 3.10.3: the projection matrices, here with the scales worked out beforehand.

mat4 perspective_matrix(const scene::Perspective& p, float scale_x, float scale_y) {
    mat4 m(0.0f);
    m[0][0] = scale_x;
    m[1][1] = scale_y;
    m[2][3] = -1.0f;
    if (p.zfar) {
        m[2][2] = (*p.zfar + p.znear) / (p.znear - *p.zfar);
        m[3][2] = 2.0f * *p.zfar * p.znear / (p.znear - *p.zfar);
    } else {
        m[2][2] = -1.0f;
        m[3][2] = -2.0f * p.znear;
    }
    return m;
}

mat4 orthographic_matrix(const scene::Orthographic& o, float scale_x, float scale_y) {
    mat4 m(1.0f);
    m[0][0] = scale_x;
    m[1][1] = scale_y;
    m[2][2] = 2.0f / (o.znear - o.zfar);
    m[3][2] = (o.zfar + o.znear) / (o.znear - o.zfar);
    return m;
}

} // namespace

View view_of(const scene::Camera& camera, int width, int height, vec2 sub_pixel) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const vec2 half = scene::half_extent(camera, aspect);
    const mat4& world_from_camera = camera.world_from_camera;
    View view;
    mat4 clip_from_camera(1.0f);
    if (const auto* p = std::get_if<scene::Perspective>(&camera.projection)) {
        clip_from_camera = perspective_matrix(*p, 1.0f / half.x, 1.0f / half.y);
        view.eye = world_from_camera[3];
    } else {
        const auto& o = std::get<scene::Orthographic>(camera.projection);
        clip_from_camera = orthographic_matrix(o, 1.0f / half.x, 1.0f / half.y);
        view.eye = vec4(glm::normalize(vec3(world_from_camera[2])), 0.0f);
    }
    // Moving the picture by minus the offset puts the wanted point of each pixel under its centre.
    const vec2 offset = sub_pixel - 0.5f;
    mat4 shift(1.0f);
    shift[3][0] = -2.0f * offset.x / static_cast<float>(width);
    shift[3][1] = 2.0f * offset.y / static_cast<float>(height);
    view.clip_from_world = shift * clip_from_camera * glm::inverse(world_from_camera);
    return view;
}

} // namespace sr::render
