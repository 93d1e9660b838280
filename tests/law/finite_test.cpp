// Every channel of every picture is finite, whatever scene a file that is accepted describes: generated
// scenes that are degenerate, coplanar, coincident, huge and tiny, with factors at the ends of their ranges.
#include "core/error.hpp"
#include "support/address.hpp"
#include "support/generated.hpp"
#include "support/gl.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace {

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

/// Scenes of each of the 14 recipes. $STERADIAN_SCENES asks for more.
constexpr int usual_scenes = 80;

Extremes extremes_of(std::uint64_t seed) {
    Extremes extremes;
    extremes.has_degenerate_meshes = seed % 2 == 0;
    extremes.has_flattened_nodes = seed % 3 == 0;
    extremes.is_coplanar = seed % 4 < 2;
    extremes.is_coincident = seed % 5 < 2;
    extremes.has_extreme_factors = seed % 3 != 1;
    extremes.max_length = seed % 7 == 0 ? 1e9 : seed % 7 == 1 ? 1e4 : 1.0;
    return extremes;
}

/// One way to make pictures, and what it shows.
struct Way {
    const char* name;
    render::Estimator estimator = render::Estimator::sampled;
    render::Visibility visibility = render::Visibility::none;
    const char* shader = "forward.frag";
};

/// Besides shadow rays, which every recipe takes, a recipe takes one of these in turn: each compiles programs
/// of its own.
constexpr std::array other_ways{
    Way{"analytic", render::Estimator::analytic, render::Visibility::ray},
    Way{"map", render::Estimator::sampled, render::Visibility::map},
    Way{"ray_glsl", render::Estimator::sampled, render::Visibility::ray_in_glsl},
    Way{"none", render::Estimator::sampled, render::Visibility::none},
    Way{"arrival", render::Estimator::sampled, render::Visibility::ray, "views/arrival.frag"},
    Way{"extent", render::Estimator::sampled, render::Visibility::none, "views/solid_angle.frag"},
    Way{"cosine", render::Estimator::sampled, render::Visibility::ray, "views/cosine.frag"},
    Way{"normal", render::Estimator::sampled, render::Visibility::none, "views/normal.frag"},
};

/// Makes one kind of picture of many scenes.
class Finite {
public:
    explicit Finite(const Way& way) : way_(way) {
        context();
        options_.width = options_.height = 16;
        options_.samples = 2;
        options_.estimator = way.estimator;
        options_.shader = way.shader;
        options_.maps.size = 64;
        shaders_ = render::Renderer::programs(options_);
    }

    /// Counts the values that are not finite.
    int broken(const scene::RenderScene& stage, std::uint32_t seed) {
        const render::GpuScene gpu_scene(stage.scene, stage.lights, way_.visibility);
        options_.seed = seed;
        render::Renderer renderer(gpu_scene, stage.camera, options_, shaders_);
        for (int i = 0; i < options_.samples; ++i) renderer.add_sample();
        const image::Image film = renderer.read_film();
        return static_cast<int>(
            std::ranges::count_if(film.pixels, [](float value) { return !std::isfinite(value); }));
    }

    const char* name() const { return way_.name; }

private:
    Way way_;
    render::RenderOptions options_;
    std::shared_ptr<render::ShaderLibrary> shaders_;
};

void expect_finite(std::size_t index) {
    const Recipe& recipe = recipes()[index];
    std::array ways{Finite({"ray", render::Estimator::sampled, render::Visibility::ray}),
                    Finite(other_ways[index % other_ways.size()])};
    int scenes = 0, refused = 0, failed = 0;
    for (int i = 0; i < scenes_of_a_recipe(usual_scenes); ++i) {
        const std::uint64_t seed = first_seed() + static_cast<std::uint64_t>(i);
        std::optional<scene::RenderScene> stage;
        try {
            stage = staged(loaded(random_scene(recipe, seed, extremes_of(seed)), false));
        } catch (const Error&) {
            ++refused; // a file that is refused has no picture
            continue;
        }
        ++scenes;
        for (Finite& way : ways)
            if (const int broken = way.broken(*stage, static_cast<std::uint32_t>(seed));
                broken > 0 && ++failed <= 8)
                ADD_FAILURE() << fmt::format("recipe {}, seed {}, {}: {} values are not finite", recipe.name,
                                             seed, way.name(), broken);
    }
    ::testing::Test::RecordProperty("scenes", scenes);
    ::testing::Test::RecordProperty("refused", refused);
    EXPECT_EQ(failed, 0) << "of " << scenes << " scenes";
    EXPECT_GT(2 * scenes, refused) << "most scenes are accepted";
}

const Test finite_0("law.finite.punctual", [] { expect_finite(0); });
const Test finite_1("law.finite.profile", [] { expect_finite(1); });
const Test finite_2("law.finite.coats", [] { expect_finite(2); });
const Test finite_3("law.finite.directions", [] { expect_finite(3); });
const Test finite_4("law.finite.cloth", [] { expect_finite(4); });
const Test finite_5("law.finite.lobes", [] { expect_finite(5); });
const Test finite_6("law.finite.leaves", [] { expect_finite(6); });
const Test finite_7("law.finite.panes", [] { expect_finite(7); });
const Test finite_8("law.finite.panels", [] { expect_finite(8); });
const Test finite_9("law.finite.pictures", [] { expect_finite(9); });
const Test finite_10("law.finite.rounds", [] { expect_finite(10); });
const Test finite_11("law.finite.lamps", [] { expect_finite(11); });
const Test finite_12("law.finite.polygons", [] { expect_finite(12); });
const Test finite_13("law.finite.glows", [] { expect_finite(13); });

} // namespace
