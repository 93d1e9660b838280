#include "brdf/evaluator.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/models.hpp"
#include "truth/ball_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

using namespace sr;
using namespace sr::testing;

namespace {

/// A line of tests/truth/references/brdf_models.csv.
struct Line {
    std::string brdf;
    std::array<float, 8> p{};
    brdf::DirectionPair pair;
    vec3 f_r{0.0f}; // [1/sr], as Mitsuba has it
};

vec3 direction(double theta, double phi) { // [degrees]
    constexpr double degree = 3.14159265358979323846 / 180.0;
    const double t = theta * degree, p = phi * degree;
    return vec3(glm::dvec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)));
}

std::vector<Line> lines_of(const std::string& brdf) {
    std::ifstream file(source_folder() / "tests/truth/references/brdf_models.csv");
    std::vector<Line> lines;
    std::string text;
    while (std::getline(file, text)) {
        if (!text.starts_with(brdf + ',')) continue;
        std::replace(text.begin(), text.end(), ',', ' ');
        std::istringstream numbers(text);
        Line line;
        double theta_i = 0, phi_i = 0, theta_o = 0, phi_o = 0;
        numbers >> line.brdf;
        for (float& p : line.p) numbers >> p;
        numbers >> theta_i >> phi_i >> theta_o >> phi_o >> line.f_r.x >> line.f_r.y >> line.f_r.z;
        if (!numbers) ADD_FAILURE() << "cannot be read: " << text;
        line.pair = {direction(theta_i, phi_i), direction(theta_o, phi_o)};
        lines.push_back(line);
    }
    return lines;
}

/// Parameters as tools/truth/brdf_models_table.py names them.
scene::Material gltf(const Line& line) {
    scene::Material m;
    m.base_color = vec4(line.p[0], line.p[1], 0.5f, 1.0f);
    m.metallic = line.p[2];
    m.roughness = line.p[3];
    return m;
}

scene::Material of_model(const Line& line, scene::Model model) {
    scene::Material m = gltf(line);
    m.model = model;
    m.roughness = line.p[2];
    return m;
}

scene::Material lambert(const Line& line) { return of_model(line, scene::Model::lambert); }
scene::Material oren_nayar(const Line& line) { return of_model(line, scene::Model::oren_nayar); }
scene::Material ggx(const Line& line) { return of_model(line, scene::Model::ggx); }

scene::Material glossy(const Line& line) {
    scene::Material m = of_model(line, *scene::model_named(line.brdf));
    m.exponent = line.p[2];
    m.specular_color = vec3(line.p[3], 0.4f, 0.2f);
    return m;
}

scene::Material brushed(const Line& line) {
    scene::Material m = ggx(line);
    m.roughness_across = line.p[3];
    return m;
}

scene::Material conductor(const Line& line) {
    scene::Material m = of_model(line, scene::Model::conductor);
    m.base_color = vec4(1.0f, 1.0f, 0.5f, 1.0f);
    m.conductor = {vec3(line.p[0], line.p[1], 1.5f), vec3(line.p[2], line.p[3], 2.5f)};
    m.roughness = line.p[4];
    return m;
}

scene::Material measured(const Line& line) {
    scene::Material m = of_model(line, scene::Model::merl);
    m.measured = 0;
    return m;
}

scene::Material anisotropy(const Line& line) {
    scene::Material m = gltf(line);
    m.anisotropy = line.p[4];
    m.anisotropy_rotation = line.p[5];
    return m;
}

scene::Material clearcoat(const Line& line) {
    scene::Material m = gltf(line);
    m.clearcoat = line.p[4];
    m.clearcoat_roughness = line.p[5];
    return m;
}

scene::Material sheen(const Line& line) {
    scene::Material m = gltf(line);
    m.sheen_color = vec3(line.p[4], 0.5f, 0.3f);
    m.sheen_roughness = line.p[5];
    return m;
}

scene::Material thin_film(const Line& line) {
    scene::Material m = gltf(line);
    m.iridescence = line.p[4];
    m.film_ior = line.p[5];
    m.max_film_thickness = line.p[6];
    return m;
}

scene::Material layers(const Line& line) {
    scene::Material m = gltf(line);
    m.metallic = 0.6f;
    m.roughness = line.p[2];
    m.anisotropy = line.p[3];
    m.anisotropy_rotation = 0.4f;
    m.clearcoat = line.p[4];
    m.clearcoat_roughness = 0.3f;
    m.sheen_color = vec3(line.p[5], 0.5f, 0.3f);
    m.sheen_roughness = 0.5f;
    m.iridescence = line.p[6];
    m.film_ior = 1.5f;
    m.max_film_thickness = line.p[7];
    return m;
}

/// Every row of that BRDF: the largest difference in a row, relative to its largest channel.
void expect_rows(const std::string& brdf, scene::Material (*material)(const Line&), double limit) {
    context();
    const std::vector<Line> lines = lines_of(brdf);
    ASSERT_EQ(lines.size(), 100u);
    brdf::BrdfUnderTest tested{material(lines[0]), {}, false, {}};
    if (tested.material.measured >= 0) tested.measured.push_back(truth::made_measurement());
    brdf::BrdfEvaluator evaluator(tested);
    double worst = 0.0;
    for (const Line& line : lines) {
        evaluator.change(material(line));
        const vec3 f_r = evaluator.evaluate({&line.pair, 1})[0];
        const vec3 off = glm::abs(f_r - line.f_r) / std::max({line.f_r.x, line.f_r.y, line.f_r.z});
        for (int c = 0; c < 3; ++c)
            if (!(off[c] <= worst)) worst = off[c];
    }
    fmt::print("| {} | {:.1e} |\n", brdf, worst);
    EXPECT_LE(worst, limit);
}

const Test lambert_test("truth.brdf.lambert", [] { expect_rows("lambert", lambert, 1e-5); });
const Test oren_nayar_test("truth.brdf.oren_nayar", [] { expect_rows("oren_nayar", oren_nayar, 1e-4); });
const Test phong_test("truth.brdf.phong", [] { expect_rows("phong", glossy, 1e-4); });
const Test blinn_phong_test("truth.brdf.blinn_phong", [] { expect_rows("blinn_phong", glossy, 1e-4); });
const Test ggx_test("truth.brdf.ggx", [] { expect_rows("ggx", ggx, 1e-4); });
const Test brushed_test("truth.brdf.ggx_with_two_widths", [] { expect_rows("brushed", brushed, 1e-4); });
const Test conductor_test("truth.brdf.conductor", [] { expect_rows("conductor", conductor, 1e-4); });
const Test merl_test("truth.brdf.merl", [] { expect_rows("merl", measured, 1e-4); });
const Test anisotropy_test("truth.brdf.anisotropy", [] { expect_rows("anisotropy", anisotropy, 1e-4); });
const Test clearcoat_test("truth.brdf.clearcoat", [] { expect_rows("clearcoat", clearcoat, 1e-4); });
// Ours reads the albedo of sheen from a table, Mitsuba's side integrates it.
const Test sheen_test("truth.brdf.sheen", [] { expect_rows("sheen", sheen, 1e-3); });
const Test thin_film_test("truth.brdf.iridescence", [] { expect_rows("thin_film", thin_film, 1e-4); });
const Test layers_test("truth.brdf.layers", [] { expect_rows("layers", layers, 1e-4); });

} // namespace
