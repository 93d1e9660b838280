#include "mitsuba/write.hpp"

#include "core/error.hpp"
#include "mitsuba/emitters.hpp"
#include "mitsuba/new_folder.hpp"
#include "mitsuba/plugin_files.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::mitsuba {
namespace {

void write_integrator(Xml& xml, const scene::Scene& scene) {
    xml.open("integrator", "direct"); // one point of an emitter and one of the BRDF a sample
    if (hides_emitters(scene)) xml.flag("hide_emitters", true);
    xml.close();
}

std::vector<std::string> collected(const Output& output) {
    std::vector<std::string> all = output.warnings;
    for (const auto* list : {&output.materials.warnings(), &output.textures.warnings()})
        all.insert(all.end(), list->begin(), list->end());
    return all;
}

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

/// Writes the <sensor>: the same view as the renderer's, a box filter of one pixel, linear RGB in 32-bit
/// floats. `width` and `height` are those of the picture [pixels].
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

} // namespace

std::vector<std::string> write(const Subject& subject, const std::filesystem::path& folder) {
    require(subject.width > 0 && subject.height > 0, "the picture has pixels");
    NewFolder place(folder);
    Output output{subject.scene, place.path()};
    output.xml.open("scene");
    write_integrator(output.xml, subject.scene);
    write_sensor(output.xml, subject.camera, subject.width, subject.height);
    write_instances(output);
    write_emitters(output);
    output.xml.close();
    write_text(place.path() / "scene.xml", output.xml.result());
    for (const PluginFile& file : plugin_files()) {
        make_folder((place.path() / file.name).parent_path());
        write_text(place.path() / file.name, file.text);
    }
    place.put_in_place();
    return collected(output);
}

} // namespace sr::mitsuba
