#include "picture/summary.hpp"

#include "core/output.hpp"
#include "settings/options.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sr::picture {
namespace {

using nlohmann::ordered_json;
using render::StoppedBy;

/// The value of an option: a text, a number, or true for a flag that is on; null if it is absent.
ordered_json json_of(const settings::Option& option, const RenderSettings& settings) {
    using Kind = settings::Value::Kind;
    const std::string text = option.value.write(settings);
    if (option.value.kind == Kind::flag) return !text.empty();
    if (text.empty()) return nullptr;
    const bool is_number = option.value.kind == Kind::number || option.value.kind == Kind::whole;
    return is_number ? ordered_json::parse(text) : ordered_json(text);
}

ordered_json inputs(const Work& work, const gl::ContextInfo& gl) {
    const RenderSettings& settings = work.settings;
    const scene::RenderScene& stage = work.stage;
    ordered_json json{{"scene", settings.scene},
                      {"outputs", settings.outputs},
                      {"width", work.options.width},
                      {"height", work.options.height}};
    for (const settings::Option& option : settings::all_options())
        if (option.takers & settings::in_json) json[option.key] = json_of(option, settings);
    json.update({{"unit", output::unit_of(settings.view, stage.scene.units)},
                 {"camera", stage.camera.name},
                 {"lights", stage.lights.size()},
                 {"triangles", scene::triangle_count(stage.scene)},
                 {"backend", gl.backend},
                 {"GL_RENDERER", gl.renderer},
                 {"GL_VERSION", gl.version}});
    return json;
}

ordered_json stopping(const Picture& picture) {
    ordered_json json{{"samples", picture.samples.max},
                      {"samples_mean", picture.samples.mean},
                      {"samples_min", picture.samples.min},
                      {"stopped_by", name_of(picture.stop.by)},
                      {"light_choices", picture.light_choices}};
    if (picture.stop.error) json["error"] = *picture.stop.error;
    return json;
}

/// How V was found; null where nothing casts shadows.
ordered_json shadows(const render::GpuScene& scene, const render::Renderer& renderer) {
    const render::VisibilityBackend* occluders = scene.visibility_backend();
    if (!occluders) return nullptr;
    if (const render::DepthMaps* maps = renderer.depth_maps())
        return {{"by", "maps"}, {"maps_a_sample", maps->map_count()}, {"map_size", maps->size()}};
    const std::optional<render::TracedRays> answers = renderer.traced_rays();
    ordered_json json{{"by", answers ? "cpu" : "glsl"},
                      {"bvh_triangles", occluders->triangle_count()},
                      {"bvh_nodes", occluders->node_count()},
                      {"build_seconds", occluders->build_seconds()}};
    if (answers && answers->seconds > 0.0) {
        json["shadings_a_sample"] = renderer.defers_visibility() ? 1 : 2;
        json["rays"] = answers->count;
        json["rays_per_second"] = static_cast<double>(answers->count) / answers->seconds;
    }
    return json;
}

ordered_json seconds(const PhaseTimes& times) {
    ordered_json json = ordered_json::object();
    for (const auto& [phase, duration] : times.phases()) json[phase] = json.value(phase, 0.0) + duration;
    json["total"] = times.total();
    return json;
}

} // namespace

ordered_json summary_of(const Work& work, const gl::Context& context, const Picture& picture) {
    ordered_json json = inputs(work, context.info());
    json.update(stopping(picture));
    json["draw_calls"] = work.scene.opaque_draws().size() * 2 + work.scene.blended_draws().size();
    json["feature_sets"] = work.scene.feature_set_count();
    json["programs"] = work.renderer.program_count();
    json["shadows"] = shadows(work.scene, work.renderer);
    if (picture.ev100) json["ev100"] = *picture.ev100;
    json["seconds"] = seconds(work.times);
    return json;
}

void remark_on(const image::Image& film, const RenderSettings& settings, const scene::RenderScene& stage) {
    std::size_t covered = 0, lit = 0, broken = 0;
    for (std::size_t i = 0; i < film.pixels.size(); i += 4) {
        const vec3 L(film.pixels[i], film.pixels[i + 1], film.pixels[i + 2]);
        covered += film.pixels[i + 3] > 0.0f;
        lit += L.r > 0.0f || L.g > 0.0f || L.b > 0.0f;
        broken += !std::isfinite(L.r + L.g + L.b);
    }
    const auto& file = settings.scene;
    if (broken > 0)
        print_remark("{}: {} pixels are not finite: they are magenta in .png and .jpg", file, broken);
    if (stage.scene.instances.empty()) return; // the loader has said so
    if (covered == 0)
        print_remark("{}: camera '{}' sees no surface: --camera auto frames the scene", file,
                     stage.camera.name);
    else if (lit == 0)
        print_remark("{}: no light reaches what camera '{}' sees: the picture is black", file,
                     stage.camera.name);
}

void remark_on_error(const Picture& picture, const RenderSettings& settings) {
    if (!settings.stop.error || picture.stop.by == StoppedBy::error) return;
    print_remark("{}: stopped by {} after {} samples with an estimated error of {:.3g} %, not {:.3g} %",
                 settings.scene, name_of(picture.stop.by), picture.samples.max,
                 100.0 * picture.stop.error.value_or(INFINITY), 100.0 * *settings.stop.error);
}

} // namespace sr::picture
