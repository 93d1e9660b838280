#include "support/address.hpp"
#include "truth/ball_scenes.hpp"
#include "truth/rendering.hpp"

#include <fmt/format.h>

using namespace sr;
using namespace sr::testing;

namespace {

/// A ball against Mitsuba's. The line is one of tests/truth/README.md's table.
void expect_ball(std::string_view brdf, std::string_view light) {
    SCOPED_TRACE(std::string(brdf));
    const truth::Distance d =
        truth::distance(truth::rendered_ball(brdf, light), truth::stored_ball(brdf, light));
    fmt::print("| {} | {} | {:.3f} ± {:.3f} | {:.2f} | {:.1f} | {:.1f} | {:.2f} |\n", brdf, light,
               100.0 * d.energy, 100.0 * d.energy_noise, d.rms, 100.0 * d.beyond_three, d.largest,
               100.0 * d.median);
    EXPECT_LT(d.energy, 0.005);
    EXPECT_LT(d.energy_noise, 0.0025) << "too much noise for the claim";
    EXPECT_LT(d.beyond_three, 0.04); // as truth_test.cpp has it
    EXPECT_LT(d.largest, 6.0);
    EXPECT_LT(d.rms, 1.25) << "a difference that every pixel hides in its noise";
}

void expect_balls(std::string_view light) {
    for (const auto brdf : truth::ball_brdfs)
        if (truth::is_lit(brdf, light)) expect_ball(brdf, light);
}

const Test rectangle("truth.balls.rectangle", [] { expect_balls("rectangle"); });
const Test environment("truth.balls.environment", [] { expect_balls("environment"); });
const Test point("truth.balls.point", [] { expect_balls("point"); });

} // namespace
