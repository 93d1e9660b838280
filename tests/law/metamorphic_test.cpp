// What must not change a picture, on generated scenes: tests that know no reference find mistakes that a
// reference shares.
#include "image/file.hpp"
#include "scene_changes.hpp"
#include "support/address.hpp"
#include "support/generated.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>

namespace {

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

/// Scenes of each recipe; every law sees them all.
constexpr int usual_scenes = 20;

/// How far two pictures may be apart: what rounding makes of values, and of edges that it moves across a
/// pixel's centre.
constexpr float most_relative = 0.02f;
constexpr int most_strange = 3; // pixels that differ from all around them in the other picture
constexpr int most_moved = 40;  // pixels that differ

struct Window {
    float low = INFINITY, high = -INFINITY;
};

/// What the pixels around one are worth.
Window around(const image::Image& picture, int column, int row, int channel) {
    Window window;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, picture.height - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, picture.width - 1); ++x) {
            window.low = std::min(window.low, picture.at(x, y)[channel]);
            window.high = std::max(window.high, picture.at(x, y)[channel]);
        }
    return window;
}

bool is_within(float value, const Window& window, float floor) {
    const float slack = most_relative * std::abs(window.high) + floor;
    return value >= window.low - slack && value <= window.high + slack;
}

struct Difference {
    int moved = 0;   // pixels that an edge may have crossed
    int strange = 0; // others
    std::string first;
};

Difference difference_of(const image::Image& a, const image::Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += i % 4 == 3 ? 0.0 : std::abs(a.pixels[i]);
    const auto floor = static_cast<float>(1e-3 * sum / static_cast<double>(a.pixels.size()) + 1e-30);
    Difference difference;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            bool is_moved = false, is_strange = false;
            for (int i = 0; i < 4; ++i) {
                const float va = a.at(x, y)[i], vb = b.at(x, y)[i];
                if (std::abs(va - vb) <= most_relative * std::max(std::abs(va), std::abs(vb)) + floor)
                    continue;
                is_moved = true;
                if (is_within(va, around(b, x, y, i), floor) && is_within(vb, around(a, x, y, i), floor))
                    continue;
                if (!is_strange && difference.first.empty())
                    difference.first = fmt::format("({}, {})[{}]: {} and {}", x, y, i, va, vb);
                is_strange = true;
            }
            difference.moved += is_moved;
            difference.strange += is_strange;
        }
    return difference;
}

image::Image in_a_mirror(const image::Image& picture) {
    image::Image result = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int i = 0; i < 4; ++i) result.at(x, y)[i] = picture.at(picture.width - 1 - x, y)[i];
    return result;
}

void keep(const image::Image& a, const image::Image& b, const std::string& name) {
    if (!std::getenv("STERADIAN_KEEP")) return;
    const std::filesystem::path folder = std::getenv("STERADIAN_KEEP");
    image::write(a, folder / (name + ".a.exr"), image::SampleType::floating);
    image::write(b, folder / (name + ".b.exr"), image::SampleType::floating);
}

using Change = scene::Scene (*)(const scene::Scene&, Random&);

struct Law {
    const char* name;
    Change change;
    bool keeps_samples = false; // every light's points are the same ones
    bool is_mirrored = false;
};

scene::Scene in_vertices(const scene::Scene& scene, Random&) { return baked(scene); }

scene::Scene moved_and_scaled(const scene::Scene& scene, Random& random) {
    const double s = random.scale_within(1e-3, 1e3);
    return placed(scene, {s, glm::dmat3(1.0), s * random.in_cube(3.0)});
}

scene::Scene turned(const scene::Scene& scene, Random& random) {
    return placed(scene, {1.0, glm::mat3_cast(random.turn()), random.in_cube(3.0)});
}

