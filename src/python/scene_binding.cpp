#include "python/scene_file.hpp"
#include "python/values.hpp"
#include "scene/look_at.hpp"
#include "settings/bad_setting.hpp"
#include "settings/options.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>
#include <utility>

namespace sr::python {
namespace {

using settings::RenderSettings;

/// Options by their keys; each has one text, a list has several.
using OptionTexts = std::map<std::string, std::vector<std::string>>;

/// @throws BadSetting for a text that the option does not take, or an option that there is not
RenderSettings settings_of(const OptionTexts& texts) {
    RenderSettings result;
    for (const auto& [key, values] : texts) {
        const auto all = settings::all_options();
        const auto option = std::ranges::find_if(all, [&](const auto& o) { return o.key == key; });
        if (option == all.end()) throw settings::BadSetting(key, "is no option");
        for (const std::string& value : values)
            if (!option->value.read(option->value, result, value))
                throw settings::BadSetting(key,
                                           fmt::format("'{}' is not {}", value, allowed_by(option->value)));
    }
    if (result.stop.asks_for_error() && !texts.contains("samples")) result.stop.samples = render::max_samples;
    return result;
}

/// @throws BadSetting for a light of another file that cannot leave it
SceneEdits edits_of(const std::optional<std::vector<EditableLight>>& lights,
                    const std::vector<EditableMaterial>& materials, const SceneFile& file) {
    SceneEdits edits{lights, materials};
    if (!lights) return edits;
    for (EditableLight& light : *edits.lights) {
        if (light.file == file.number()) continue;
        if (needs_its_scene(light.light))
            throw settings::BadSetting(
                "lights", fmt::format("'{}' has a profile, a texture or a surface of another scene",
                                      name_of(light.light)));
        light.source = -1;
        const vec3 shift(light.origin - file.origin()); // a new light is relative to the world's origin
        mat4 by(1.0f);
        by[3] = vec4(shift, 1.0f);
        if (shift != vec3(0.0f)) light.light = transformed(light.light, by);
    }
    return edits;
}

nb::dict camera_of(const scene::Camera& camera, const scene::Scene& scene, std::size_t place) {
    const mat4& m = camera.world_from_camera;
    const glm::dvec3 eye = scene.origin + glm::dvec3(m[3]);
    const glm::dvec3 target = eye - glm::dvec3(m[2]);
    nb::dict result;
    result["name"] = camera.name;
    result["number"] = camera.number >= 0 ? camera.number : static_cast<int>(place);
    result["eye"] = nb::make_tuple(eye.x, eye.y, eye.z);
    result["target"] = nb::make_tuple(target.x, target.y, target.z);
    result["up"] = nb::make_tuple(m[1].x, m[1].y, m[1].z);
    if (const auto* p = std::get_if<scene::Perspective>(&camera.projection)) {
        result["fov"] = glm::degrees(static_cast<double>(p->yfov));
        result["near"] = p->znear;
        result["far"] = p->zfar ? nb::cast(*p->zfar) : nb::none();
    } else {
        const auto& o = std::get<scene::Orthographic>(camera.projection);
        result["ymag"] = o.ymag;
        result["near"] = o.znear;
        result["far"] = o.zfar;
    }
    return result;
}

nb::tuple triple(vec3 v) { return nb::make_tuple(v.x, v.y, v.z); }

nb::dict contents_of(const SceneFile& file) {
    const gltf::Contents& contents = file.contents();
    nb::list animations;
    for (const auto& animation : contents.animations)
        animations.append(nb::make_tuple(animation.name, animation.duration));
    nb::list cameras;
    const std::vector<scene::Camera>& all = file.scene().cameras;
    for (std::size_t i = 0; i < all.size(); ++i) cameras.append(camera_of(all[i], file.scene(), i));
    nb::dict result;
    result["animations"] = animations;
    result["variants"] = contents.variants;
    result["cameras"] = cameras;
    result["triangles"] = scene::triangle_count(file.scene());
    result["unit"] = scene::radiance_unit(file.scene().units);
    const scene::Bounds bounds = bounds_of(file.scene());
    const vec3 origin(file.origin());
    result["bounds"] = nb::make_tuple(triple(origin + bounds.min), triple(origin + bounds.max));
    return result;
}

nb::dict terms_of(const ProbedPicture& probed) {
    nb::list lights;
    for (std::size_t k = 0; k < probed.terms.lights.size(); ++k) {
        const render::LightTerms& t = probed.terms.lights[k];
        nb::dict row;
        row["name"] = scene::name_of(probed.lights[k]);
        row["kind"] = scene::variety_of(probed.lights[k]);
        row["solid_angle"] = t.solid_angle;
        row["wi"] = triple(t.wi);
        row["cos_i"] = t.cos_i;
        row["V"] = t.V;
        row["V_rgb"] = triple(t.V_color);
        row["E"] = triple(t.E);
        row["f_r"] = triple(t.f_r);
        row["L_r"] = triple(t.L_r);
        lights.append(row);
    }
    const glm::dvec3 x = probed.origin + glm::dvec3(probed.terms.x);
    nb::dict result;
    result["size"] = nb::make_tuple(probed.size.width, probed.size.height);
    result["camera"] = probed.camera;
    result["x"] = nb::make_tuple(x.x, x.y, x.z);
    result["n"] = triple(probed.terms.n);
    result["wo"] = triple(probed.terms.wo);
    result["coverage"] = probed.terms.coverage;
    result["L_e"] = triple(probed.terms.L_e);
    result["L_o"] = triple(probed.terms.L_o);
    result["lights"] = lights;
    return result;
}

using Lights = std::optional<std::vector<EditableLight>>;
using Materials = std::vector<EditableMaterial>;

std::shared_ptr<SceneFile> load(const std::string& path, const OptionTexts& options) {
    const RenderSettings settings = settings_of(options);
    const auto loaded = std::make_shared<std::shared_ptr<SceneFile>>();
    run_aside([=](Call&) { *loaded = std::make_shared<SceneFile>(path, settings); });
    return *loaded;
}

RenderedPicture render(SceneFile& file, const OptionTexts& options, const Lights& lights,
                       const Materials& materials, const nb::object& progress) {
    const RenderSettings settings = settings_of(options);
    const SceneEdits edits = edits_of(lights, materials, file);
    std::optional<RenderedPicture> rendered;
    GlThread::only().run([&](Call& call) { rendered = file.render(settings, edits, call); }, progress);
    return *std::move(rendered);
}

nb::dict probe(SceneFile& file, int column, int row, const OptionTexts& options, const Lights& lights,
               const Materials& materials) {
    const RenderSettings settings = settings_of(options);
    const SceneEdits edits = edits_of(lights, materials, file);
    std::optional<ProbedPicture> probed;
    GlThread::only().run([&](Call& call) { probed = file.probe(settings, edits, column, row, call); });
    return terms_of(probed.value());
}

nb::dict camera_named(SceneFile& file, const std::string& camera, const Lights& lights,
                      const Materials& materials) {
    const SceneEdits edits = edits_of(lights, materials, file);
    scene::Camera chosen;
    scene::Scene place; // for its origin
    place.origin = file.origin();
    GlThread::only().run([&](Call&) { chosen = file.camera(camera, edits); });
    nb::dict result = camera_of(chosen, place, 0);
    if (chosen.number < 0) result["number"] = nb::none();
    return result;
}

void save_copy(SceneFile& file, const std::string& target, const std::string& camera, const Lights& lights,
               const Materials& materials) {
    const SceneEdits edits = edits_of(lights, materials, file);
    GlThread::only().run([&](Call&) { file.save(target, edits, camera); });
}

std::vector<std::string> warnings_of(const SceneFile& file) {
    std::vector<std::string> warnings;
    GlThread::only().run([&](Call&) { warnings = file.warnings(); });
    return warnings;
}

nb::list table_of_options() {
    nb::list table;
    for (const settings::Option& option : settings::all_options()) {
        nb::dict row;
        row["key"] = option.key;
        row["type"] = settings::type_of(option.value);
        row["is_flag"] = option.value.kind == settings::Value::Kind::flag;
        row["help"] = option.help;
        row["default"] = settings::default_of(option);
        row["of_render"] = (option.takers & settings::by_render) != 0;
        row["of_probe"] = (option.takers & settings::by_probe) != 0;
        table.append(row);
    }
    return table;
}

} // namespace

void bind_scene(nb::module_& m) {
    m.def("options", &table_of_options, "The table of options: a dict each.");
    m.def("load", &load);
    nb::class_<SceneFile>(m, "SceneFile")
        .def_prop_ro("file", &SceneFile::file)
        .def("contents", &contents_of)
        .def("warnings", &warnings_of)
        .def("lights", [](const SceneFile& file) { return lights_of(file.scene(), file.number()); })
        .def("materials", [](const SceneFile& file) { return materials_of(file.scene()); })
        .def("render", &render, nb::arg("options"), nb::arg("lights").none(), nb::arg("materials"),
             nb::arg("progress").none())
        .def("probe", &probe, nb::arg("column"), nb::arg("row"), nb::arg("options"), nb::arg("lights").none(),
             nb::arg("materials"))
        .def("camera", &camera_named, nb::arg("camera"), nb::arg("lights").none(), nb::arg("materials"))
        .def("save", &save_copy, nb::arg("target"), nb::arg("camera"), nb::arg("lights").none(),
             nb::arg("materials"));
}

} // namespace sr::python
