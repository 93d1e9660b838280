// Glass by itself: what it reflects and what it lets through, together.
#include "brdf/evaluator.hpp"
#include "shadow/transparency.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr std::array cosines{1.0f, 0.8f, 0.5f, 0.3f, 0.1f, 0.02f};

vec3 direction(float cos_w, float azimuth) {
    const float s = std::sqrt(1.0f - cos_w * cos_w);
    return {s * std::cos(azimuth), s * std::sin(azimuth), cos_w};
}

// White glass sends on no more than arrives, at every angle and roughness. Rough glass may by 0.2 %: what
// passes takes Schlick's F at n, what is reflected at h, whose mean is larger where F is small (ior 1,
// roughness 0.5: 1.0012).
const Test furnace("law.glass.reflects_and_lets_through_no_more_than_arrives", [] {
    context();
    scene::Material material;
    material.metallic = 0.0f;
    material.transmission = 1.0f;
    brdf::BrdfEvaluator evaluator({material, {}, false, {}});
    std::vector<vec3> wo;
    for (const float cos_o : cosines) wo.push_back(direction(cos_o, 0.7f));
    for (const float ior : {1.0f, 1.33f, 1.5f, 2.4f}) {
        for (const float roughness : {0.05f, 0.2f, 0.5f, 1.0f}) {
            material.ior = ior;
            material.roughness = roughness;
            evaluator.change(material);
            const auto albedos = evaluator.albedos(wo, 4096);
            shadow::Glass glass;
            glass.F0 = std::pow((ior - 1.0f) / (ior + 1.0f), 2.0f);
            for (std::size_t i = 0; i < wo.size(); ++i) {
                const vec3 T = shadow::straight_transmittance(glass, {}, {0, 0, 1}, wo[i]);
                EXPECT_LE(albedos[i].x + T.x, 1.002)
                    << "ior " << ior << ", roughness " << roughness << ", cos " << wo[i].z;
                if (roughness < 0.1f && wo[i].z > 0.2f) {
                    EXPECT_NEAR(albedos[i].x + T.x, 1.0, 5e-3) << "smooth glass keeps nothing";
                }
            }
        }
    }
});

/// f_r with wi below the sheet.
vec3 f_below(brdf::BrdfEvaluator& evaluator, vec3 wi, vec3 wo) {
    return evaluator.evaluate(std::array{brdf::DirectionPair{wi, wo}}).front();
}

// Both sides of a sheet together send on no more than arrives. (Specular 0: glTF's dielectric is no such
// sheet.)
const Test sheet("law.glass.a_sheet_sends_to_both_sides_no_more_than_arrives", [] {
    context();
    scene::Material material;
    material.metallic = 0.0f;
    material.specular = 0.0f;
    material.diffuse_transmission = 0.4f;
    brdf::BrdfEvaluator evaluator({material, {}, false, {}});
    for (const float share : {0.1f, 0.5f, 1.0f}) {
        material.diffuse_transmission = share;
        evaluator.change(material);
        const vec3 wo = direction(0.6f, 0.2f);
        const double above = evaluator.albedos(std::array{wo}, 4096).front().x;
        const double below = f_below(evaluator, direction(-0.3f, 1.0f), wo).x * pi; // it is Lambert's
        EXPECT_NEAR(above, 1.0 - share, 1e-3);
        EXPECT_NEAR(below, share, 1e-5);
    }
});

// Seen from the other side, light goes the same way back, under glTF's Fresnel layer too.
const Test reciprocity("law.glass.a_sheet_is_reciprocal", [] {
    context();
    scene::Material material;
    material.metallic = 0.25f;
    material.diffuse_transmission = 0.5f;
    material.diffuse_transmission_color = vec3(0.3f, 0.8f, 0.1f);
    brdf::BrdfEvaluator evaluator({material, {}, false, {}});
    for (const float cos_i : cosines)
        for (const float cos_o : cosines) {
            const vec3 wi = direction(-cos_i, 0.3f), wo = direction(cos_o, 2.0f);
            const vec3 there = f_below(evaluator, wi, wo);
            const vec3 back =
                f_below(evaluator, wo * vec3(1, 1, -1), wi * vec3(1, 1, -1)); // n is on wo's side
            EXPECT_GT(there.y, 0.0f);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(there[c], back[c], 1e-4f * there[c]);
        }
});

// T does not depend on the way that light goes, through an open sheet or through both walls of a body.
const Test straight("law.glass.lets_the_same_through_both_ways", [] {
    shadow::Glass glass;
    glass.optical_depth = vec3(0.1f, 1.0f, 3.0f);
    const vec3 n(0.0f, 2.0f, 0.0f);
    for (const float cos_w : cosines) {
        const vec3 w = 3.0f * vec3(std::sqrt(1.0f - cos_w * cos_w), cos_w, 0.0f);
        EXPECT_EQ(shadow::straight_transmittance(glass, {}, n, w),
                  shadow::straight_transmittance(glass, {}, n, -w));
        shadow::Glass body = glass;
        body.is_body = true;
        const auto through = [&](vec3 d) {
            return shadow::straight_transmittance(body, {}, n, d)
                   * shadow::straight_transmittance(body, {}, -n, d);
        };
        EXPECT_EQ(through(w), through(-w));
    }
    EXPECT_NEAR(shadow::straight_transmittance({}, {}, n, n).x, 0.96f, 1e-6f) << "1 - F0";
});

} // namespace
