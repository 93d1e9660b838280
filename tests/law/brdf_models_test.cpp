#include "brdf/laws.hpp"
#include "scene/conductor.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;
using scene::Material;
using scene::Model;

namespace {

Material material_of(Model model, float roughness, float metallic = 1.0f) {
    Material material;
    material.model = model;
    material.roughness = roughness;
    material.metallic = metallic;
    return material;
}

/// All laws, for materials that differ in their parameters only.
void expect_lawful(const std::vector<Material>& materials, bool has_compensation = false) {
    context();
    brdf::BrdfEvaluator evaluator({materials.at(0), {}, has_compensation, {}});
    for (const Material& material : materials) {
        evaluator.change(material);
        for (const brdf::Law& law : brdf::check_laws(evaluator)) {
            if (law.is_waived) continue;
            EXPECT_LE(law.worst, law.limit) << scene::name_of(material.model) << ", roughness "
                                            << material.roughness << ": " << law.name << " at " << law.where;
        }
    }
}

/// White, and with a layer that `change` adds.
template<class Change>
std::vector<Material> metals(std::initializer_list<float> roughnesses, Change change) {
    std::vector<Material> materials;
    for (const float roughness : roughnesses) {
        materials.push_back(material_of(Model::metallic_roughness, roughness));
        change(materials.back());
    }
    return materials;
}

const Test anisotropy("law.brdf.anisotropy", [] {
    expect_lawful(metals({0.2f, 0.5f}, [](Material& m) {
        m.anisotropy = 1.4f * m.roughness;
        m.anisotropy_rotation = 0.6f;
    }));
});

const Test clearcoat("law.brdf.clearcoat", [] {
    expect_lawful(metals({0.3f, 0.7f}, [](Material& m) {
        m.clearcoat = m.roughness + 0.3f;
        m.clearcoat_roughness = 0.8f - m.roughness;
    }));
});

// Down to a roughness where the fitted lobe by itself sends back 60 % more than it gets.
const Test sheen("law.brdf.sheen", [] {
    expect_lawful(metals({0.15f, 0.4f, 1.0f}, [](Material& m) {
        m.sheen_color = vec3(1.0f);
        m.sheen_roughness = m.roughness;
    }));
});

const Test iridescence("law.brdf.iridescence", [] {
    expect_lawful(metals({0.3f, 0.6f}, [](Material& m) {
        m.iridescence = 1.0f;
        m.base_color = vec4(0.9f, 0.5f, 0.1f, 1.0f);
        m.film_ior = 1.0f + m.roughness;
        m.max_film_thickness = 1000.0f * m.roughness;
    }));
});

const Test lambert("law.brdf.lambert", [] { expect_lawful({material_of(Model::lambert, 0.5f)}); });

const Test oren_nayar("law.brdf.oren_nayar", [] {
    expect_lawful({material_of(Model::oren_nayar, 0.5f), material_of(Model::oren_nayar, 1.0f)});
});

std::vector<Material> glossy(Model model) {
    std::vector<Material> materials;
    for (const float exponent : {1.0f, 20.0f, 1000.0f}) {
        materials.push_back(material_of(model, 0.5f));
        materials.back().base_color = vec4(0.4f);
        materials.back().specular_color = vec3(0.6f);
        materials.back().exponent = exponent;
    }
    return materials;
}

const Test phong("law.brdf.phong", [] { expect_lawful(glossy(Model::phong)); });
const Test blinn_phong("law.brdf.blinn_phong", [] { expect_lawful(glossy(Model::blinn_phong)); });

const Test ggx("law.brdf.ggx_with_two_widths", [] {
    Material brushed = material_of(Model::ggx, 0.6f);
    brushed.roughness_across = 0.2f;
    expect_lawful({brushed});
});

const Test conductor("law.brdf.conductor", [] {
    std::vector<Material> materials;
    for (const char* name : {"gold", "iron"}) {
        materials.push_back(material_of(Model::conductor, 0.3f));
        materials.back().conductor = scene::fit_ior(*scene::measured_metal(name));
    }
    expect_lawful(materials);
});

/// The albedo for the views of the laws.
std::vector<glm::dvec3> albedos(brdf::BrdfEvaluator& evaluator) {
    return evaluator.albedos(brdf::viewing_directions(), 8192);
}

// The purpose of EON: white clay loses nothing at any roughness; and Lambert of albedo ρ returns ρ.
const Test preserves("law.brdf.oren_nayar.white_loses_nothing", [] {
    context();
    brdf::BrdfEvaluator evaluator({material_of(Model::oren_nayar, 0.0f), {}, false, {}});
    for (const float roughness : {0.0f, 0.3f, 1.0f})
        for (const float rho : {1.0f, 0.5f}) {
            Material clay = material_of(Model::oren_nayar, roughness);
            clay.base_color = vec4(rho);
            evaluator.change(clay);
            if (rho == 1.0f || roughness == 0.0f)
                for (const glm::dvec3 albedo : albedos(evaluator))
                    EXPECT_NEAR(albedo.x, rho, 2e-3) << roughness;
            else
                EXPECT_LT(albedos(evaluator).back().x, rho);
        }
});

// With compensation a white conductor returns all light at every roughness and view; without, rough ones do
// not.
const Test furnace("law.brdf.energy_compensation.white_furnace", [] {
    context();
    brdf::BrdfEvaluator with({material_of(Model::ggx, 0.5f), {}, true, {}});
    brdf::BrdfEvaluator without({material_of(Model::ggx, 0.5f), {}, false, {}});
    for (const float roughness : {0.0f, 0.1f, 0.25f, 0.4f, 0.55f, 0.7f, 0.85f, 1.0f}) {
        with.change(material_of(Model::ggx, roughness));
        for (const glm::dvec3 albedo : albedos(with))
            EXPECT_NEAR(albedo.x, 1.0, 0.01) << "roughness " << roughness;
    }
    without.change(material_of(Model::ggx, 1.0f));
    EXPECT_LT(albedos(without).at(2).x, 0.8);
});

const Test compensated("law.brdf.energy_compensation.is_lawful", [] {
    expect_lawful({material_of(Model::ggx, 0.3f), material_of(Model::ggx, 0.9f)}, true);
});

} // namespace
