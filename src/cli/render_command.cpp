#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/layers.hpp"
#include "cli/open_scene.hpp"
#include "cli/progress.hpp"
#include "cli/render_options.hpp"
#include "cli/summary.hpp"
#include "core/error.hpp"
#include "render/renderer.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace sr::cli {
namespace {

/// @return whether all samples were taken; false if Ctrl-C was pressed.
bool add_samples(render::Renderer& renderer, int count, const std::string& what = "rendering") {
    const Interruption interruption;
    Progress progress(what, count);
    while (renderer.sample_count() < count && !interruption.has_come()) {
        renderer.add_sample();
        glFinish(); // so that Ctrl-C and the progress bar mean what they say
        progress.update(renderer.sample_count());
    }
    return renderer.sample_count() == count;
}

const char* name_of(render::Estimator estimator) {
    return estimator == render::Estimator::analytic ? "analytic" : "sampled";
}

void describe(image::Image& film, const RenderCommand& command, const scene::Stage& stage,
              const gl::ContextInfo& gl) {
    film.channel_names = {"R", "G", "B", "A"};
    film.attributes = {{"steradian:version", STERADIAN_VERSION},
                       {"steradian:unit", std::string(scene::radiance_unit(stage.scene.units))},
                       {"steradian:estimator", name_of(command.estimator)},
                       {"steradian:visibility", std::string(render::name_of(command.visibility))},
                       {"steradian:samples", std::to_string(command.samples)},
                       {"steradian:seed", std::to_string(command.seed)},
                       {"steradian:camera", stage.camera.name},
                       {"steradian:GL_RENDERER", gl.renderer},
                       {"steradian:GL_VERSION", gl.version}};
    if (command.at) film.attributes.push_back({"steradian:time", fmt::format("{:.9g} s", *command.at)});
    if (command.estimator == render::Estimator::analytic)
        film.attributes.push_back({"steradian:analytic_points", std::to_string(command.analytic_points)});
}

/// Says why a picture is black, and if it has holes.
void remark_on(const image::Image& film, const RenderCommand& command, const scene::Stage& stage) {
    std::size_t covered = 0, lit = 0, broken = 0;
    for (std::size_t i = 0; i < film.pixels.size(); i += 4) {
        const vec3 L(film.pixels[i], film.pixels[i + 1], film.pixels[i + 2]);
        covered += film.pixels[i + 3] > 0.0f;
        lit += L.r > 0.0f || L.g > 0.0f || L.b > 0.0f;
        broken += !std::isfinite(L.r + L.g + L.b);
    }
    const auto& file = command.scene;
    if (broken > 0)
        fmt::print(stderr, "{}: {} pixels are not finite: they are magenta in .png and .jpg\n", file, broken);
    if (stage.scene.instances.empty()) return; // the loader has said so
    if (covered == 0)
        fmt::print(stderr, "{}: camera '{}' sees no surface: --camera auto frames the scene\n", file,
                   stage.camera.name);
    else if (lit == 0)
        fmt::print(stderr, "{}: no light reaches what camera '{}' sees: the picture is black\n", file,
                   stage.camera.name);
}

bool holds_layers(const std::string& output) { return output.ends_with(".exr") || output.ends_with(".EXR"); }

/// Writes the film in the form that each file's extension asks for. @return the EV100 in use, if any was.
std::optional<float> write_outputs(const image::Image& film, const std::optional<image::Image>& layers,
                                   const RenderCommand& command) {
    std::optional<float> ev100;
    for (const std::string& output : command.outputs) {
        if (image::is_scene_referred(output)) {
            image::write(layers && holds_layers(output) ? *layers : film, output, command.exr_type);
            continue;
        }
        if (!ev100) ev100 = command.ev100 ? *command.ev100 : image::auto_ev100(film);
        image::Image picture = image::displayed(film, *ev100, command.tone_curve);
        picture.attributes = film.attributes;
        image::write(picture, output, image::SampleType::integer8);
    }
    return ev100;
}

using nlohmann::ordered_json;

ordered_json summary(const RenderCommand& command, const scene::Stage& stage, const gl::Context& context,
                     Size size) {
    return {{"scene", command.scene},
            {"outputs", command.outputs},
            {"width", size.width},
            {"height", size.height},
            {"estimator", name_of(command.estimator)},
            {"samples", command.samples},
            {"seed", command.seed},
            {"unit", scene::radiance_unit(stage.scene.units)},
            {"camera", stage.camera.name},
            {"lights", stage.lights.size()},
            {"triangles", scene::triangle_count(stage.scene)},
            {"backend", context.info().backend},
            {"GL_RENDERER", context.info().renderer},
            {"GL_VERSION", context.info().version}};
}

/// How V was found; null where nothing casts shadows.
ordered_json shadows(const render::GpuScene& scene, const render::Renderer& renderer) {
    const render::Occluders* occluders = scene.occluders();
    if (!occluders) return nullptr;
    const render::RayAnswers* answers = renderer.ray_answers();
    ordered_json json{{"by", answers ? "cpu" : "glsl"},
                      {"bvh_triangles", occluders->triangle_count()},
                      {"bvh_nodes", occluders->node_count()},
                      {"build_seconds", occluders->build_seconds()}};
    if (answers && answers->seconds() > 0.0) {
        json["rays"] = answers->ray_count();
        json["rays_per_second"] = static_cast<double>(answers->ray_count()) / answers->seconds();
    }
    return json;
}

ordered_json seconds(const PhaseTimes& times) {
    ordered_json json = ordered_json::object();
    for (const auto& [phase, duration] : times.phases()) json[phase] = json.value(phase, 0.0) + duration;
    json["total"] = times.total();
    return json;
}

/// Takes the samples and writes the files. @return absent if Ctrl-C was pressed: then nothing was written;
/// else the EV100 in use, if any was
std::optional<std::optional<float>> make_picture(const RenderCommand& command, const OpenScene& open,
                                                 render::Renderer& renderer, const std::string& what,
                                                 PhaseTimes& times) {
    const auto interrupted_at = [&](const std::string& when) {
        fmt::print(stderr, "interrupted{}: nothing was written\n", when);
        return std::nullopt;
    };
    if (!add_samples(renderer, command.samples, what))
        return interrupted_at(
            fmt::format(" after {} of {} samples", renderer.sample_count(), command.samples));
    times.end("draw");
    image::Image film = renderer.film();
    open.context->require_silence();
    times.end("read");
    remark_on(film, command, open.stage);
    describe(film, command, open.stage, open.context->info());
    std::optional<image::Image> layers;
    if (command.light_layers) {
        layers = with_layers(film, layer_names(open.stage.lights), renderer, [&](const std::string& layer) {
            return add_samples(renderer, command.samples, layer);
        });
        if (!layers) return interrupted_at("");
        times.end("layers");
    }
    const auto ev100 = write_outputs(film, layers, command);
    times.end("write");
    return ev100;
}

/// Writes every frame; automatic exposure is that of the first. @return the files, fewer if Ctrl-C was
/// pressed
std::vector<std::string> make_frames(const RenderCommand& command, OpenScene& open,
                                     render::GpuScene& gpu_scene, render::Renderer& renderer,
                                     PhaseTimes& times) {
    std::vector<std::string> written;
    RenderCommand picture = command;
    for (const int frame : open.frames) {
        if (frame != open.frames.front()) {
            show_frame(open, command, frame);
            times.end("pose");
            gpu_scene.update(open.stage.scene, open.stage.lights);
            renderer.restart(open.stage.camera);
            times.end("update");
        }
        picture.at = seconds_of(frame, command);
        for (std::size_t i = 0; i < command.outputs.size(); ++i)
            picture.outputs[i] = *numbered(command.outputs[i], frame);
        const auto what = fmt::format("frame {} of {}", frame - open.frames.front() + 1, open.frames.size());
        const auto ev100 = make_picture(picture, open, renderer, what, times);
        if (!ev100) break;
        if (*ev100) picture.ev100 = *ev100;
        written.insert(written.end(), picture.outputs.begin(), picture.outputs.end());
    }
    return written;
}

void check_outputs(const RenderCommand& command) {
    for (const std::string& output : command.outputs) {
        image::is_scene_referred(output); // refuses unknown formats
        if (command.frames && !numbered(output, 0))
            throw CLI::ValidationError("-o", fmt::format("'{}' has no place for the frame's number: name it "
                                                         "like frame.####.png",
                                                         output));
    }
    if (command.light_layers && std::ranges::none_of(command.outputs, holds_layers))
        throw CLI::ValidationError("--layers", "only .exr files hold layers: name one with -o");
}

ExitStatus render(const RenderCommand& command) {
    PhaseTimes times;
    check_outputs(command);
    OpenScene open = open_scene(command, times);
    render::GpuScene gpu_scene(open.stage.scene, open.stage.lights, command.visibility);
    glFinish();
    times.end("upload");
    if (gpu_scene.occluders()) times.add("bvh (in upload)", gpu_scene.occluders()->build_seconds());
    render::Renderer renderer(gpu_scene, open.stage.camera, render_options(command, open.size));
    renderer.compile();
    times.end("compile");
    std::optional<float> ev100;
    std::vector<std::string> written = command.outputs;
    if (command.frames) {
        written = make_frames(command, open, gpu_scene, renderer, times);
        if (written.size() < open.frames.size() * command.outputs.size()) return interrupted;
    } else {
        const auto picture = make_picture(command, open, renderer, "rendering", times);
        if (!picture) return interrupted;
        ev100 = *picture;
    }

    if (command.json) {
        ordered_json json = summary(command, open.stage, *open.context, open.size);
        json["outputs"] = written;
        json["draw_calls"] = gpu_scene.opaque_draws().size() * 2 + gpu_scene.blended_draws().size();
        json["programs"] = renderer.program_count();
        json["shadows"] = shadows(gpu_scene, renderer);
        if (ev100) json["ev100"] = *ev100;
        json["seconds"] = seconds(times);
        fmt::print("{}\n", json.dump(2, ' ', false, ordered_json::error_handler_t::replace));
    }
    return done;
}

} // namespace

void add_render_command(CLI::App& app) {
    const auto options = std::make_shared<RenderCommand>();
    CLI::App* command = app.add_subcommand("render", "render a glTF scene offscreen, lit by its own lights");
    declare(*command, *options);
    command->callback([options] {
        const ExitStatus status = render(*options);
        if (status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
