// Changes that must not change a picture, on generated scenes: tests without a reference find mistakes that a
// reference shares.
#include "file_changes.hpp"
#include "image/file.hpp"
#include "picture_difference.hpp"
#include "scene_changes.hpp"
#include "support/address.hpp"
#include "support/generated.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <variant>

namespace {

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

/// Scenes of each of the 14 recipes, which the laws take in turn. $STERADIAN_SCENES asks for more.
constexpr int usual_scenes = 80;

void keep(const image::Image& a, const image::Image& b, const std::string& name) {
    if (!std::getenv("STERADIAN_KEEP")) return;
    const std::filesystem::path folder = std::getenv("STERADIAN_KEEP");
    image::write(a, folder / (name + ".a.exr"), image::SampleType::floating);
    image::write(b, folder / (name + ".b.exr"), image::SampleType::floating);
}

/// Two scenes whose pictures must be the same.
struct ScenePair {
    scene::Scene a;
    scene::Scene b;
};

using Change = ScenePair (*)(const MadeGltf&, Random&);

struct Law {
    const char* name;
    Change change;
    bool keeps_samples = false; // every light's points are the same ones
    bool is_mirrored = false;
};

ScenePair in_vertices(const MadeGltf& made, Random&) {
    scene::Scene scene = loaded(made);
    return {scene, baked(scene)};
}

ScenePair moved_and_scaled(const MadeGltf& made, Random& random) {
    const double s = random.scale_within(1e-3, 1e3);
    scene::Scene scene = loaded(made);
    return {scene, placed(scene, {s, glm::dmat3(1.0), s * random.in_cube(3.0)})};
}

ScenePair split_in_two(const MadeGltf& made, Random& random) {
    scene::Scene scene = loaded(made);
    return {scene, split(scene, random)};
}

ScenePair turned(const MadeGltf& made, Random& random) {
    scene::Scene scene = loaded(made);
    return {scene, placed(scene, {1.0, glm::mat3_cast(random.turn()), random.in_cube(3.0)})};
}

glm::dmat3 flip() {
    glm::dmat3 flip(1.0);
    flip[0][0] = -1.0;
    return flip;
}

/// By nodes of negative scale, or by vertices whose triangles wind the other way.
ScenePair mirrored(const MadeGltf& made, Random& random) {
    const scene::Scene scene = without_minification(loaded(made));
    const scene::Scene result = placed(scene, {1.0, flip(), glm::dvec3(0.0)});
    return {scene, random.has_chance(0.5) ? result : baked(result)};
}

ScenePair reordered(const MadeGltf& made, Random& random) {
    scene::Scene scene = loaded(made);
    return {scene, shuffled(scene, random)};
}

ScenePair in_other_units_of_light(const MadeGltf& made, Random& random) {
    return {loaded(made), loaded(in_other_units(made, random))};
}

ScenePair in_another_file_order(const MadeGltf& made, Random& random) {
    return {loaded(made), loaded(in_other_order(made, random))};
}

ScenePair under_a_root(const MadeGltf& made, Random& random, const glm::dmat3& flip) {
    const double s = random.scale_within(1e-3, 1e3);
    const Similarity similarity{s, glm::mat3_cast(random.turn()) * flip, s * random.in_cube(3.0)};
    return {without_minification(loaded(made)), without_minification(loaded(under_root(made, similarity)))};
}

ScenePair under_a_placing_root(const MadeGltf& made, Random& random) {
    return under_a_root(made, random, glm::dmat3(1.0));
}

ScenePair under_a_mirroring_root(const MadeGltf& made, Random& random) {
    return under_a_root(made, random, flip());
}

const std::array laws{Law{"in vertices", in_vertices, true},
                      Law{"moved and scaled", moved_and_scaled, true},
                      Law{"split", split_in_two, true},
                      Law{"in other units", in_other_units_of_light, true},
                      Law{"turned", turned},
                      Law{"mirrored", mirrored, false, true},
                      Law{"reordered", reordered},
                      Law{"in another file order", in_another_file_order},
                      Law{"under a root", under_a_placing_root},
                      Law{"under a root that mirrors", under_a_mirroring_root, false, true}};

/// Returns whether a picture by the analytic estimator has no noise: all emitters have closed forms but
/// meshes of many triangles.
bool is_noiseless(const scene::RenderScene& stage) {
    return std::ranges::all_of(stage.lights, [](const scene::Light& light) {
        const auto* mesh = std::get_if<scene::MeshLight>(&light);
        return !mesh || mesh->triangles.size() <= render::max_outlined_triangles;
    });
}

bool has_surfaces_that_emit(const Recipe& recipe) {
    return std::ranges::any_of(recipe.surfaces, [](Surface s) {
        return s == Surface::glowing || s == Surface::textured_glowing || s == Surface::glowing_quad;
    });
}

Look noiseless_look() {
    Look look;
    look.estimator = render::Estimator::analytic;
    look.visibility = render::Visibility::none;
    return look;
}

/// Holds each scene of a recipe to one of the laws in turn.
class Trial {
public:
    explicit Trial(const Recipe& recipe) : recipe_(recipe) {}

