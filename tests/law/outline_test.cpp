// The analytic estimator's table and its error bar; what it does where geometry degenerates.
#include "ltc/ggx.hpp"
#include "ltc/trial.hpp"
#include "render/gpu/ltc_table.hpp"
#include "render/renderer.hpp"
#include "support/address.hpp"

#include <numbers>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

float entry(int row, int column, int number) {
    return render::ltc_table()[static_cast<std::size_t>(
        (row * render::ltc_grid + column) * render::ltc_numbers + number)];
}

const Test smooth("law.brdf.ltc.table_is_finite_and_smooth", [] {
    for (int row = 0; row < render::ltc_grid; ++row)
        for (int column = 0; column < render::ltc_grid; ++column) {
            for (const int width : {0, 2}) {
                const float here = entry(row, column, width);
                ASSERT_TRUE(here > 0.05f && here < 2.0f) << row << "," << column;
                // At grazing (cosθ_o ~ α) smooth lobes change fast.
                if (column < 4 || column + 1 == render::ltc_grid) continue;
                EXPECT_NEAR(entry(row, column + 1, width) / here, 1.0f, 0.5f) << row << "," << column;
            }
            EXPECT_TRUE(std::abs(entry(row, column, 1)) <= 1.01f) << row << "," << column;
            EXPECT_TRUE(entry(row, column, 3) > 0.29f && entry(row, column, 3) <= 1.0f)
                << row << "," << column;
            EXPECT_TRUE(entry(row, column, 4) >= 0.0f && entry(row, column, 4) <= entry(row, column, 3));
        }
});

// The albedo of the table against another way of integrating (midpoints in (z, φ) instead of visible
// normals), and the fitted density, which is one by construction, with it.
const Test albedo("law.brdf.ltc.albedo_and_density", [] {
    for (const int row : {15, 22, 31})
        for (const int column : {10, 20, 31}) {
            const double u = static_cast<double>(column) / (render::ltc_grid - 1);
            const double roughness = static_cast<double>(row) / (render::ltc_grid - 1);
            const double cos_o = u * u, alpha = roughness * roughness,
                         softened = cos_o * cos_o + alpha * alpha;
            const ltc::Lobe lobe{entry(row, column, 0) * 2.0 * alpha / softened,
                                 entry(row, column, 1) * std::sqrt((1.0 - cos_o * cos_o) / softened),
                                 entry(row, column, 2) * 2.0 * alpha};
            double reflected = 0.0, density = 0.0;
            constexpr int side = 500;
            for (int i = 0; i < side; ++i)
                for (int j = 0; j < side; ++j) {
                    const double z = (i + 0.5) / side, phi = 2.0 * std::numbers::pi * (j + 0.5) / side;
                    const double r = std::sqrt(1.0 - z * z);
                    const glm::dvec3 w(r * std::cos(phi), r * std::sin(phi), z);
                    reflected += ltc::f_cos(w, ltc::direction_at(cos_o), alpha);
                    density += lobe.density(w);
                }
            const double solid_angle = 2.0 * std::numbers::pi / (side * side);
            EXPECT_NEAR(reflected * solid_angle, entry(row, column, 3), 5e-4) << row << "," << column;
            EXPECT_NEAR(density * solid_angle, 1.0, 5e-4) << row << "," << column;
        }
});

/// The bar of tools/ltc/README.md's table in its hardest cells: median 2 %, 95th percentile 10 %.
void expect_bar(ltc::Shape shape, ltc::Material material) {
    constexpr std::size_t count = 40;
    std::vector<ltc::Trial> all;
    for (const auto& [roughness, least, greatest] :
         {std::tuple(0.3, 75.0, 85.0), {0.5, 75.0, 85.0}, {0.7, 60.0, 60.0}, {0.1, 0.0, 30.0}}) {
        const ltc::Cell cell{roughness, least * degree, greatest * degree};
        const auto found = ltc::trials(shape, material, cell, count, 7, 1 << 13);
        all.insert(all.end(), found.begin(), found.end());
    }
    const auto reflected = ltc::evaluated(all, material, render::default_analytic_points);
    for (std::size_t begin = 0; begin < all.size(); begin += count) {
        const auto errors =
            ltc::errors(std::span(all).subspan(begin, count), std::span(reflected).subspan(begin, count));
        EXPECT_LE(errors[count / 2], 0.02) << "median, cell " << begin / count;
        EXPECT_LE(errors[count * 95 / 100], 0.10) << "95th percentile, cell " << begin / count;
    }
}

const Test polygons("law.integrator.analytic.error_bar.polygon", [] {
    expect_bar(ltc::Shape::polygon, ltc::Material::metal);
    expect_bar(ltc::Shape::polygon, ltc::Material::plastic);
});
const Test disks("law.integrator.analytic.error_bar.disk",
                 [] { expect_bar(ltc::Shape::disk, ltc::Material::metal); });
