#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/open_scene.hpp"
#include "cli/progress.hpp"
#include "cli/render_checks.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "output/channels.hpp"
#include "output/denoise.hpp"
#include "output/write.hpp"
#include "render/adaptive/convergence.hpp"
#include "settings/provenance.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <tuple>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;
using render::max_samples;
using render::StoppedBy;
using render::StopRule;

struct Stop {
    StoppedBy by = StoppedBy::samples;
    std::optional<double> error;                   // √relMSE; absent if the renderer does not know it
    std::optional<render::ErrorEstimate> estimate; // of the final samples
};

/// Returns the completed share of the work, from 0 to 1, by the condition nearest to being met.
double share(const StopRule& rule, int samples, double seconds, double error, double first_error) {
    double part = static_cast<double>(samples) / rule.samples;
    if (rule.seconds) part = std::max(part, seconds / *rule.seconds);
    if (rule.error && first_error > *rule.error) // errors fall by powers
        part = std::max(part, std::log(first_error / error) / std::log(first_error / *rule.error));
    return std::clamp(part, 0.0, 1.0);
}

std::string percent(double error) { return fmt::format("{:.3g} %", 100.0 * error); }

std::string state_of(const render::StopMonitor& monitor, int samples) {
    std::string text = fmt::format("{} samples", samples);
    if (const auto error = monitor.error()) text += ", error " + percent(*error);
    if (monitor.rule().error) text += " of " + percent(*monitor.rule().error);
    return text;
}

/// Adds samples, at least one, until the rule or a stop ends it. The renderer estimates its error if
/// the rule needs it. Shows a progress bar.
Stop add_samples(render::Renderer& renderer, const StopRule& rule, const std::stop_token& stop,
                 const std::string& what) {
    using Clock = std::chrono::steady_clock;
    render::StopMonitor monitor(rule);
    Progress progress(what);
    std::optional<double> first_error;
    do {
        const Clock::time_point begin = Clock::now();
        renderer.add_sample();
        glFinish(); // an interruption, the time and the progress bar count complete samples
        monitor.took_sample(renderer, std::chrono::duration<double>(Clock::now() - begin).count());
        if (!first_error) first_error = monitor.error();
        const int samples = renderer.sample_count();
        const double part = share(rule, samples, monitor.seconds(), monitor.error().value_or(INFINITY),
                                  first_error.value_or(0.0));
        progress.update(part, state_of(monitor, samples));
    } while (!monitor.stopped_by() && !stop.stop_requested());
    monitor.update_error(renderer);
    return {monitor.stopped_by().value_or(StoppedBy::interruption), monitor.error(), monitor.estimate()};
}

/// Repeats the `count` samples that the renderer had before repeat(). @return false if it was stopped
bool add_again(render::Renderer& renderer, int count, const std::stop_token& stop, const std::string& what) {
    Progress progress(what);
    while (renderer.sample_count() < count && !stop.stop_requested()) {
        renderer.add_sample();
        glFinish();
        progress.update(static_cast<double>(renderer.sample_count()) / count,
                        fmt::format("{}/{}", renderer.sample_count(), count));
    }
    return renderer.sample_count() == count;
}

/// Result of a rendering.
struct Picture {
    image::Image film;                  // R, G, B, A
    std::optional<image::Image> layers; // the film and further channels
    settings::SampleCounts samples;
    Stop stop;
    int light_choices = 0; // of a sample; 0: it visits all lights
};

/// Sets the provenance of the images.
void describe(Picture& picture, const RenderCommand& command, const scene::RenderScene& stage,
              const gl::ContextInfo& gl) {
    std::vector<image::Attribute> attributes =
        settings::attributes_of(command,
                                {.unit = output::unit_of(command.view, stage.scene.units),
                                 .camera = stage.camera.name,
                                 .samples = picture.samples,
                                 .error = picture.stop.error,
                                 .stopped_by = picture.stop.by,
                                 .light_choices = picture.light_choices},
                                gl);
    std::ranges::move(output::name_tables(command.aovs, stage.scene), std::back_inserter(attributes));
    picture.film.channel_names = {"R", "G", "B", "A"};
    picture.film.attributes = attributes;
    if (picture.layers) picture.layers->attributes = std::move(attributes);
}