    void run(int scenes) {
        for (int i = 0; i < scenes; ++i) try_scene(first_seed() + static_cast<std::uint64_t>(i));
    }

    void try_scene(std::uint64_t seed) {
        const MadeGltf made = random_scene(recipe_, seed);
        // The first law that pictures without noise can tell of this scene.
        std::size_t law = seed % laws.size();
        while (!has_held(laws[law], made, seed)) law = (law + 1) % laws.size();
    }

    ~Trial() {
        ::testing::Test::RecordProperty("pairs", pairs_);
        ::testing::Test::RecordProperty("moved_pixels", moved_);
        EXPECT_EQ(failed_, 0) << "of " << pairs_ << " pairs of pictures";
    }

private:
    /// False if the law would need many samples.
    bool has_held(const Law& law, const MadeGltf& made, std::uint64_t seed) {
        Random random(~seed);
        const ScenePair scenes = law.change(made, random);
        const scene::RenderScene a = staged(scenes.a), b = staged(scenes.b);
        // Surfaces that emit are other emitters to a picture's random numbers when their vertices change.
        const bool keeps_samples =
            recipe_.is_without_extent()
            || (law.keeps_samples && (law.change != in_vertices || !has_surfaces_that_emit(recipe_)));
        if (!keeps_samples && !is_noiseless(a)) return false;
        compare({law, seed, keeps_samples ? sampled_ : noiseless_}, a, b);
        return true;
    }

    /// One comparison, and what makes its pictures.
    struct Case {
        const Law& law;
        std::uint64_t seed;
        Pictures& pictures;
    };

    void compare(const Case& c, const scene::RenderScene& a, const scene::RenderScene& b) {
        const image::Image picture = c.pictures.of(a);
        image::Image changed = c.pictures.of(b);
        if (c.law.is_mirrored) changed = in_a_mirror(changed);
        const Difference difference = difference_of(picture, changed);
        ++pairs_;
        moved_ += difference.moved;
        if (difference.is_small()) return;
        keep(picture, changed, fmt::format("{}.{}.{}", c.law.name, recipe_.name, c.seed));
        if (++failed_ > 8) return;
        ADD_FAILURE() << fmt::format(
            "{}, recipe {}, seed {}: {} pixels differ, {} of them from all around: {}", c.law.name,
            recipe_.name, c.seed, difference.moved, difference.strange, difference.first);
    }

    const Recipe& recipe_;
    Pictures sampled_{Look{}};
    Pictures noiseless_{noiseless_look()};
    int pairs_ = 0, moved_ = 0, failed_ = 0;
};

const Recipe& recipe_named(const char* name) {
    return *std::ranges::find(recipes(), std::string_view(name), &Recipe::name);
}

void expect_laws(const char* name) { Trial(recipe_named(name)).run(scenes_of_a_recipe(usual_scenes)); }

const Test punctual("law.metamorphic.punctual", [] { expect_laws("punctual"); });
const Test profile("law.metamorphic.profile", [] { expect_laws("profile"); });
const Test coats("law.metamorphic.coats", [] { expect_laws("coats"); });
const Test directions("law.metamorphic.directions", [] { expect_laws("directions"); });
const Test cloth("law.metamorphic.cloth", [] { expect_laws("cloth"); });
const Test lobes("law.metamorphic.lobes", [] { expect_laws("lobes"); });
const Test leaves("law.metamorphic.leaves", [] { expect_laws("leaves"); });
const Test panes("law.metamorphic.panes", [] { expect_laws("panes"); });
const Test panels("law.metamorphic.panels", [] { expect_laws("panels"); });
const Test pictures("law.metamorphic.pictures", [] { expect_laws("pictures"); });
const Test rounds("law.metamorphic.rounds", [] { expect_laws("rounds"); });
const Test lamps("law.metamorphic.lamps", [] { expect_laws("lamps"); });
const Test polygons("law.metamorphic.polygons", [] { expect_laws("polygons"); });
const Test glows("law.metamorphic.glows", [] { expect_laws("glows"); });

// Scenes in which rounding puts the two ends of an emitter's edge, which lies on the receiver's horizon, on
// either side of it: the emitter's face is below, and its irradiance must not become that of the edge's
// angle.
const Test edges("law.metamorphic.an_edge_on_the_horizon", [] {
    Trial trial(recipe_named("glows"));
    for (const std::uint64_t seed : {100798, 101105, 102968, 103338}) trial.try_scene(seed);
});

// Scenes in which triangles of equal areas have shares of the choice that rounding puts on either side of 1.
const Test areas("law.metamorphic.equal_areas", [] {
    Trial trial(recipe_named("glows"));
    for (const std::uint64_t seed : {101389, 103271, 103411}) trial.try_scene(seed);
});

} // namespace