/// By nodes of negative scale, or by vertices whose triangles wind the other way.
scene::Scene mirrored(const scene::Scene& scene, Random& random) {
    glm::dmat3 flip(1.0);
    flip[0][0] = -1.0;
    const scene::Scene result = placed(scene, {1.0, flip, glm::dvec3(0.0)});
    return random.has_chance(0.5) ? result : baked(result);
}

const std::array laws{Law{"in vertices", in_vertices, true},
                      Law{"moved and scaled", moved_and_scaled, true},
                      Law{"split", split, true},
                      Law{"turned", turned},
                      Law{"mirrored", mirrored, false, true},
                      Law{"reordered", shuffled}};

bool has_meshes_that_emit(const Recipe& recipe) {
    return std::ranges::any_of(
        recipe.surfaces, [](Surface s) { return s == Surface::glowing || s == Surface::textured_glowing; });
}

bool has_surfaces_that_emit(const Recipe& recipe) {
    return has_meshes_that_emit(recipe)
           || std::ranges::any_of(recipe.surfaces, [](Surface s) { return s == Surface::glowing_quad; });
}

/// Holds scenes of one recipe to laws that need no noise to be told apart.
class Trial {
public:
    explicit Trial(const Recipe& recipe) : recipe_(recipe) {}

    /// Pictures of `look` must follow these laws.
    void expect(const Look& look, const std::function<bool(const Law&)>& holds) {
        Pictures pictures(look);
        for (int i = 0; i < scenes_of_a_recipe(usual_scenes); ++i) {
            const std::uint64_t seed = first_seed() + static_cast<std::uint64_t>(i);
            const scene::Scene scene = loaded(random_scene(recipe_, seed));
            const image::Image picture = pictures.of(staged(scene));
            ++scenes_;
            for (const Law& law : laws) {
                if (!holds(law)) continue;
                Random random(~seed);
                const image::Image changed = pictures.of(staged(law.change(scene, random)));
                compare(law, seed, picture, law.is_mirrored ? in_a_mirror(changed) : changed);
            }
        }
    }

    ~Trial() {
        ::testing::Test::RecordProperty("scenes", scenes_);
        ::testing::Test::RecordProperty("pictures", pictures_);
        ::testing::Test::RecordProperty("moved_pixels", moved_);
        EXPECT_EQ(failed_, 0) << "of " << pictures_ << " pictures";
    }

private:
    void compare(const Law& law, std::uint64_t seed, const image::Image& a, const image::Image& b) {
        const Difference difference = difference_of(a, b);
        ++pictures_;
        moved_ += difference.moved;
        if (difference.strange <= most_strange && difference.moved <= most_moved) return;
        keep(a, b, fmt::format("{}.{}.{}", law.name, recipe_.name, seed));
        if (++failed_ > 8) return;
        ADD_FAILURE() << fmt::format(
            "{}, recipe {}, seed {}: {} pixels differ, {} of them from all around: {}", law.name,
            recipe_.name, seed, difference.moved, difference.strange, difference.first);
    }

    const Recipe& recipe_;
    int scenes_ = 0, pictures_ = 0, moved_ = 0, failed_ = 0;
};

void expect_laws(const char* name) {
    const Recipe& recipe = *std::ranges::find(recipes(), std::string_view(name), &Recipe::name);
    Trial trial(recipe);
    // Surfaces that emit are other emitters to a picture's random numbers when their triangles change.
    trial.expect({}, [&](const Law& law) {
        const bool keeps_samples =
            law.keeps_samples && (law.change != in_vertices || !has_surfaces_that_emit(recipe));
        return recipe.is_without_extent() || keeps_samples;
    });
    if (recipe.is_without_extent() || has_meshes_that_emit(recipe)) return;
    Look noiseless;
    noiseless.estimator = render::Estimator::analytic;
    noiseless.visibility = render::Visibility::none;
    trial.expect(noiseless, [&](const Law& law) { return !law.keeps_samples || law.change == in_vertices; });
}

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

} // namespace