/// Explains black pictures and non-finite pixels on stderr.
void remark_on(const image::Image& film, const RenderCommand& command, const scene::RenderScene& stage) {
    std::size_t covered = 0, lit = 0, broken = 0;
    for (std::size_t i = 0; i < film.pixels.size(); i += 4) {
        const vec3 L(film.pixels[i], film.pixels[i + 1], film.pixels[i + 2]);
        covered += film.pixels[i + 3] > 0.0f;
        lit += L.r > 0.0f || L.g > 0.0f || L.b > 0.0f;
        broken += !std::isfinite(L.r + L.g + L.b);
    }
    const auto& file = command.scene;
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

/// The value of an option: a text, a number, or true for a flag that is on; null if it is absent.
ordered_json json_of(const settings::Option& option, const RenderSettings& settings) {
    using Kind = settings::Value::Kind;
    const std::string text = option.value.write(settings);
    if (option.value.kind == Kind::flag) return !text.empty();
    if (text.empty()) return nullptr;
    const bool is_number = option.value.kind == Kind::number || option.value.kind == Kind::whole;
    return is_number ? ordered_json::parse(text) : ordered_json(text);
}

ordered_json summary(const RenderCommand& command, const scene::RenderScene& stage,
                     const gl::Context& context, Size size) {
    ordered_json json{{"scene", command.scene},
                      {"outputs", command.outputs},
                      {"width", size.width},
                      {"height", size.height}};
    for (const settings::Option& option : settings::all_options())
        if (option.takers & settings::in_json) json[option.key] = json_of(option, command);
    json.update({{"unit", output::unit_of(command.view, stage.scene.units)},
                 {"camera", stage.camera.name},
                 {"lights", stage.lights.size()},
                 {"triangles", scene::triangle_count(stage.scene)},
                 {"backend", context.info().backend},
                 {"GL_RENDERER", context.info().renderer},
                 {"GL_VERSION", context.info().version}});
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
    const render::CpuShadowRays* answers = renderer.shadow_rays();
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

/// Inputs of one picture.
struct Work {
    const RenderCommand& command;
    const scene::RenderScene& stage;
    const render::GpuScene& scene;
    const render::RenderOptions& options;
    render::Renderer& renderer;
    const Interruption& interruption;
    PhaseTimes& times;
    std::string what = "rendering";
};

/// Estimates the error of the picture for --aov error. A picture that does not stop by its error is of one
/// sequence of samples; a second rendering of as many samples in two halves tells the error and leaves it as
/// it is.
void estimate_error(const Work& work, Picture& picture) {
    if (picture.stop.estimate || !output::holds(work.command.aovs, output::Finish::error)) return;
    render::RenderOptions options = work.options;
    options.estimates_error = true;
    render::Renderer renderer(work.scene, work.stage.camera, options);
    StopRule rule = work.command.stop;
    rule.samples = picture.samples.max;
    const Stop stop =
        add_samples(renderer, rule, work.interruption.token(), "estimating the error of " + work.what);
    picture.stop.error = stop.error;
    picture.stop.estimate = stop.estimate;
    work.times.end("error");
}

/// Renders the channels of --layers and --aov. After an interruption it leaves out those of the step at hand.
std::vector<output::ImageChannel> render_further_channels(const Work& work, const Picture& picture,
                                                          const std::vector<int>& samples) {
    std::vector<output::ImageChannel> channels;
    const std::stop_token stop = work.interruption.token();
    if (work.command.has_light_layers && !stop.stop_requested()) {
        channels =
            output::render_layers(output::layer_names(work.stage.lights, output::aov_names()), work.renderer,
                                  [&](const std::string& layer) {
                                      return add_again(work.renderer, picture.samples.max, stop, layer);
                                  });
        work.times.end("layers");
    }
    if (!work.command.aovs.empty() && !stop.stop_requested()) {
        const output::AovSource source{work.scene, work.stage.camera, work.options, samples,
                                       picture.stop.estimate};
        std::ranges::move(output::render_aovs(work.command.aovs, source, stop), std::back_inserter(channels));
        work.times.end("aovs");
    }
    return channels;
}

/// Takes the samples, and renders further channels. After an interruption it returns what is complete.
Picture draw(const Work& work) {
    Picture picture;
    picture.stop = add_samples(work.renderer, work.command.stop, work.interruption.token(), work.what);
    const std::vector<int> samples = work.renderer.pixel_samples();
    picture.samples = settings::count_samples(samples);
    picture.light_choices = work.renderer.light_choices();
    work.times.end("draw");
    picture.film = work.renderer.read_film();
    if (work.command.view) picture.film = output::numbers_of(*work.command.view, picture.film);
    work.times.end("read");
    if (work.command.denoises && !work.interruption.has_come()) {
        const output::AovSource source{work.scene, work.stage.camera, work.options, samples, {}};
        picture.film = output::denoise(work.renderer, source, work.interruption.token());
        work.times.end("denoise");
    }
    if (!work.interruption.has_come()) estimate_error(work, picture);
    const std::vector<output::ImageChannel> channels = render_further_channels(work, picture, samples);
    if (!channels.empty()) picture.layers = output::with_channels(picture.film, channels);
    if (work.interruption.has_come()) picture.stop.by = StoppedBy::interruption;
    return picture;
}

/// Says why a picture has fewer samples, or a greater error, than the options state.
void remark_on_stop(const Picture& picture, const RenderCommand& command) {
    const int samples = picture.samples.max;
    if (picture.stop.by == StoppedBy::interruption)
        print_remark("interrupted after {} of {} samples: what there is was written{}", samples,
                     command.stop.samples,
                     command.has_light_layers || !command.aovs.empty() ? ", not all layers" : "");
    else if (command.stop.error && picture.stop.by != StoppedBy::error)
        print_remark("{}: stopped by {} after {} samples with an estimated error of {:.3g} %, not {:.3g} %",
                     command.scene, name_of(picture.stop.by), samples,
                     100.0 * picture.stop.error.value_or(INFINITY), 100.0 * *command.stop.error);
}

/// Draws, and writes the files. @return absent if nothing was: half a frame of a sequence is not
std::optional<std::pair<Picture, std::optional<float>>> make_picture(const Work& work,
                                                                     const gl::Context& context) {
    Picture picture = draw(work);
    if (work.interruption.asks_to_leave()) {
        print_remark("asked to leave after {} samples: nothing was written", work.renderer.sample_count());
        return std::nullopt;
    }
    if (work.command.frames && work.interruption.has_come()) {
        print_remark("interrupted in {}: the frames before are written", work.what);
        return std::nullopt;
    }
    context.require_silence();
    remark_on(picture.film, work.command, work.stage);
    describe(picture, work.command, work.stage, context.info());
    const auto ev100 =
        output::write(picture.film, picture.layers ? &*picture.layers : nullptr, work.command.outputs,
                      {.ev100 = work.command.ev100,
                       .tone_curve = work.command.tone_curve,
                       .exr_type = work.command.exr_type,
                       .view = work.command.view});
    work.times.end("write");
    remark_on_stop(picture, work.command);
    return std::pair(std::move(picture), ev100);
}

/// Inputs of a rendering, and a record of what it wrote.
struct Rendering {
    const RenderCommand& command;
    OpenScene& open;
    render::GpuScene& scene;
    render::RenderOptions options;
    render::Renderer& renderer;
    PhaseTimes& times;
    std::vector<std::string> written{};
    std::optional<float> ev100{}; // automatic, or that of --exposure
    std::optional<Picture> last{};
};

/// Renders and writes the frames. @return whether all are written; `rendering` lists those that are
bool make_frames(Rendering& rendering) {
    auto& [command, open, scene, options, renderer, times, written, ev100, last] = rendering;
    const Interruption interruption;
    RenderCommand picture = command;
    for (const int frame : open.frames) {
        if (frame != open.frames.front()) {
            show_frame(open, command, frame);
            times.end("pose");
            scene.relight(open.stage.scene, open.stage.lights, 0, true);
            renderer.resize(open.size.width, open.size.height, command.stop.samples);
            renderer.look_from(open.stage.camera);
            times.end("update");
        }
        picture.at = seconds_of(frame, command);
        for (std::size_t i = 0; i < command.outputs.size(); ++i)
            picture.outputs[i] = *numbered(command.outputs[i], frame);
        const auto what = fmt::format("frame {} of {} to {}", frame, open.frames.front(), open.frames.back());
        auto made = make_picture({picture, open.stage, scene, options, renderer, interruption, times, what},
                                 *open.context);
        if (!made) return false;
        if (made->second) picture.ev100 = ev100 = made->second; // that of the first frame for all of them
        last = std::move(made->first);
        written.insert(written.end(), picture.outputs.begin(), picture.outputs.end());
    }
    return true;
}

bool make_single(Rendering& rendering) {
    const Interruption interruption;
    auto made = make_picture({rendering.command, rendering.open.stage, rendering.scene, rendering.options,
                              rendering.renderer, interruption, rendering.times},
                             *rendering.open.context);
    if (!made) return false;
    rendering.written = rendering.command.outputs;
    std::tie(rendering.last, rendering.ev100) = *std::move(made);
    return true;
}

void print_summary(const Rendering& rendering) {
    ordered_json json =
        summary(rendering.command, rendering.open.stage, *rendering.open.context, rendering.open.size);
    json["outputs"] = rendering.written;
    json.update(stopping(*rendering.last));
    json["draw_calls"] = rendering.scene.opaque_draws().size() * 2 + rendering.scene.blended_draws().size();
    json["feature_sets"] = rendering.scene.feature_set_count();
    json["programs"] = rendering.renderer.program_count();
    json["shadows"] = shadows(rendering.scene, rendering.renderer);
    if (rendering.ev100) json["ev100"] = *rendering.ev100;
    json["seconds"] = seconds(rendering.times);
    write_json(json.dump(2, ' ', false, ordered_json::error_handler_t::replace));
}

ExitStatus render(const RenderCommand& command) {
    PhaseTimes times;
    check(command);
    OpenScene open = open_scene(command, times);
    render::GpuScene gpu_scene = upload(open, command);
    glFinish();
    times.end("upload");
    if (gpu_scene.visibility_backend())
        times.add("bvh (in upload)", gpu_scene.visibility_backend()->build_seconds());
    const render::RenderOptions options = render_options(command, open.size);
    render::Renderer renderer(gpu_scene, open.stage.camera, options);
    renderer.compile();
    times.end("compile");
    if (options.lights == render::LightSampling::one && renderer.light_choices() == 0)
        print_remark("{}: a folder of --shaders sums over the lights itself: its samples visit all lights",
                     command.scene);
    Rendering rendering{command, open, gpu_scene, options, renderer, times};
    if (!(command.frames ? make_frames(rendering) : make_single(rendering))) return interrupted;
    if (command.json) print_summary(rendering);
    return rendering.last->stop.by == StoppedBy::interruption ? interrupted : done;
}

} // namespace

void add_render_command(CLI::App& app) {
    const auto options = std::make_shared<RenderCommand>();
    CLI::App* command = app.add_subcommand("render", "render a glTF scene offscreen, lit by its own lights");
    command->add_option("SCENE", options->scene, "a .gltf or .glb file")->required();
    command
        ->add_option("-o,--output", options->outputs,
                     "OUT.exr or .hdr for radiance, OUT.png or .jpg for a picture (repeatable)")
        ->type_name("OUT")
        ->allow_extra_args(false) // one a flag: what follows may be the scene
        ->required();
    command->add_flag("--json", options->json,
                      "print a summary as JSON: times by phase, triangles, samples, …");
    declare(*command, settings::by_render, *options);
    command->get_option("--frames")->excludes(command->get_option("--at"));
    command->get_option("--fps")->needs(command->get_option("--frames"));
    command->footer(
        "Examples:\n"
        "  steradian render scene.glb -o picture.png\n"
        "  steradian render scene.glb -o radiance.exr -o picture.png --samples 256 --size 1920x1080\n"
        "  steradian render scene.glb -o converged.exr --error 0.5%\n"
        "  steradian render city.glb -o night.png --lights one     (each sample visits a few of its "
        "thousand lights)\n"
        "  steradian render scene.glb -o quick.png --time 2s --error 2%    (whichever comes first)\n"
        "  steradian render scene.glb -o layers.exr --layers lights --aov depth,normal,object\n"
        "  steradian render scene.glb -o luminance.png --view luminance\n"
        "  steradian render scene.glb -o front.png --camera auto --exposure 9.5 --tone-curve agx\n"
        "  steradian render dancer.glb -o pose.png --animation Walk --at 0.5\n"
        "  steradian render dancer.glb -o walk.####.png --frames 0:47 --fps 24\n"
        "  steradian render scene.glb -o mine.png --shaders my_shaders    (my_shaders/brdf/f_r.glsl wins)");
    command->callback([options, command] {
        if (command->count("--samples") == 0 && options->stop.asks_for_error())
            options->stop.samples = max_samples;
        const ExitStatus status = render(*options);
        if (status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
