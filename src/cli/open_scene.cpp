#include "cli/open_scene.hpp"

#include "gltf/load.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <future>

namespace sr::cli {
namespace {

struct TimedLoad {
    gltf::Loaded loaded;
    double seconds = 0.0;
};

TimedLoad load_timed(const RenderCommand& command) {
    PhaseTimes times;
    TimedLoad result{gltf::load(command.scene, {command.scene_index}), 0.0};
    result.seconds = times.total();
    return result;
}

scene::Stage staged(const RenderCommand& command, gltf::Loaded&& loaded) {
    for (const std::string& warning : loaded.warnings) fmt::print(stderr, "{}\n", warning);
    scene::StageOptions options{command.camera, command.rig};
    if (command.size)
        options.aspect_ratio =
            static_cast<float>(command.size->width) / static_cast<float>(command.size->height);
    options.hide_emitters = command.hide_emitters;
    scene::Stage stage = scene::set_stage(std::move(loaded.scene), command.scene, options);
    for (const std::string& remark : stage.remarks) fmt::print(stderr, "{}\n", remark);
    return stage;
}

/// Says which lights the analytic estimator cannot do without noise.
void remark_on_estimator(const RenderCommand& command, const scene::Stage& stage) {
    if (command.estimator != render::Estimator::analytic) return;
    for (const scene::Light& light : stage.lights) {
        const auto* mesh = std::get_if<scene::MeshLight>(&light);
        if (mesh && mesh->triangles.size() > render::most_outlined_triangles)
            fmt::print(stderr, "{}: '{}' has {} emissive triangles, more than {}: it is sampled\n",
                       command.scene, mesh->name, mesh->triangles.size(), render::most_outlined_triangles);
    }
}

} // namespace

OpenScene open_scene(const RenderCommand& command, PhaseTimes& times) {
    // The context first: the dynamic loader has one lock, and behind OpenImageIO a driver would wait for
    // long.
    auto context = gl::open_context({command.backend, command.gl_debug});
    times.end("start");
    auto loading = std::async(std::launch::async, load_timed, std::cref(command));
    const auto preloading = image::preload(); // last, since no thread can start while it has that lock
    TimedLoad load = loading.get();
    times.end("wait for load");
    times.add("load (beside start)", load.seconds);
    scene::Stage stage = staged(command, std::move(load.loaded));
    remark_on_estimator(command, stage);
    const Size size = command.size.value_or(picture_size(stage.camera.aspect_ratio()));
    times.end("stage");
    return {std::move(context), std::move(stage), size};
}

render::RenderOptions render_options(const RenderCommand& command, Size size) {
    render::RenderOptions options;
    options.width = size.width;
    options.height = size.height;
    options.samples = command.stop.samples;
    options.knows_error = command.asks_for_error();
    options.seed = command.seed;
    options.background = command.background;
    options.shader_path = shader_path(command.shaders);
    options.estimator = command.estimator;
    options.analytic_points = command.analytic_points;
    return options;
}

} // namespace sr::cli
