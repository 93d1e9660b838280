// Φ = ∫ I dω: the flux that a file states against the intensities of the light that is made of it, integrated
// in doubles over directions and, for I = ∫ L max(0, n·ω) dA, over the emitter's surface.
#include "gltf/asset.hpp"
#include "scene/spectrum.hpp"
#include "support/address.hpp"
#include "support/made_gltf.hpp"
#include "support/models.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace sr;
using namespace sr::testing;
using glm::dvec3;
using sr::testing::Test;

namespace {

constexpr double pi64 = 3.14159265358979323846;
constexpr double tolerance = 1e-3;

/// Pieces of a surface: normal times area [m²].
using Patches = std::vector<dvec3>;

double luminance_of(vec3 rgb) { return scene::luminance(rgb); }

dvec3 at(const mat3& axes, double cosine, double phi) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return glm::dmat3(axes) * dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine);
}

/// ∫ I dω by the midpoint rule in cosθ and φ.
double integral(const std::function<double(dvec3)>& I, int rows) {
    const int columns = 2 * rows;
    double sum = 0.0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            sum += I(at(mat3(1.0f), -1.0 + (2.0 * i + 1.0) / rows, 2.0 * pi64 * (j + 0.5) / columns));
    return 4.0 * pi64 * sum / (rows * columns);
}

double flux_of(const Patches& patches, double L, bool is_two_sided) {
    const auto I = [&](dvec3 w) {
        double area = 0.0;
        for (const dvec3 patch : patches) {
            const double seen = glm::dot(patch, w);
            area += is_two_sided ? std::abs(seen) : std::max(seen, 0.0);
        }
        return L * area;
    };
    return integral(I, patches.size() > 100 ? 60 : 400);
}

void append_sphere(Patches& patches, double radius, int rows) {
    const double area = 4.0 * pi64 * radius * radius / (2.0 * rows * rows);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < 2 * rows; ++j)
            patches.push_back(area * at(mat3(1.0f), -1.0 + (2.0 * i + 1.0) / rows, pi64 * (j + 0.5) / rows));
}

Patches patches_of(const scene::TubeLight& l) {
    Patches patches;
    append_sphere(patches, l.radius, 30); // both round ends
    const dvec3 axis = glm::normalize(dvec3(l.half_axis));
    const dvec3 u = glm::normalize(glm::cross(axis, dvec3(0.36, 0.48, 0.8)));
    const double band = 4.0 * pi64 * l.radius * glm::length(dvec3(l.half_axis)) / 360.0;
    for (int i = 0; i < 360; ++i) {
        const double phi = 2.0 * pi64 * i / 360.0;
        patches.push_back(band * (std::cos(phi) * u + std::sin(phi) * glm::cross(axis, u)));
    }
    return patches;
}

struct NumericFlux {
    double operator()(const scene::RectangleLight& l) const {
        return flux_of({4.0 * glm::cross(dvec3(l.half_u), dvec3(l.half_v))}, luminance_of(l.L),
                       l.is_two_sided);
    }
    double operator()(const scene::DiskLight& l) const {
        // A fan of triangles: an inscribed polygon, 2e-6 short of the ellipse.
        constexpr int corners = 1800;
        dvec3 sum(0.0);
        const auto rim = [&](int i) {
            const double phi = 2.0 * pi64 * i / corners;
            return std::cos(phi) * dvec3(l.half_u) + std::sin(phi) * dvec3(l.half_v);
        };
        for (int i = 0; i < corners; ++i) sum += 0.5 * glm::cross(rim(i), rim(i + 1));
        return flux_of({sum}, luminance_of(l.L), l.is_two_sided);
    }
    double operator()(const scene::PolygonLight& l) const {
        dvec3 sum(0.0);
        for (std::size_t i = 0; i < l.corners.size(); ++i)
            sum += 0.5 * glm::cross(dvec3(l.corners[i]), dvec3(l.corners[(i + 1) % l.corners.size()]));
        return flux_of({sum}, luminance_of(l.L), l.is_two_sided);
    }
    double operator()(const scene::SphereLight& l) const {
        Patches patches;
        append_sphere(patches, l.radius, 30);
        return flux_of(patches, luminance_of(l.L), false);
    }
    double operator()(const scene::TubeLight& l) const {
        return flux_of(patches_of(l), luminance_of(l.L), false);
    }
    double operator()(const scene::MeshLight& l) const {
        Patches patches;
        for (const auto& t : l.triangles)
            patches.push_back(
                0.5 * glm::cross(dvec3(t.corners[1] - t.corners[0]), dvec3(t.corners[2] - t.corners[0])));
        return flux_of(patches, luminance_of(l.L), l.is_two_sided);
    }
    double operator()(const scene::PointLight& l) const {
        return integral([&](dvec3) { return luminance_of(l.I); }, 4);
    }
    double operator()(const scene::SpotLight& l) const {
        const scene::ConeFalloff cone = l.falloff(); // as it is drawn
        constexpr int steps = 400'000;               // of the cosine: a hard edge is narrow
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double cosine = -1.0 + (2.0 * i + 1.0) / steps;
            sum += std::pow(std::clamp(cosine * cone.scale + cone.offset, 0.0, 1.0), 2.0);
        }
        return luminance_of(l.I) * 4.0 * pi64 * sum / steps;
    }
    double operator()(const scene::DirectionalLight&) const { return 0.0; }
    double operator()(const scene::EnvironmentLight&) const { return 0.0; }
};

