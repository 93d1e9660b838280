// Milliseconds per frame, read-back excluded: a scene under one point light, or under its own lights.
#include "core/error.hpp"
#include "gl/context.hpp"
#include "gltf/asset.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace {

using namespace sr;

struct Arguments {
    std::string scene;
    int width = 1280;
    int height = 720;
    int frames = 60;
    bool own_lights = false;
    int softboxes = 0;
    double frozen = 0.0;
    std::string visibility = "ray";
    render::MapOptions maps;
    std::string backend = "auto";
};

scene::RenderScene stage_for(const Arguments& arguments) {
    scene::Scene scene = gltf::load(arguments.scene).scene;
    const scene::Bounds bounds = scene::bounds_of(scene);
    const float aspect = static_cast<float>(arguments.width) / static_cast<float>(arguments.height);
    scene::RenderScene stage =
        scene::prepare_scene(std::move(scene), arguments.scene, {"auto", scene::Rig::automatic, aspect});
    if (arguments.own_lights) return stage;
    for (scene::Instance& instance : stage.scene.instances) instance.emits_as = {}; // of the lights to come
    if (arguments.softboxes > 0) {
        stage.lights.clear();
        const auto rig = scene::softbox_rig(bounds, stage.camera);
        for (int i = 0; i < arguments.softboxes; ++i)
            stage.lights.emplace_back(rig[static_cast<std::size_t>(i) % rig.size()]);
        return stage;
    }
    const vec3 eye = stage.camera.world_from_camera[3];
    stage.lights = {scene::PointLight{"beside the camera", eye + vec3(0.5f, 1.0f, 0.0f) * bounds.radius(),
                                      vec3(1000.0f * bounds.radius() * bounds.radius())}};
    return stage;
}

std::vector<double> frame_times(render::Renderer& renderer, int frames) {
    std::vector<double> milliseconds;
    for (int i = 0; i < frames; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        renderer.add_sample();
        glFinish();
        milliseconds.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    return milliseconds;
}

/// This share of the picture's blocks of 16×16 pixels, evenly spread.
render::PixelMask spread(double share, int width, int height) {
    render::PixelMask mask;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double place = 0.618034 * (x / 16 + 97 * (y / 16)); // the golden ratio's multiples
            mask.push_back(place - std::floor(place) < share ? 1 : 0);
        }
    }
    return mask;
}

void report_rays(const render::GpuScene& scene, const render::Renderer& renderer) {
    if (!scene.visibility_backend()) return;
    if (const auto* maps = renderer.depth_maps()) {
        fmt::print("shadows: {} maps of {}x{} texels a frame\n", maps->map_count(), maps->size(),
                   maps->size());
        return;
    }
    fmt::print("shadows: built in {:.3f} s, {} boxes", scene.visibility_backend()->build_seconds(),
               scene.visibility_backend()->node_count());
    if (const auto answers = renderer.traced_rays())
        fmt::print(", {:.2f} M rays a frame, {:.1f} M rays/s",
                   1e-6 * static_cast<double>(answers->count) / renderer.sample_count(),
                   1e-6 * static_cast<double>(answers->count) / answers->seconds);
    fmt::print("\n");
}

void run(const Arguments& arguments) {
    const auto context =
        gl::open_context({gl::backend_named(arguments.backend).value_or(gl::Backend::automatic)});
    const scene::RenderScene stage = stage_for(arguments);
    const render::GpuScene gpu_scene(stage.scene, stage.lights,
                                     *render::visibility_named(arguments.visibility));
    render::RenderOptions options;
    options.width = arguments.width;
    options.height = arguments.height;
    options.samples = arguments.frames + 1;
    options.maps = arguments.maps;
    render::Renderer renderer(gpu_scene, stage.camera, options);
    renderer.compile();
    const double first = frame_times(renderer, 1).front(); // includes what the driver compiles at first use
    if (arguments.frozen > 0.0) renderer.freeze(spread(arguments.frozen, options.width, options.height));
    std::vector<double> times = frame_times(renderer, arguments.frames);
    std::sort(times.begin(), times.end());
    double load[1] = {0.0};
    if (getloadavg(load, 1) < 1) load[0] = -1.0;
    fmt::print("{} at {}x{}, {} light(s), {} triangles, {}\n", arguments.scene, arguments.width,
               arguments.height, stage.lights.size(), scene::triangle_count(stage.scene),
               context->info().renderer);
    fmt::print("first frame {:.1f} ms; then median {:.1f}, fastest {:.1f}, 95 % {:.1f} ms of {} frames (load "
               "{:.2f})\n",
               first, times[times.size() / 2], times.front(), times[times.size() * 95 / 100], times.size(),
               load[0]);
    report_rays(gpu_scene, renderer);
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"Milliseconds per frame, read-back excluded."};
    app.add_option("SCENE", arguments.scene, "a .gltf or .glb file")->required();
    app.add_option("--width", arguments.width)->capture_default_str();
    app.add_option("--height", arguments.height)->capture_default_str();
    app.add_option("--frames", arguments.frames)->check(CLI::PositiveNumber)->capture_default_str();
    app.add_flag("--own-lights", arguments.own_lights,
                 "the scene's lights (or the studio rig) instead of one point light");
    app.add_option("--softboxes", arguments.softboxes, "this many rectangles of the studio rig instead");
    app.add_option("--frozen", arguments.frozen, "this share of the pixels has enough samples")
        ->check(CLI::Range(0.0, 0.99));
    app.add_option("--visibility", arguments.visibility)
        ->check(CLI::IsMember({"none", "ray", "ray-cpu", "ray-glsl", "map"}))
        ->capture_default_str();
    app.add_option("--map-points", arguments.maps.points)->check(CLI::Range(1, 32))->capture_default_str();
    app.add_option("--map-size", arguments.maps.size)->capture_default_str();
    app.add_option("--backend", arguments.backend)->capture_default_str();
    app.footer("Example:\n  build/bench_frame scene.glb --frames 100");
    CLI11_PARSE(app, argc, argv);
    try {
        run(arguments);
        return 0;
    } catch (const sr::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 3;
    }
}
