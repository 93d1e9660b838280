#include "brdf/evaluator.hpp"
#include "core/error.hpp"
#include "scene/conductor.hpp"
#include "scene/measured_brdf.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace sr;
using namespace sr::testing;
using scene::Material;
using scene::Model;

namespace {

std::vector<brdf::DirectionPair> random_pairs(int count, float min_cosine) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const auto any = [&] {
        const float z = min_cosine + (1.0f - min_cosine) * unit(random), phi = 2.0f * pi * unit(random);
        const float r = std::sqrt(1.0f - z * z);
        return vec3(r * std::cos(phi), r * std::sin(phi), z);
    };
    std::vector<brdf::DirectionPair> pairs;
    for (int i = 0; i < count; ++i) pairs.push_back({any(), any()});
    return pairs;
}

/// The median and the 95th percentile of |a - b| / b, where b is not next to nothing.
std::pair<float, float> differences(const std::vector<vec3>& a, const std::vector<vec3>& b) {
    std::vector<float> all;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (b[i].y > 1e-3f) all.push_back(std::abs(a[i].y / b[i].y - 1.0f));
    std::sort(all.begin(), all.end());
    EXPECT_GT(all.size(), a.size() / 2);
    return {all[all.size() / 2], all[all.size() * 95 / 100]};
}

// Anisotropic GGX of one width is GGX, wherever the tangent points.
const Test isotropic("law.brdf.anisotropy.of_one_width_is_isotropic", [] {
    context();
    Material plain, brushed;
    plain.roughness = brushed.roughness = 0.45f;
    plain.model = brushed.model = Model::ggx;
    brushed.roughness_across = 0.45001f; // the anisotropic code, all but the same width
    brushed.anisotropy_rotation = 0.7f;
    brdf::BrdfEvaluator one({plain, {}, false, {}}), two({brushed, {}, false, {}});
    const auto pairs = random_pairs(2000, 0.05f);
    const auto f = one.evaluate(pairs), g = two.evaluate(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_NEAR(g[i].x, f[i].x, 2e-3f * f[i].x);
});

// A coat, a sheen or a film of no weight leaves the material as it is; a film of no thickness, too.
const Test layers("law.brdf.layers.of_no_weight_change_nothing", [] {
    context();
    Material plain;
    plain.roughness = 0.4f;
    plain.metallic = 0.3f;
    plain.base_color = vec4(0.8f, 0.5f, 0.2f, 1.0f);
    Material covered = plain;
    covered.clearcoat = 1e-9f;
    covered.sheen_color = vec3(1e-9f);
    covered.iridescence = 1.0f;
    covered.max_film_thickness = 0.0f;
    brdf::BrdfEvaluator one({plain, {}, false, {}}), two({covered, {}, false, {}});
    const auto pairs = random_pairs(500, 0.1f);
    const auto f = one.evaluate(pairs), g = two.evaluate(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(g[i][c], f[i][c], 2e-2f * f[i][c] + 1e-5f);
});

// A smooth conductor's albedo is Fresnel's reflectance, and a fitted index of refraction reflects what the
// spectrum does through the observer, at every angle.
const Test measured_metals("law.brdf.conductor.reflects_as_measured", [] {
    for (const std::string_view name : scene::metal_names()) {
        const scene::IorSpectrum spectrum = *scene::measured_metal(name);
        const scene::ComplexIor ior = scene::fit_ior(spectrum);
        for (const double cosine : {1.0, 0.7, 0.4, 0.2, 0.1}) {
            const glm::dvec3 wanted = scene::reflectance_of(spectrum, cosine);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(scene::fresnel_conductor(cosine, ior.n[c], ior.k[c]), wanted[c], 0.01)
                    << name << ' ' << c << " at " << cosine;
        }
    }
    context();
    Material gold;
    gold.model = Model::conductor;
    gold.roughness = 0.05f;
    gold.conductor = scene::fit_ior(*scene::measured_metal("gold"));
    brdf::BrdfEvaluator evaluator({gold, {}, false, {}});
    const vec3 wo(0.6f, 0.0f, 0.8f);
    const glm::dvec3 albedo = evaluator.albedos(std::array{wo}, 16384)[0];
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(albedo[c], scene::fresnel_conductor(0.8, gold.conductor.n[c], gold.conductor.k[c]), 0.01);
    EXPECT_GT(albedo.x, albedo.y);
    EXPECT_GT(albedo.y, albedo.z + 0.2); // it is gold
});

// An analytic BRDF written as a MERL file and read back is that BRDF, within what the cells resolve.
const Test merl("law.brdf.merl.gives_back_what_was_tabulated", [] {
    context();
    Material material;
    material.roughness = 0.5f;
    material.metallic = 0.2f;
    material.base_color = vec4(0.9f, 0.6f, 0.3f, 1.0f);
    brdf::BrdfEvaluator analytic({material, {}, false, {}});
    std::vector<brdf::DirectionPair> cells;
    for (std::size_t i = 0; i < scene::merl_cells; ++i) {
        const auto [wi, wo] = scene::merl_directions(i);
        cells.push_back({wi, wo});
    }
    Material measured;
    measured.model = Model::merl;
    measured.measured = 0;
    brdf::BrdfEvaluator read_back(
        {measured, {scene::read_merl(scene::merl_file(analytic.evaluate(cells)), "made.binary")}, false, {}});
    const auto pairs = random_pairs(4000, 0.2f);
    const auto [median, p95] = differences(read_back.evaluate(pairs), analytic.evaluate(pairs));
    EXPECT_LT(median, 0.002f);
    EXPECT_LT(p95, 0.02f);
    // The lobe that it is sampled by is about as wide as the true one.
    EXPECT_NEAR(read_back.tested().measured.at(0).alpha, 0.25f, 0.08f);
});

const Test broken("law.brdf.merl.broken_files_say_so", [] {
    const auto message = [](std::span<const std::byte> file) -> std::string {
        try {
            scene::read_merl(file, "paint.binary");
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    std::vector<std::byte> file = scene::merl_file(std::vector<vec3>(scene::merl_cells, vec3(0.1f)));
    EXPECT_EQ(message(file), "");
    EXPECT_NE(message(std::span(file).first(file.size() - 1)).find("paint.binary: 34992011 bytes"),
              std::string::npos);
    EXPECT_NE(message(std::span(file).first(5)).find("not a measured BRDF"), std::string::npos);
    file[0] = std::byte{91};
    EXPECT_NE(message(file).find("not a measured BRDF"), std::string::npos);
});

} // namespace
