// Milliseconds per light and megapixel, for every shape of emitter: a plane that fills the picture, lit by
// one of it.
#include "core/error.hpp"
#include "gl/context.hpp"
#include "render/renderer.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace {

using namespace sr;

constexpr int size = 1024;

struct Arguments {
    int frames = 15;
    std::string backend = "auto";
    std::string estimator = "sampled";
    int points = render::default_analytic_points;
};

/// A glossy plane, so that lights and BRDF are both sampled.
scene::Scene plane() {
    scene::Scene scene;
    scene.materials.push_back({});
    scene.materials[0].metallic = 0.0f;
    scene.materials[0].roughness = 0.5f;
    scene::Mesh mesh;
    mesh.positions = {{-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}};
    mesh.normals.assign(4, vec3(0, 1, 0));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({0, mat4(1.0f), "plane"});
    return scene;
}

scene::Camera camera_above() {
    scene::Camera camera;
    camera.world_from_camera = mat4(vec4(1, 0, 0, 0), vec4(0, 0, -1, 0), vec4(0, 1, 0, 0), vec4(0, 3, 0, 1));
    camera.projection = scene::Orthographic{1.0f, 1.0f, 0.1f, 10.0f};
    return camera;
}

scene::PolygonLight polygon(int corners) {
    scene::PolygonLight light;
    for (int i = 0; i < corners; ++i) {
        const float angle = -2.0f * pi * static_cast<float>(i) / static_cast<float>(corners); // faces down
        light.corners.emplace_back(0.4f * std::cos(angle), 1.0f, -0.4f * std::sin(angle));
    }
    return light;
}

/// A sheet of n triangles that faces down.
scene::MeshLight mesh(int n) {
    scene::MeshLight light;
    const float step = 1.6f / static_cast<float>(n);
    for (int i = 0; i < n; ++i) {
        const float z = -0.4f + step * static_cast<float>(i / 2);
        const vec3 a(-0.4f, 1, z), b(0.4f, 1, z), c(0.4f, 1, z + step), d(-0.4f, 1, z + step);
        light.triangles.push_back({i % 2 ? std::array<vec3, 3>{a, c, d} : std::array<vec3, 3>{a, b, c}, {}});
    }
    return light;
}

struct Case {
    const char* name;
    std::vector<scene::Light> lights;
};

std::vector<Case> cases() {
    const scene::RectangleLight rectangle{"", {0, 1, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}};
    const scene::DiskLight disk{"", {0, 1, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}};
    const scene::SphereLight sphere{"", {0, 1, 0}, 0.3f};
    const scene::TubeLight tube{"", {0, 1, 0}, {0.5f, 0, 0}, 0.05f};
    return {{"no light", {}},
            {"point", {scene::PointLight{"", {0, 1, 0}}}},
            {"sun", {scene::DirectionalLight{"", {0, -1, 0}, vec3(1.0f), 0.005f}}},
            {"rectangle", {rectangle}},
            {"disk", {disk}},
            {"sphere", {sphere}},
            {"tube", {tube}},
            {"polygon of 5 corners", {polygon(5)}},
            {"mesh of 20 triangles", {mesh(20)}},
            {"mesh of 5000 triangles", {mesh(5000)}},
            {"all of these at once",
             {scene::PointLight{"", {0, 1, 0}}, scene::DirectionalLight{"", {0, -1, 0}, vec3(1.0f), 0.005f},
              rectangle, disk, sphere, tube, polygon(5), mesh(20)}}};
}

/// The median frame of a picture of one megapixel [ms].
double frame_time(const std::vector<scene::Light>& lights, const Arguments& arguments) {
    const int frames = arguments.frames;
    const render::GpuScene scene(plane(), lights);
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = frames + 1;
    options.estimator =
        arguments.estimator == "analytic" ? render::Estimator::analytic : render::Estimator::sampled;
    options.analytic_points = arguments.points;
    render::Renderer renderer(scene, camera_above(), options);
    std::vector<double> times;
    for (int i = 0; i <= frames; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        renderer.add_sample();
        glFinish();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    times.erase(times.begin()); // includes what the driver compiles at first use
    std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
    return times[static_cast<std::size_t>(frames / 2)];
}

void run(const Arguments& arguments) {
    const auto context =
        gl::open_context({gl::backend_named(arguments.backend).value_or(gl::Backend::automatic)});
    double load[1] = {0.0};
    if (getloadavg(load, 1) < 1) load[0] = -1.0;
    fmt::print("{}, {}, {}x{}, median of {} frames, load {:.2f}\n\n", arguments.estimator,
               context->info().renderer, size, size, arguments.frames, load[0]);
    fmt::print("{:<26}{:>12}{:>24}\n", "emitter", "ms a frame", "ms a light and megapixel");
    double empty = 0.0;
    for (const Case& one : cases()) {
        const double time = frame_time(one.lights, arguments);
        if (one.lights.empty()) empty = time;
        const auto count = static_cast<double>(std::max<std::size_t>(1, one.lights.size()));
        fmt::print("{:<26}{:>12.1f}{:>24.1f}\n", one.name, time,
                   (time - empty) / count * 1e6 / (size * size));
    }
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"Milliseconds per light and megapixel, for every shape of emitter."};
    app.add_option("--frames", arguments.frames)->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--backend", arguments.backend)->capture_default_str();
    app.add_option("--estimator", arguments.estimator)
        ->check(CLI::IsMember({"sampled", "analytic"}))
        ->capture_default_str();
    app.add_option("--points", arguments.points, "of the analytic estimator")->capture_default_str();
    app.footer("Example:\n  build/bench_emitters --frames 30");
    CLI11_PARSE(app, argc, argv);
    try {
        run(arguments);
        return 0;
    } catch (const sr::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 3;
    }
}
