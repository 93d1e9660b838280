// A scene that stands far from its file's origin has the picture that it has near it, shadows included.
#include "support/address.hpp"
#include "support/generated.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace {

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

/// The same file under a node that moves all of it.
MadeGltf moved(MadeGltf made, const glm::dvec3& by) {
    json& roots = made.root["scenes"][0]["nodes"];
    made.root["nodes"].push_back({{"translation", {by.x, by.y, by.z}}, {"children", roots}});
    roots = {made.root["nodes"].size() - 1};
    return made;
}

/// Pixels whose values differ by more than rounding does; edges may cross a few.
int different_pixels(const image::Image& a, const image::Image& b) {
    float most = 0.0f;
    for (const float value : a.pixels) most = std::max(most, value);
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
        bool differs = false;
        for (std::size_t c = i; c < i + 4; ++c)
            differs |= !(std::abs(a.pixels[c] - b.pixels[c])
                         <= 0.02f * std::max(std::abs(a.pixels[c]), std::abs(b.pixels[c])) + 1e-3f * most);
        count += differs;
    }
    return count;
}

void expect_same_picture_far_out(const char* name, render::Estimator estimator,
                                 render::Visibility visibility) {
    const Recipe& recipe = *std::ranges::find(recipes(), std::string_view(name), &Recipe::name);
    Look look;
    look.estimator = estimator;
    look.visibility = visibility;
    Pictures pictures(look);
    constexpr int max_moved = 24; // of 1024: edges and, on light's edges, points of light
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const MadeGltf made = random_scene(recipe, seed);
        const image::Image near = pictures.of(staged(loaded(made)));
        for (const double far : {2e4, 1e5, 1e7}) {
            const glm::dvec3 by(far, -0.5 * far, 2.0 * far);
            const scene::Scene scene = loaded(moved(made, by));
            EXPECT_LT(glm::distance(scene.origin, by), 1e-6 * far + 10.0);
            EXPECT_LE(different_pixels(near, pictures.of(staged(scene))), max_moved)
                << fmt::format("{}, seed {}, {} m out", name, seed, far);
        }
    }
}

using render::Estimator;
using render::Visibility;

const Test ray("law.far.has_the_same_picture_by_rays",
               [] { expect_same_picture_far_out("punctual", Estimator::sampled, Visibility::ray); });
const Test ray_glsl("law.far.has_the_same_picture_by_rays_in_glsl", [] {
    expect_same_picture_far_out("leaves", Estimator::sampled, Visibility::ray_in_glsl);
});
const Test map("law.far.has_the_same_picture_by_maps",
               [] { expect_same_picture_far_out("leaves", Estimator::sampled, Visibility::map); });
const Test analytic("law.far.has_the_same_picture_analytically",
                    [] { expect_same_picture_far_out("rounds", Estimator::analytic, Visibility::ray); });

} // namespace