// A node that is turned, moved and scaled by 2, with these extras and perhaps a light of KHR_lights_punctual.
scene::Scene with(const json& stated, const json& punctual = nullptr) {
    MadeGltf made = MadeGltf::triangle();
    json node{{"name", "lamp"},
              {"translation", {1, 2, 3}},
              {"rotation", {0.5, 0.1, -0.3, 0.8}},
              {"scale", {2, 2, 2}}};
    node["extras"]["steradian"] = stated;
    if (!punctual.is_null()) {
        made.root["extensions"]["KHR_lights_punctual"]["lights"] = json::array({punctual});
        node["extensions"]["KHR_lights_punctual"]["light"] = 0;
    }
    made.root["nodes"].push_back(node);
    made.root["scenes"][0]["nodes"] = {0, 1};
    const auto file = scratch_folder("lamp") / "made.gltf";
    write_text(file, made.gltf());
    return gltf::load(file).scene;
}

struct Case {
    const char* extras;
    const char* punctual = nullptr; // a light of KHR_lights_punctual on the node
    const char* other_unit = "cd/m^2";
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {R"({"shape": "rectangle", "width": 0.4, "height": 0.1})"},
        {R"({"shape": "rectangle", "width": 0.4, "height": 0.1, "two_sided": true})", nullptr, "cd"},
        {R"({"shape": "disk", "radius": 0.2, "color": [1, 0.2, 0.1]})", nullptr, "cd"},
        {R"({"shape": "ellipse", "width": 0.6, "height": 0.2, "temperature": 2700})"},
        {R"({"shape": "sphere", "radius": 0.15})", nullptr, "cd"},
        {R"({"shape": "tube", "radius": 0.02, "length": 0.5})", nullptr, "cd"},
        {R"({"shape": "polygon", "corners": [[0, 0, 0], [1, 0, 0], [1.2, 0.8, 0], [0.4, 1.1, 0], [-0.3, 0.7, 0]]})"},
        {R"({})", R"({"type": "point"})", "cd"},
        {R"({"radius": 0.1})", R"({"type": "point", "color": [1, 0.5, 0.2]})", "cd/m^2"},
        {R"({})", R"({"type": "spot", "spot": {"innerConeAngle": 0.3, "outerConeAngle": 0.7}})", "cd"},
        {R"({})", R"({"type": "spot", "spot": {"innerConeAngle": 0.5999, "outerConeAngle": 0.6}})", "cd"},
        {R"({})", R"({"type": "spot", "spot": {"outerConeAngle": 1.5707963}})", "cd"},
    };
    return all;
}

scene::Scene stated(const Case& c, double value, const char* unit) {
    json extras = json::parse(c.extras);
    extras["quantity"] = {{"value", value}, {"unit", unit}};
    return with(extras, c.punctual ? json::parse(c.punctual) : json());
}

// Lumens in the file → radiances and intensities of the light → lumens.
const Test flux("law.light.flux.stated_lumens_are_what_the_light_emits", [] {
    for (const Case& c : cases()) {
        const scene::Scene scene = stated(c, 800.0, "lm");
        EXPECT_NEAR(std::visit(NumericFlux{}, scene.lights.at(0)), 800.0, 800.0 * tolerance)
            << c.extras << (c.punctual ? c.punctual : "");
    }
});

