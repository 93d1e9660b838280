#include "ltc/trial.hpp"
#include "render/features.hpp"
#include "render/light_table.hpp"
#include "render/ltc_table.hpp"
#include "support/gl.hpp"
#include "support/glsl_table.hpp"

#include <array>
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
    const scene::Scene scene;
    render::EmissionMaps maps(scene);
    const std::vector<vec4> texels = render::pack_lights(scene, lights, maps);
    const gl::Buffer buffer("lights");
    glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(texels.size() * sizeof(vec4)), texels.data(),
                 GL_STATIC_DRAW);
    const gl::Texture table(GL_TEXTURE_BUFFER, "lights");
    table.bind(1);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer.id());
    const gl::Texture ltc = render::upload_ltc_table();

    const std::array textures{testing::NamedTexture{"light_table", &table}, testing::NamedTexture{"ltc_table", &ltc},
                              testing::NamedTexture{"emission_texels", &table}};
    // The renderer's own programs are as lean: only the shapes at hand.
    scene::Scene one_material;
    one_material.materials.emplace_back();
    const glsl::Files overlay{
        {"interface/features.glsl", render::shading_features(one_material, scene::Mesh{}, lights).glsl()},
        {"interface/estimator.glsl", fmt::format("const int analytic_points = {};\n"
                                                 "const int most_outlined_triangles = 32;\n",
                                                 analytic_points)}};
    const auto reflected = testing::evaluate("#include \"integrator/analytic_lobe.glsl\"\n", R"(
        Surface x = Surface(vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(1.0), b.x, a.y, vec3(0.04), 1.0, vec3(0.0), 1.0);
        vec3 wo = vec3(sqrt(1.0 - a.z * a.z), 0.0, a.z);
        return vec4(reflected_from_outline(light_at(int(a.x)), 0, 1, x, wo), 0.0);)",
                                             rows, textures, overlay);
    std::vector<double> result;
    for (const vec4& L : reflected) result.push_back(L.x);
    return result;
}

} // namespace sr::ltc
