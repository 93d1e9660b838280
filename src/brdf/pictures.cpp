#include "brdf/pictures.hpp"

#include "core/math.hpp"
#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sr::brdf {
namespace {

constexpr double center_x = 320.0, center_y = 330.0, radius = 250.0; // [px]
constexpr int steps = 1440;                                          // of θ_i, from -90° to 90°

struct View {
    float degrees;
    const char* color; // Okabe & Ito 2008: distinct for the colour-blind, too
};
constexpr std::array<View, 4> views{
    {{0.0f, "#0072b2"}, {30.0f, "#009e73"}, {60.0f, "#d55e00"}, {80.0f, "#cc79a7"}}};

vec3 in_plane(float theta) { return {std::sin(theta), 0.0f, std::cos(theta)}; }

std::string point(double theta, double r) {
    return fmt::format("{:.1f},{:.1f}", center_x + r * radius * std::sin(theta),
                       center_y - r * radius * std::cos(theta));
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else
            result += c;
    }
    return result;
}

/// The grid: rings at quarters, a spoke every 30°.
std::string grid() {
    std::string svg;
    for (const double r : {0.25, 0.5, 0.75, 1.0})
        svg += fmt::format("<path d=\"M{} A{:.1f} {:.1f} 0 0 1 {}\" class=\"grid\"/>\n",
                           point(-glm::half_pi<double>(), r), r * radius, r * radius,
                           point(glm::half_pi<double>(), r));
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        const double theta = glm::radians(static_cast<double>(degrees));
        svg += fmt::format("<path d=\"M{} L{}\" class=\"grid\"/>\n", point(theta, 0.0), point(theta, 1.0));
        const std::string at = point(theta, 1.06);
        const auto comma = at.find(',');
        svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}°</text>\n", at.substr(0, comma),
                           at.substr(comma + 1), degrees);
    }
    return svg;
}

std::string curve(BrdfEvaluator& evaluator, const View& view, std::size_t row) {
    const vec3 wo = in_plane(-glm::radians(view.degrees));
    std::vector<DirectionPair> pairs;
    for (int i = 1; i < steps; ++i)
        pairs.push_back({in_plane(pi * (static_cast<float>(i) / steps - 0.5f)), wo});
    const std::vector<vec3> f = evaluator.evaluate(pairs);
    std::vector<double> lobe;
    for (std::size_t i = 0; i < f.size(); ++i)
        lobe.push_back(std::max(0.0, static_cast<double>(luminance(f[i]) * pairs[i].wi.z)));
    const double most = *std::max_element(lobe.begin(), lobe.end());
    std::string path;
    for (std::size_t i = 0; i < lobe.size(); ++i)
        path += (i == 0 ? "M" : " L")
                + point(std::asin(static_cast<double>(pairs[i].wi.x)), most > 0.0 ? lobe[i] / most : 0.0);
    const glm::dvec3 albedo = evaluator.albedos(std::array{wo}, 8192)[0];
    const double y = 400.0 + 20.0 * static_cast<double>(row);
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n"
        "<path d=\"M{} L{}\" stroke=\"{}\" stroke-dasharray=\"5 4\"/>\n"
        "<text x=\"70\" y=\"{}\" fill=\"{}\">wo at {}°: at most {:.4g} /sr, albedo {:.3f} {:.3f} "
        "{:.3f}</text>\n",
        path, view.color, point(-glm::radians(static_cast<double>(view.degrees)), 0.0),
        point(-glm::radians(static_cast<double>(view.degrees)), 1.0), view.color, y, view.color, view.degrees,
        most, albedo.x, albedo.y, albedo.z);
}

constexpr int meridians = 128, parallels = 64;

scene::Mesh ball() {
    scene::Mesh mesh;
    for (int i = 0; i <= parallels; ++i)
        for (int j = 0; j <= meridians; ++j) {
            const float theta = pi * static_cast<float>(i) / parallels,
                        phi = 2.0f * pi * static_cast<float>(j) / meridians;
            const vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            mesh.positions.push_back(n);
            mesh.normals.push_back(n);
            mesh.tangents.emplace_back(std::cos(phi), 0.0f, -std::sin(phi), 1.0f);
        }
    for (int i = 0; i < parallels; ++i)
        for (int j = 0; j < meridians; ++j) {
            const auto a = static_cast<std::uint32_t>(i * (meridians + 1) + j), b = a + meridians + 1;
            for (const std::uint32_t index : {a, b, b + 1, a, b + 1, a + 1}) mesh.indices.push_back(index);
        }
    return mesh;
}

} // namespace

std::string draw_polar_plot(BrdfEvaluator& evaluator, const std::string& title) {
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"490\" font-family=\"sans-serif\" "
        "font-size=\"14\">\n<style>.grid{fill:none;stroke:#ccc}</style>\n"
        "<rect width=\"640\" height=\"490\" fill=\"white\"/>\n";
    svg += fmt::format("<text x=\"320\" y=\"30\" text-anchor=\"middle\" font-size=\"18\">{}: f_r cosθ, each "
                       "view to its own scale</text>\n",
                       escaped(title));
    svg += grid();
    for (std::size_t i = 0; i < views.size(); ++i) svg += curve(evaluator, views[i], i);
    return svg + "</svg>\n";
}

image::Image render_sphere(const BrdfUnderTest& tested, int size, int samples) {
    scene::Scene scene;
    scene.materials.push_back(tested.material);
    scene.measured = tested.measured;
    scene.meshes.push_back(ball());
    scene.instances.push_back({0, mat4(1.0f), "ball"});
    const std::vector<scene::Light> lights{
        scene::RectangleLight{
            "softbox", {-3.0f, 3.0f, 3.0f}, {0.9f, 0.0f, 0.9f}, {0.45f, 0.9f, -0.45f}, vec3(400.0f)},
        scene::RectangleLight{
            "strip", {4.0f, 0.5f, 2.0f}, {-0.1f, 0.0f, 0.2f}, {0.0f, 1.5f, 0.0f}, vec3(400.0f)},
        scene::PointLight{"point", {0.5f, 5.0f, 4.0f}, vec3(2500.0f)}};
    scene::Camera camera;
    camera.world_from_camera[3] = vec4(0.0f, 0.0f, 5.0f, 1.0f);
    camera.projection = scene::Perspective{0.46f, 1.0f, 0.1f, {}};

    const render::GpuScene gpu_scene(scene, lights, render::Visibility::none, tested.has_energy_compensation);
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.background = vec3(2.0f);
    options.shader_path = overlay_path(tested);
    options.trial = tested.trial;
    render::Renderer renderer(gpu_scene, camera, options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return renderer.read_film();
}

} // namespace sr::brdf
