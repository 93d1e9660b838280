#include "mitsuba/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::mitsuba {
namespace {

/// Mitsuba's cameras look along +Z with +X to the left of the picture.
mat4 world_from_sensor(const mat4& world_from_camera) {
    return world_from_camera * glm::scale(mat4(1.0f), vec3(-1.0f, 1.0f, -1.0f));
}

void write_film(Xml& xml, int width, int height) {
    xml.open("film", "hdrfilm");
    xml.whole("width", width);
    xml.whole("height", height);
    xml.text("pixel_format", "rgb");
    xml.text("component_format", "float32");
    xml.open("rfilter", "box");
    xml.close();
    xml.close();
    xml.open("sampler", "independent");
    xml.whole("sample_count", 64);
    xml.close();
}

} // namespace

void write_sensor(Xml& xml, const scene::Camera& camera, int width, int height) {
    const vec2 half = scene::half_extent(camera, static_cast<float>(width) / static_cast<float>(height));
    if (const auto* p = std::get_if<scene::Perspective>(&camera.projection)) {
        xml.open("sensor", "perspective");
        xml.text("fov_axis", "x");
        xml.number("fov", 2.0f * std::atan(half.x) * 180.0f / pi);
        xml.number("near_clip", p->znear);
        constexpr float far_away = 1e6f; // [m]; Mitsuba has no camera without an end
        xml.number("far_clip", p->zfar.value_or(std::max(far_away, 2.0f * p->znear)));
        xml.transform("to_world", world_from_sensor(camera.world_from_camera));
    } else {
        const auto& o = std::get<scene::Orthographic>(camera.projection);
        xml.open("sensor", "orthographic");
        // Mitsuba's near plane lies in front of the camera, ours may lie at it: the camera steps back.
        constexpr float step = 1.0f; // [m]
        const mat4 back = glm::translate(mat4(1.0f), vec3(0.0f, 0.0f, step));
        xml.number("near_clip", o.znear + step);
        xml.number("far_clip", o.zfar + step);
        // It covers 2 by 2/aspect, which the matrix scales.
        xml.transform("to_world", world_from_sensor(camera.world_from_camera * back)
                                      * glm::scale(mat4(1.0f), vec3(half.x, half.x, 1.0f)));
    }
    write_film(xml, width, height);
    xml.close();
}

} // namespace sr::mitsuba
