#include "cli/open_scene.hpp"

#include "core/error.hpp"
#include "core/output.hpp"
#include "gltf/load.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <future>
#include <numeric>

namespace sr::cli {
namespace {

/// A file that is read, and its scene at the time of --at or of the first frame.
struct Opened {
    gltf::Asset asset;
    scene::Scene scene;
    std::vector<int> animations;
    std::vector<int> frames;
    std::optional<scene::Bounds> extent; // of all frames
    std::optional<scene::EnvironmentLight> environment;
    double seconds = 0.0; // that it took
};

/// @throws Error if the animation ends before
std::vector<int> frames_of(const gltf::Asset& asset, const std::vector<int>& animations,
                           const RenderCommand& command) {
    const FrameRange& range = *command.frames;
    constexpr int most = 1'000'000;
    const double end = asset.duration(animations);
    int last = range.last.value_or(static_cast<int>(std::min(end * command.fps, 2.0 * most)));
    // A last key that was rounded to 32 bits may lie just before its frame.
    const auto next_second = static_cast<float>(seconds_of(last + 1, command));
    if (!range.last && next_second <= static_cast<float>(end)) ++last;
    if (last - range.first >= most)
        throw Error({command.scene}, fmt::format("frames {} to {} are more than {}", range.first, last, most),
                    "name fewer with --frames A:B, or a lower --fps");
    for (const int frame : {range.first, std::max(last, range.first)})
        asset.require_within({animations, seconds_of(frame, command)});
    std::vector<int> frames(static_cast<std::size_t>(last - range.first) + 1);
    std::iota(frames.begin(), frames.end(), range.first);
    return frames;
}

/// Returns the bounds of the scene over these frames, or over 64 of them.
scene::Bounds extent_of(Opened& opened, const RenderCommand& command) {
    constexpr std::size_t most = 64;
    scene::Bounds all;
    const std::size_t count = std::min(opened.frames.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t frame = count == 1 ? 0 : i * (opened.frames.size() - 1) / (count - 1);
        opened.scene = opened.asset.posed(std::move(opened.scene),
                                          {opened.animations, seconds_of(opened.frames[frame], command)});
        const scene::Bounds bounds = scene::bounds_of(opened.scene);
        if (bounds.is_empty()) continue;
        all.extend(bounds.min);
        all.extend(bounds.max);
    }
    return all;
}

Opened open(const RenderCommand& command) {
    PhaseTimes times;
    Opened opened{gltf::Asset(command.scene, {command.scene_index, command.variant, command.is_strict}),
                  {},
                  {},
                  {},
                  {},
                  {}};
    if (command.frames || command.at) opened.animations = opened.asset.animations_named(command.animation);
    if (command.frames) opened.frames = frames_of(opened.asset, opened.animations, command);
    opened.scene = gltf::scene_of(opened.asset, {{}, command.at, command.animation, {}});
    opened.environment = command.environment.light();
    if (command.frames) opened.extent = extent_of(opened, command);
    opened.seconds = times.total();
    return opened;
}

scene::PrepareOptions stage_options(const RenderCommand& command, const Opened& opened) {
    scene::PrepareOptions options{command.camera, command.rig};
    if (command.size)
        options.aspect_ratio =
            static_cast<float>(command.size->width) / static_cast<float>(command.size->height);
    options.hide_emitters = command.hide_emitters;
    options.extent = opened.extent;
    options.environment = opened.environment;
    return options;
}

/// Says which lights the analytic estimator cannot do without noise.
void remark_on_estimator(const RenderCommand& command, const scene::RenderScene& stage) {
    if (command.rendering.estimator != render::Estimator::analytic) return;
    for (const scene::Light& light : stage.lights) {
        if (const auto* environment = std::get_if<scene::EnvironmentLight>(&light))
            print_remark("{}: '{}' surrounds the scene: it is sampled{}", command.scene, environment->name,
                         environment->map ? "" : ", but for Lambert's surfaces");
        const auto* mesh = std::get_if<scene::MeshLight>(&light);
        if (mesh && mesh->triangles.size() > render::most_outlined_triangles)
            print_remark("{}: '{}' has {} emissive triangles, more than {}: it is sampled", command.scene,
                         mesh->name, mesh->triangles.size(), render::most_outlined_triangles);
    }
}

/// Prints the file's warnings that have not been printed yet: moments of an animation may have their own.
void tell_new_warnings(OpenScene& open) {
    for (const std::string& warning : open.asset.warnings())
        if (open.told.insert(warning).second) write_remark(warning);
}

} // namespace

OpenScene open_scene(const RenderCommand& command, PhaseTimes& times) {
    // The context first: the dynamic loader has one lock, and behind OpenImageIO a driver would wait for
    // long.
    auto context = gl::open_context({command.backend, command.gl_debug});
    times.end("start");
    auto loading = std::async(std::launch::async, open, std::cref(command));
    // Last, since no thread can start while it has that lock.
    const auto preloading =
        std::ranges::all_of(command.outputs, image::is_png) ? std::future<void>() : image::preload();
    Opened opened = loading.get();
    times.end("wait for load");
    times.add("load (beside start)", opened.seconds);
    OpenScene result{std::move(context),
                     {},
                     {},
                     std::move(opened.asset),
                     stage_options(command, opened),
                     std::move(opened.animations),
                     std::move(opened.frames),
                     {}};
    tell_new_warnings(result);
    result.stage.scene = std::move(opened.scene);
    if (result.frames.empty())
        result.stage =
            scene::prepare_scene(std::move(result.stage.scene), command.scene, result.stage_options);
    else
        show_frame(result, command, result.frames.front());
    result.stage_options.rig = result.stage.rig; // what lights the first frame lights all
    for (const std::string& remark : result.stage.remarks) write_remark(remark);
    remark_on_estimator(command, result.stage);
    result.size = command.size.value_or(picture_size(result.stage.camera.aspect_ratio()));
    times.end("stage");
    return result;
}

double seconds_of(int frame, const RenderCommand& command) { return frame / command.fps; }

void show_frame(OpenScene& open, const RenderCommand& command, int frame) {
    scene::Scene posed =
        open.asset.posed(std::move(open.stage.scene), {open.animations, seconds_of(frame, command)});
    open.stage = scene::prepare_scene(std::move(posed), command.scene, open.stage_options);
    tell_new_warnings(open);
}

render::GpuScene uploaded(const OpenScene& open, const RenderCommand& command) {
    return {open.stage.scene, open.stage.lights, command.visibility, command.has_energy_compensation};
}

render::RenderOptions render_options(const RenderCommand& command, Size size) {
    render::RenderOptions options = command.rendering;
    options.width = size.width;
    options.height = size.height;
    options.samples = command.stop.samples;
    options.estimates_error = command.asks_for_error();
    options.shader_path = shader_path(command.shaders, command.is_untrusted);
    if (!command.shaders.empty()) options.trial = std::make_shared<gl::TrialCompiler>(command.backend);
    if (command.view) options.shader = command.view->shader;
    return options;
}

} // namespace sr::cli