// Radiance or intensity in the file → the closed form of the flux, against the integral.
const Test closed_form("law.light.flux.the_closed_form_is_the_integral", [] {
    for (const Case& c : cases()) {
        const scene::Scene scene = stated(c, 70.0, c.other_unit);
        const double expected = std::visit(NumericFlux{}, scene.lights.at(0));
        EXPECT_NEAR(luminance_of(*scene::flux_of(scene.lights.at(0), scene.profiles)), expected,
                    expected * tolerance)
            << c.extras << (c.punctual ? c.punctual : "");
    }
});

// Every unit there and back: what a light has in another unit states the same light.
const Test round_trip("law.light.flux.units_convert_both_ways", [] {
    for (const Case& c : cases()) {
        const double lumens = luminance_of(*scene::flux_of(stated(c, 70.0, c.other_unit).lights.at(0), {}));
        const double back = luminance_of(*scene::flux_of(stated(c, lumens, "lm").lights.at(0), {}));
        const double watts = luminance_of(*scene::flux_of(stated(c, 2.0, "W").lights.at(0), {}));
        EXPECT_NEAR(back, lumens, 1e-6 * lumens) << c.extras;
        const bool is_spectral = std::string(c.extras).find("temperature") != std::string::npos;
        const double K = is_spectral ? scene::color_of_blackbody(2700.0).efficacy : scene::lumens_per_watt;
        EXPECT_NEAR(watts, 2.0 * K, 1e-5 * K) << c.extras;
    }
});

// A quantity in cd is the intensity on the axis: of a flat light its normal, of a tube any direction
// across it.
const Test on_axis("law.light.flux.stated_candelas_are_those_on_the_axis", [] {
    const auto seen = [](const Patches& patches, dvec3 w) {
        double area = 0.0;
        for (const dvec3 patch : patches) area += std::max(glm::dot(patch, w), 0.0);
        return area;
    };
    const auto light = [](const char* extras) { return stated({extras}, 70.0, "cd").lights.at(0); };
    const auto tube =
        std::get<scene::TubeLight>(light(R"({"shape": "tube", "radius": 0.05, "length": 0.3})"));
    const dvec3 across = glm::normalize(glm::cross(dvec3(tube.half_axis), dvec3(0.3, -0.2, 0.9)));
    EXPECT_NEAR(luminance_of(tube.L) * seen(patches_of(tube), across), 70.0, 70.0 * tolerance);
    const auto sphere = std::get<scene::SphereLight>(light(R"({"shape": "sphere", "radius": 0.15})"));
    Patches patches;
    append_sphere(patches, sphere.radius, 60);
    EXPECT_NEAR(luminance_of(sphere.L) * seen(patches, glm::normalize(dvec3(1, 2, 3))), 70.0,
                70.0 * tolerance);
    const auto panel = std::get<scene::RectangleLight>(
        light(R"({"shape": "rectangle", "width": 0.4, "height": 0.1, "two_sided": true})"));
    EXPECT_NEAR(luminance_of(panel.L) * panel.area(), 70.0, 70.0 * tolerance);
});

// A mesh's flux is shared among all surfaces that have its material.
const Test mesh("law.light.flux.a_material_shares_its_lumens", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["materials"] = json::parse(
        R"([{"doubleSided": true, "emissiveFactor": [1, 0.5, 0], "extras": {"steradian": {"quantity": {"value": 500, "unit": "lm"}}}}])");
    made.primitive()["material"] = 0;
    made.root["nodes"].push_back({{"mesh", 0}, {"scale", {2, 3, 1}}});
    made.root["scenes"][0]["nodes"] = {0, 1};
    const auto file = scratch_folder("mesh") / "made.gltf";
    write_text(file, made.gltf());
    const scene::Scene scene = gltf::load(file).scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    double sum = 0.0;
    for (const float scale : {1.0f, 6.0f}) { // areas 0.5 and 3 m²
        scene::MeshLight light;
        light.triangles.push_back({{vec3(0), vec3(scale, 0, 0), vec3(0, 1, 0)}, {}});
        light.L = scene.materials.at(0).emission;
        light.is_two_sided = true;
        sum += NumericFlux{}(light);
    }
    EXPECT_NEAR(sum, 500.0, 500.0 * tolerance);
});

} // namespace
