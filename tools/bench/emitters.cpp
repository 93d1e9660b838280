// Milliseconds per light and megapixel: one emitter of each shape over a plane that fills the frame, by estimator.
#include "gl/context.hpp"
#include "render/renderer.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <numbers>

namespace {

using namespace sr;

struct Arguments {
    int size = 256;
    int frames = 7;
    std::string backend = "auto";
    std::vector<int> points{0, render::default_analytic_points};
};

/// A square of 8 units a side in y = 0.
scene::Scene plane(float metallic) {
    scene::Scene scene;
    scene::Material material;
    material.metallic = metallic;
    material.roughness = 0.5f;
    scene.materials.push_back(material);
    scene::Mesh mesh;
    mesh.positions = {{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}};
    mesh.normals.assign(4, vec3(0, 1, 0));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({0, mat4(1.0f), "plane"});
    return scene;
}

std::vector<scene::Light> emitters() {
    scene::PolygonLight polygon;
    polygon.name = "polygon of 6";
    for (int k = 0; k < 6; ++k) {
        const float t = -2.0f * std::numbers::pi_v<float> * static_cast<float>(k) / 6.0f;
        polygon.corners.emplace_back(0.7f * std::cos(t), 1.0f, -0.7f * std::sin(t));
    }
    scene::MeshLight mesh;
    mesh.name = "mesh of 8";
    for (int k = 0; k < 8; ++k) {
        const float x = 0.2f * static_cast<float>(k % 4) - 0.4f, z = k < 4 ? -0.2f : 0.2f;
        mesh.triangles.push_back({{vec3(x, 1, z), vec3(x + 0.15f, 1, z), vec3(x, 1, z + 0.15f)}, {}});
    }
    scene::DirectionalLight sun{"sun"};
    sun.direction = glm::normalize(vec3(0.4f, -1.0f, 0.2f));
    sun.angular_radius = 0.00465f;
    return {scene::PointLight{"point", {0, 1, 0}},
            scene::RectangleLight{"rectangle", {0, 1, 0}, {0.6f, 0, 0}, {0, 0, 0.6f}},
            polygon,
            scene::DiskLight{"disk", {0, 1, 0}, {0.6f, 0, 0}, {0, 0, 0.6f}},
            scene::SphereLight{"sphere", {0, 1, 0}, 0.5f},
            scene::TubeLight{"tube", {0, 1, 0}, {0.7f, 0, 0}, 0.1f},
            sun,
            mesh};
}

/// Median of the frames after the first, which compiles.
double milliseconds(const render::GpuScene& scene, const render::RenderOptions& options, int frames) {
    scene::Camera camera;
    camera.world_from_camera = mat4(vec4(1, 0, 0, 0), vec4(0, 0.6f, -0.8f, 0), vec4(0, 0.8f, 0.6f, 0), vec4(0, 2, 1.5f, 1));
    scene::Perspective projection;
    projection.yfov = 0.9f;
    camera.projection = projection;
    render::Renderer renderer(scene, camera, options);
    std::vector<double> times;
    for (int i = 0; i <= frames; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        renderer.add_sample();
        glFinish();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::sort(times.begin() + 1, times.end());
    return times[1 + static_cast<std::size_t>(frames) / 2];
}

void run(const Arguments& arguments) {
    const auto context = gl::open_context({gl::backend_named(arguments.backend).value_or(gl::Backend::automatic)});
    double load[1] = {0.0};
    if (getloadavg(load, 1) < 1) load[0] = -1.0;
    fmt::print("milliseconds per megapixel, {}×{}, {}, load {:.2f}\n", arguments.size, arguments.size,
               context->info().renderer, load[0]);
    fmt::print("{:14} {:8} {:>9}", "emitter", "surface", "sampled");
    for (const int points : arguments.points) fmt::print(" {:>9}", fmt::format("analytic {}", points));
    fmt::print("\n");
    render::RenderOptions options;
    options.width = options.height = arguments.size;
    options.samples = arguments.frames + 1;
    const double megapixels = arguments.size * arguments.size * 1e-6;
    for (const scene::Light& light : emitters())
        for (const float metallic : {0.0f, 1.0f}) {
            const scene::Scene surface = plane(metallic);
            const std::vector<scene::Light> lights{light};
            const render::GpuScene scene(surface, lights);
            fmt::print("{:14} {:8}", std::visit([](const auto& l) { return l.name; }, light),
                       metallic == 0.0f ? "plastic" : "metal");
            options.estimator = render::Estimator::sampled;
            fmt::print(" {:9.0f}", milliseconds(scene, options, arguments.frames) / megapixels);
            options.estimator = render::Estimator::analytic;
            for (const int points : arguments.points) {
                options.analytic_points = points;
                fmt::print(" {:9.0f}", milliseconds(scene, options, arguments.frames) / megapixels);
            }
            fmt::print("\n");
            std::fflush(stdout);
        }
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"Milliseconds per light and megapixel, by shape and estimator."};
    app.add_option("--size", arguments.size)->capture_default_str();
    app.add_option("--frames", arguments.frames)->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--points", arguments.points, "of the analytic estimator")->delimiter(',')->capture_default_str();
    app.add_option("--backend", arguments.backend)->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    run(arguments);
    return 0;
}