const Test spheres("law.integrator.analytic.error_bar.sphere",
                   [] { expect_bar(ltc::Shape::sphere, ltc::Material::metal); });
const Test tubes("law.integrator.analytic.error_bar.tube",
                 [] { expect_bar(ltc::Shape::tube, ltc::Material::metal); });

// The surface is at the origin and faces +z.
const std::vector<scene::Light> degenerate{
    scene::RectangleLight{"in the receiver's plane", {2, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec3(1.0f), true},
    scene::RectangleLight{"under the receiver", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec3(1.0f), true},
    scene::RectangleLight{"upright on the receiver", {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, vec3(1.0f), true},
    scene::RectangleLight{"a corner on the receiver", {1, 1, 1}, {1, 0, 1}, {0, 1, 0}, vec3(1.0f), true},
    scene::RectangleLight{"an edge on the horizon", {2, 0, 1}, {0, 1, 0}, {0, 0, 1}, vec3(1.0f), true},
    scene::RectangleLight{"wholly below", {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, vec3(1.0f), true},
    scene::RectangleLight{"a hair above", {0, 0, 1e-6f}, {1, 0, 0}, {0, 1, 0}, vec3(1.0f), true},
    scene::RectangleLight{"tiny and far", {0, 0, 1e4f}, {1e-3f, 0, 0}, {0, 1e-3f, 0}, vec3(1.0f), true},
    scene::RectangleLight{"enormous", {0, 0, 1}, {1e6f, 0, 0}, {0, 1e6f, 0}, vec3(1.0f), true},
    scene::DiskLight{"in the receiver's plane", {2, 0, 0}, {1, 0, 0}, {0, 1, 0}, vec3(1.0f), true},
    scene::DiskLight{"its rim on the receiver", {1, 0, 0}, {1, 0, 0}, {0, 0, 1}, vec3(1.0f), true},
    scene::DiskLight{"upright through the receiver", {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, vec3(1.0f), true},
    scene::DiskLight{"edge on", {3, 0, 1}, {1, 0, 1.0f / 3.0f}, {0, 1, 0}, vec3(1.0f), true},
    scene::DiskLight{"a hair above", {0.3f, 0, 1e-6f}, {1, 0, 0}, {0, 1, 0}, vec3(1.0f), true},
    scene::SphereLight{"around the receiver", {0, 0, 0.5f}, 1.0f},
    scene::SphereLight{"touching the receiver", {0, 0, 1}, 1.0f},
    scene::SphereLight{"touching the horizon from above", {3, 0, 1}, 1.0f},
    scene::SphereLight{"touching it from below", {3, 0, -1}, 1.0f},
    scene::SphereLight{"at the receiver", {0, 0, 0}, 1.0f},
    scene::SphereLight{"tiny and far", {0, 0, 1e4f}, 1e-3f},
    scene::TubeLight{"around the receiver", {0, 0, 0}, {1, 0, 0}, 0.5f},
    scene::TubeLight{"overhead, end on", {0, 0, 2}, {0, 0, 1}, 0.5f},
    scene::TubeLight{"end on, beside the cylinder", {0.5f, 0, 2}, {0, 0, 1}, 0.5f},
    scene::TubeLight{"lying on the receiver", {0, 0, 0.5f}, {1, 0, 0}, 0.5f},
    scene::TubeLight{"half sunk", {3, 0, 0}, {0, 1, 0}, 0.5f},
    scene::TubeLight{"as long as the sky", {0, 0, 1}, {1e4f, 0, 0}, 0.1f},
};

void expect_finite(int points) {
    std::vector<ltc::Trial> cases;
    for (const scene::Light& light : degenerate)
        for (const double alpha : {1e-4, 0.25, 1.0})
            for (const double cos_o : {0.0, 0.3, 1.0}) cases.push_back({light, alpha, cos_o, 1.0});
    const auto reflected = ltc::evaluated(cases, ltc::Material::plastic, points);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto name = scene::name_of(cases[i].light);
        // White plastic of glTF reflects more than twice the light at grazing (shaders/README.md).
        EXPECT_TRUE(reflected[i] >= 0.0 && reflected[i] < 2.5)
            << cases[i].light.index() << " '" << name << "', alpha " << cases[i].alpha << ", cos_o "
            << cases[i].cos_o << ": " << reflected[i];
    }
}

const Test finite("law.integrator.analytic.finite_where_geometry_degenerates", [] { expect_finite(16); });
const Test finite_plain("law.integrator.analytic.finite_without_points", [] { expect_finite(0); });

} // namespace
