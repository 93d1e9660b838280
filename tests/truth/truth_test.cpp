#include "support/address.hpp"
#include "truth/rendering.hpp"
#include "truth/scenes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>

using namespace sr;
using namespace sr::testing;

namespace {

/// Cells whose sum has more noise than the bar asks for, and is held to that noise: no direction of the
/// BRDF's choice finds a mesh (shaders/light/mesh.glsl), and the picture of a light without extent in a
/// smooth metal is smaller than a pixel.
bool is_noisy(std::string_view shape, std::string_view material) {
    return (shape == "mesh" && material != "lambert")
           || ((shape == "spot" || shape == "profile") && material == "ggx_01");
}

/// Of these, the one whose few bright samples tell so little of its noise that pixels are not judged by it.
bool has_unknown_noise(std::string_view shape, std::string_view material) {
    return shape == "mesh" && material == "ggx_01";
}

/// One line of tests/truth/README.md's table.
void print(std::string_view shape, std::string_view view, std::string_view material,
           const truth::Distance& d) {
    fmt::print("| {} | {} | {} | {:.3f} ± {:.3f} | {:.2f} | {:.1f} | {:.1f} | {:.2f} |\n", shape, view,
               material, 100.0 * d.energy, 100.0 * d.energy_noise, d.rms, 100.0 * d.beyond_three, d.largest,
               100.0 * d.median);
}

void expect_cell(std::string_view shape, std::string_view material, std::string_view view) {
    SCOPED_TRACE(std::string(material));
    const truth::Distance d =
        truth::distance(truth::rendered(shape, material, view), truth::stored(shape, material, view));
    print(shape, view, material, d);
    if (is_noisy(shape, material)) {
        EXPECT_LT(d.energy, std::max(0.003, 3.0 * d.energy_noise));
    } else {
        EXPECT_LT(d.energy, 0.003);
        EXPECT_LT(d.energy_noise, 0.0015) << "too much noise for the claim";
    }
    if (has_unknown_noise(shape, material)) return;
    // Noise alone puts 0.3 % of all values beyond three standard deviations (1 % of pixels if the channels
    // had nothing to do with one another, 4 % in one cell of ten thousand), and one value in 5·10^8 beyond
    // six.
    EXPECT_LT(d.beyond_three, 0.04);
    EXPECT_LT(d.largest, 6.0);
    EXPECT_LT(d.rms, 1.25) << "a difference that every pixel hides in its noise";
}

/// One picture of the matrix against Mitsuba's, material by material.
void expect_truth(std::string_view shape, std::string_view view) {
    for (const auto material : truth::materials) expect_cell(shape, material, view);
}

/// Textures that software GL would not filter exactly.
void expect_photograph(std::string_view view) { expect_cell("rectangle", truth::photograph, view); }

const Test photograph_steep("truth.photograph.steep", [] { expect_photograph("steep"); });
const Test photograph_middle("truth.photograph.middle", [] { expect_photograph("middle"); });
const Test photograph_grazing("truth.photograph.grazing", [] { expect_photograph("grazing"); });
const Test rectangle_steep("truth.rectangle.steep", [] { expect_truth("rectangle", "steep"); });
const Test rectangle_middle("truth.rectangle.middle", [] { expect_truth("rectangle", "middle"); });
const Test rectangle_grazing("truth.rectangle.grazing", [] { expect_truth("rectangle", "grazing"); });
const Test disk_steep("truth.disk.steep", [] { expect_truth("disk", "steep"); });
const Test disk_middle("truth.disk.middle", [] { expect_truth("disk", "middle"); });
const Test disk_grazing("truth.disk.grazing", [] { expect_truth("disk", "grazing"); });
const Test sphere_steep("truth.sphere.steep", [] { expect_truth("sphere", "steep"); });
const Test sphere_middle("truth.sphere.middle", [] { expect_truth("sphere", "middle"); });
const Test sphere_grazing("truth.sphere.grazing", [] { expect_truth("sphere", "grazing"); });
const Test tube_steep("truth.tube.steep", [] { expect_truth("tube", "steep"); });
const Test tube_middle("truth.tube.middle", [] { expect_truth("tube", "middle"); });
const Test tube_grazing("truth.tube.grazing", [] { expect_truth("tube", "grazing"); });
const Test polygon_steep("truth.polygon.steep", [] { expect_truth("polygon", "steep"); });
const Test polygon_middle("truth.polygon.middle", [] { expect_truth("polygon", "middle"); });
const Test polygon_grazing("truth.polygon.grazing", [] { expect_truth("polygon", "grazing"); });
const Test mesh_steep("truth.mesh.steep", [] { expect_truth("mesh", "steep"); });
const Test mesh_middle("truth.mesh.middle", [] { expect_truth("mesh", "middle"); });
const Test mesh_grazing("truth.mesh.grazing", [] { expect_truth("mesh", "grazing"); });
const Test textured_rectangle_steep("truth.textured_rectangle.steep",
                                    [] { expect_truth("textured_rectangle", "steep"); });
const Test textured_rectangle_middle("truth.textured_rectangle.middle",
                                     [] { expect_truth("textured_rectangle", "middle"); });
const Test textured_rectangle_grazing("truth.textured_rectangle.grazing",
                                      [] { expect_truth("textured_rectangle", "grazing"); });
const Test sun_steep("truth.sun.steep", [] { expect_truth("sun", "steep"); });
const Test sun_middle("truth.sun.middle", [] { expect_truth("sun", "middle"); });
const Test sun_grazing("truth.sun.grazing", [] { expect_truth("sun", "grazing"); });
const Test spot_steep("truth.spot.steep", [] { expect_truth("spot", "steep"); });
const Test spot_middle("truth.spot.middle", [] { expect_truth("spot", "middle"); });
const Test spot_grazing("truth.spot.grazing", [] { expect_truth("spot", "grazing"); });
const Test profile_steep("truth.profile.steep", [] { expect_truth("profile", "steep"); });
const Test profile_middle("truth.profile.middle", [] { expect_truth("profile", "middle"); });
const Test profile_grazing("truth.profile.grazing", [] { expect_truth("profile", "grazing"); });

} // namespace
