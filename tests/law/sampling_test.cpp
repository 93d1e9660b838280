#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/glsl_table.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

const std::vector<float> widths{0.01f, 0.1f, 0.3f, 0.6f, 1.0f};
const std::vector<float> cosines{0.05f, 0.3f, 0.7f, 1.0f};

std::vector<Row> width_and_cosine_rows() {
    std::vector<Row> rows;
    for (const float alpha : widths)
        for (const float cos_o : cosines) rows.push_back({vec4(alpha, cos_o, 0.0f, 0.0f)});
    return rows;
}

// A histogram test of sample_ggx against p_ggx: the share of samples in a cell of the hemisphere equals the
// integral of the density over it. Cells: 4 rings in wi.z and 4 sectors in φ around a tilted normal, so that
// frames matter; one more for what comes out below the horizon.
const Test histogram("law.brdf.ggx.sampling_matches_density", [] {
    const std::string preamble = R"(
#include "base/sampling.glsl"
#include "brdf/ggx_sampling.glsl"
const vec3 n = vec3(0.48, -0.6, 0.64);
vec3 local(vec3 w) { return w * frame_around(n); }
int cell_of(vec3 l) {
    if (l.z <= 0.0) return -1;
    return int(min(l.z, 0.9999) * 4.0) * 4 + int(min((atan(l.y, l.x) / (2.0 * pi) + 0.5) * 4.0, 3.0));
})";
    const std::string body = R"(
        vec3 wo = frame_around(n) * vec3(sqrt(1.0 - a.y * a.y), 0.0, a.y);
        int wanted = int(a.z);
        const int count = 16384;
        int inside = 0;
        for (int i = 0; i < count; ++i)
            inside += cell_of(local(sample_ggx(n, wo, a.x, sobol_2d(uint(i), 7u)))) == wanted ? 1 : 0;
        // The density over the cell by midpoints in (wi.z, φ), where dω = dz dφ.
        const int side = 160;
        float integral = 0.0;
        for (int i = 0; i < side * side; ++i) {
            float z = (float(wanted / 4) + (float(i % side) + 0.5) / float(side)) / 4.0;
            float phi = ((float(wanted % 4) + (float(i / side) + 0.5) / float(side)) / 4.0 - 0.5) * 2.0 * pi;
            vec3 wi = frame_around(n) * vec3(sqrt(1.0 - z * z) * vec2(cos(phi), sin(phi)), z);
            integral += p_ggx(n, wi, wo, a.x);
        }
        integral *= 2.0 * pi / 16.0 / float(side * side);
        return vec4(float(inside) / float(count), integral, 0.0, 0.0);)";
    std::vector<Row> rows;
    for (const float alpha : {0.2f, 0.5f, 1.0f})
        for (const float cos_o : cosines)
            for (int cell = 0; cell < 16; ++cell)
                rows.push_back({vec4(alpha, cos_o, static_cast<float>(cell), 0.0f)});
    const auto shares = evaluate(preamble, body, rows);
    float largest = 0.0f;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(shares[i].x, shares[i].y, 3e-3f)
            << "alpha " << rows[i][0].x << " cos_o " << rows[i][0].y << " cell " << rows[i][0].z;
        largest = std::max(largest, shares[i].y);
    }
    EXPECT_GT(largest, 0.1f) << "the lobe is somewhere";
});

// For a white metal f_r cosθ / p = G / G1 <= 1: the mean over samples is the albedo that the furnace test
// integrates in another way, and no sample weighs more than 1 (Heitz 2018, section 5).
const Test weight("law.brdf.ggx.sample_weights_stay_below_one", [] {
    const auto rows = width_and_cosine_rows();
    const auto weights = evaluate(R"(
#include "base/sampling.glsl"
#include "brdf/ggx_sampling.glsl")",
                                  R"(
        vec3 n = vec3(0.0, 0.0, 1.0);
        vec3 wo = vec3(sqrt(1.0 - a.y * a.y), 0.0, a.y);
        float largest = 0.0;
        float sum = 0.0;
        for (int i = 0; i < 4096; ++i) {
            vec3 wi = sample_ggx(n, wo, a.x, sobol_2d(uint(i), 3u));
            if (wi.z <= 0.0) continue;
            float f = D_ggx(n, normalize(wi + wo), a.x) * V_smith_ggx(wi.z, wo.z, a.x);
            float w = f * wi.z / p_ggx(n, wi, wo, a.x);
            largest = max(largest, w);
            sum += w;
        }
        return vec4(largest, sum / 4096.0, 0.0, 0.0);)",
                                  rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_LE(weights[i].x, 1.0f + 1e-3f) << "alpha " << rows[i][0].x << " cos_o " << rows[i][0].y;
        EXPECT_GT(weights[i].y, 0.3f);
    }
});

// Two ways to the same integral: sampling the light alone, and light and BRDF together, agree for a glossy
// surface under a large light, where each alone would be poor somewhere.
const Test two_ways("law.integrator.light_and_brdf_samples_agree_with_light_samples", [] {
    context();
    auto plane = lambert_plane(4.0f, vec3(0.5f));
    plane.materials[0].specular = 1.0f;
    plane.materials[0].metallic = 0.5f;
    plane.materials[0].roughness = 0.45f;
    const std::vector<scene::Light> lights{
        scene::RectangleLight{"", {0.3f, 1.0f, 0.0f}, {0.8f, 0, 0}, {0, 0, 0.8f}, vec3(10.0f)}};
    const render::GpuScene scene(plane, lights);
    const auto mean = [&](std::vector<glsl::Root> path) {
        render::RenderOptions options;
        options.width = options.height = 24;
        options.samples = 2048;
        options.shader_path = std::move(path);
        scene::Camera camera = camera_from_above(2.0f);
        render::Renderer renderer(scene, camera, options);
        for (int i = 0; i < options.samples; ++i) renderer.add_sample();
        const auto film = renderer.read_film();
        double sum = 0.0;
        for (std::size_t i = 0; i < film.pixels.size(); i += 4) sum += film.pixels[i];
        return sum / (24.0 * 24.0);
    };
    const double both = mean({glsl::embedded()});
    const double light_only = mean({glsl::Root::memory("light only", {{"brdf/f_r.glsl", R"(
#include "brdf/metallic_roughness.glsl"
vec3 f_r(Surface x, vec3 wi, vec3 wo) { return f_metallic_roughness(x, wi, wo); }
bool has_peak(Surface x) { return false; }
)"}}),
                                    glsl::embedded()});
    EXPECT_NEAR(both / light_only, 1.0, 1e-3);
});

} // namespace
