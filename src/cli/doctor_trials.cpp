#include "cli/doctor_trials.hpp"

#include "assignment/confinement.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "golden/process.hpp"
#include "image/file.hpp"
#include "render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

// The test picture: a Lambert plane seen from above, under a point light 1 m above its middle.
constexpr float albedo = 0.5f;
constexpr float light_intensity = 2.0f; // I [cd]
constexpr float light_height = 1.0f;    // h [m]
constexpr float half_width = 1.0f;      // of the part that is seen [m]
constexpr int edge = 32;                // of the picture [pixels]
constexpr double max_error = 1e-4;      // relative; 32-bit floats make 1e-6 of it

scene::Scene plane() {
    scene::Scene scene;
    scene::Material& material = scene.materials.emplace_back();
    material.base_color = vec4(vec3(albedo), 1.0f);
    material.metallic = 0.0f;
    material.specular = 0.0f; // nothing but the diffuse part is left
    scene::Mesh& mesh = scene.meshes.emplace_back();
    const float e = 2.0f * half_width;
    mesh.positions = {{-e, 0.0f, e}, {e, 0.0f, e}, {e, 0.0f, -e}, {-e, 0.0f, -e}};
    mesh.normals.assign(4, vec3(0.0f, 1.0f, 0.0f));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.instances.push_back({0, mat4(1.0f), "plane"});
    return scene;
}

/// Looks down: right is +X, up in the picture is -Z.
scene::Camera camera_from_above() {
    scene::Camera camera;
    camera.world_from_camera = mat4(vec4(1, 0, 0, 0), vec4(0, 0, -1, 0), vec4(0, 1, 0, 0), vec4(0, 10, 0, 1));
    camera.projection = scene::Orthographic{half_width, half_width, 0.1f, 20.0f};
    return camera;
}

/// Returns L = ρ E / π at the middle of a pixel, with E = I cosθ / d² = I h / d³ [cd/m²].
double expected_radiance(int column, int row) {
    const auto place = [](int pixel) { return half_width * (2.0 * (pixel + 0.5) / edge - 1.0); };
    const double d2 =
        place(column) * place(column) + place(row) * place(row) + double{light_height} * light_height;
    return albedo * light_intensity * light_height / std::pow(d2, 1.5) / std::numbers::pi;
}

/// Renders the test picture through the context that is current, and compares every pixel with its closed
/// form.
ordered_json test_picture() {
    const scene::Scene scene = plane();
    const std::vector<scene::Light> lights{
        scene::PointLight{"", {0.0f, light_height, 0.0f}, vec3(light_intensity)}};
    const render::GpuScene gpu_scene(scene, lights);
    render::RenderOptions options;
    options.width = options.height = edge;
    options.samples = 1; // the middle of each pixel
    render::Renderer renderer(gpu_scene, camera_from_above(), options);
    renderer.add_sample();
    const image::Image film = renderer.read_film();
    double error = 0.0;
    for (int row = 0; row < edge; ++row) {
        for (int column = 0; column < edge; ++column) {
            for (int channel = 0; channel < 3; ++channel) {
                const double relative = film.at(column, row)[channel] / expected_radiance(column, row) - 1.0;
                error = std::isfinite(relative) ? std::max(error, std::abs(relative)) : INFINITY;
            }
        }
    }
    constexpr int middle = edge / 2;
    return {{"pixel", {middle, middle}},
            {"expected [cd/m^2]", expected_radiance(middle, middle)},
            {"measured [cd/m^2]", film.at(middle, middle)[0]},
            {"max_relative_error", error},
            {"right", error <= max_error}};
}

ordered_json tried_backend(gl::Backend backend) {
    const auto context = gl::open_context({backend, false});
    const gl::ContextInfo& info = context->info();
    ordered_json result{{"works", true},
                        {"kind", info.backend},
                        {"GL_RENDERER", info.renderer},
                        {"GL_VERSION", info.version},
                        {"GLSL_VERSION", info.shading_language},
                        {"software", info.is_software()}};
    constexpr std::string_view mark = "Mesa ";
    if (const std::size_t mesa = info.version.find(mark); mesa != std::string::npos)
        result["mesa"] = info.version.substr(mesa + mark.size());
    result["picture"] = test_picture();
    if (!result["picture"]["right"]) {
        result["works"] = false;
        result["failure"] = "the test picture is wrong: update the driver, and report it";
    }
    return result;
}

/// @throws Error that names the library to reinstall if the file holds other values than were written
ordered_json tried_picture(const std::filesystem::path& file, const char* library) {
    image::Image written(2, 1, 3);
    written.pixels = {0.25f, 0.5f, 1.0f, 2.0f, 1.0f, 4.0f}; // .hdr holds these exactly, too
    image::write(written, file, image::SampleType::floating);
    if (image::read(file).pixels != written.pixels)
        throw Error(fmt::format("a {} file holds other values than were written", file.extension().string()),
                    fmt::format("reinstall {}", library));
    return {{"works", true}};
}

ordered_json tried_confinement(const std::filesystem::path& folder) {
    assignment::Confinement confinement;
    confinement.writable = folder;
    std::vector<std::string> lacking = assignment::confine_files(confinement);
    std::ranges::copy(assignment::confine_calls(), std::back_inserter(lacking));
    return {{"works", lacking.empty()}, {"lacking", lacking}};
}

ordered_json tried(const std::string& name, const std::filesystem::path& folder) {
    if (name == "exr") return tried_picture(folder / "trial.exr", "OpenEXR");
    if (name == "hdr") return tried_picture(folder / "trial.hdr", "OpenImageIO");
    if (name == "confinement") return tried_confinement(folder);
    const auto backend = gl::backend_named(name);
    if (!backend) throw Error(fmt::format("there is no trial '{}'", name), "run steradian doctor");
    return tried_backend(*backend);
}

} // namespace

void run_doctor_trial(const std::string& name, const std::filesystem::path& file) {
    ordered_json result;
    try {
        result = tried(name, file.parent_path());
    } catch (const Error& error) {
        result = {{"works", false}, {"failure", error.what()}};
    }
    std::ofstream(file) << result.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json result_of_trial(const std::string& name, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / (name + ".json");
    golden::ProcessOptions options;
    options.words = {running_program().string(), "doctor", "--trial", name, file.string()};
    options.folder = folder;
    options.log = folder / (name + ".log");
    const golden::ProcessEnd end = golden::run_process(options);
    std::ifstream stream(file);
    ordered_json result = ordered_json::parse(stream, nullptr, false);
    if (!result.is_object())
        return {{"works", false}, {"failure", "the process that tries it " + end.text()}};
    if (!end.is_success()) result["remark"] = "afterwards its process " + end.text();
    return result;
}

} // namespace sr::cli
