#include "ltc/trial.hpp"
#include "render/gpu/features.hpp"
#include "support/gl.hpp"
#include "support/glsl_table.hpp"

#include <fmt/format.h>

namespace sr::ltc {

std::vector<double> evaluated(std::span<const Trial> trials, Material material, int analytic_points) {
    testing::context();
    std::vector<scene::Light> lights;
    std::vector<testing::Row> rows;
    for (const Trial& trial : trials) {
        rows.push_back({vec4(lights.size(), trial.alpha, trial.cos_o, 0.0f),
                        vec4(material == Material::metal ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f)});
        lights.push_back(trial.light);
    }
    const render::GpuScene scene(scene::Scene{}, lights);

    // The renderer's own programs are as lean: only the shapes at hand.
    scene::Scene one_material;
    one_material.materials.emplace_back();
    const glsl::Files overlay{
        {"interface/features.glsl",
         render::shading_features(one_material, scene::Mesh{}, render::light_features(lights)).glsl()},
        {"interface/estimator.glsl", fmt::format("const int analytic_points = {};\n"
                                                 "const int max_outlined_triangles = 12;\n",
                                                 analytic_points)}};
    const auto reflected = testing::evaluate("#include \"integrator/analytic_lobe.glsl\"\n", R"(
        Surface x;
        x.position = vec3(0.0);
        x.n = vec3(0.0, 0.0, 1.0);
        x.base_color = vec3(1.0);
        x.metallic = b.x;
        x.alpha = a.y;
        x.F0_dielectric = vec3(0.04);
        x.specular = 1.0;
        vec3 wo = vec3(sqrt(1.0 - a.z * a.z), 0.0, a.z);
        return reflected_from_outline(light_at(int(a.x)), 0, 1, x, wo);)",
                                             rows, &scene, overlay);
    std::vector<double> result;
    for (const vec4& L : reflected) result.push_back(L.x);
    return result;
}

} // namespace sr::ltc
