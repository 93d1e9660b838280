#include "gltf/extras_rules.hpp"

#include "scene/conductor.hpp"
#include "scene/lights/light.hpp"
#include "scene/material.hpp"

#include <algorithm>
#include <span>
#include <variant>

namespace sr::gltf {
namespace {

using Kind = Rule::Kind;

// All in one function-local static: rules.cpp points here before main.
struct ExtrasRules {
    Rule boolean{.kind = Kind::boolean};
    Rule number{.kind = Kind::number};
    Rule three_numbers{.kind = Kind::list, .element = &number, .length = 3};
    Rule corners{.kind = Kind::list, .element = &three_numbers};
    Rule sample{.kind = Kind::list, .element = &number, .length = 2};
    Rule spectrum{.kind = Kind::list, .element = &sample};
    Rule texture{.kind = Kind::index, .pool = "/textures"};
    Rule shape{.kind = Kind::text}; // the names of all kinds of light
    Rule unit{.kind = Kind::text};
    Rule system{.kind = Kind::text, .words = {"photometric", "radiometric"}};
    Rule quantity{.kind = Kind::record,
                  .properties = {{"value", &number, true}, {"unit", &unit, true}},
                  .is_closed = true};

    Rule text{.kind = Kind::text};
    Rule brdf{.kind = Kind::text}; // the names of all BRDFs but glTF's own
    Rule metal{.kind = Kind::text, .words = scene::metal_names()};
    Rule complex_ior{.kind = Kind::record,
                     .properties = {{"n", &three_numbers, true}, {"k", &three_numbers, true}},
                     .is_closed = true};
    Rule ior_point{.kind = Kind::list, .element = &number, .length = 3};
    Rule ior_spectrum{.kind = Kind::list, .element = &ior_point};

    // clang-format off
    Rule node{.kind = Kind::record, .properties = {
        {"corners", &corners}, {"quantity", &quantity}, {"color", &three_numbers},
        {"temperature", &number}, {"spectrum", &spectrum}, {"texture", &texture}, {"visible", &boolean},
        {"two_sided", &boolean}}, .is_closed = true, .is_ours = true};
    Rule light{.kind = Kind::record, .properties = {
        {"quantity", &quantity}, {"color", &three_numbers}, {"temperature", &number}, {"spectrum", &spectrum},
        {"visible", &boolean}}, .is_closed = true, .is_ours = true};
    Rule material{.kind = Kind::record, .properties = {
        {"quantity", &quantity}, {"color", &three_numbers}, {"temperature", &number}, {"spectrum", &spectrum},
        {"brdf", &brdf}},
        .is_closed = true, .is_ours = true};
    Rule environment{.kind = Kind::record, .properties = {
        {"file", &text}, {"radiance", &three_numbers}, {"strength", &number}, {"rotation", &number},
        {"visible", &boolean}}, .is_closed = true, .is_ours = true};
    Rule scene{.kind = Kind::record, .properties = {{"environment", &environment}}, .is_closed = true, .is_ours = true};
    Rule asset{.kind = Kind::record, .properties = {{"units", &system}}, .is_closed = true, .is_ours = true};
    // clang-format on

    Rule node_extras{.kind = Kind::record, .properties = {{"steradian", &node}}, .is_optional = true};
    Rule light_extras{.kind = Kind::record, .properties = {{"steradian", &light}}, .is_optional = true};
    Rule material_extras{.kind = Kind::record, .properties = {{"steradian", &material}}, .is_optional = true};
    Rule scene_extras{.kind = Kind::record, .properties = {{"steradian", &scene}}, .is_optional = true};
    Rule asset_extras{.kind = Kind::record, .properties = {{"steradian", &asset}}, .is_optional = true};

    ExtrasRules() {
        for (const scene::BrdfModel& model : std::span(scene::brdf_models).subspan(1))
            brdf.words.push_back(model.name);
        for (const scene::BrdfParameter& parameter : scene::brdf_parameters)
            material.properties.push_back({parameter.key, rule_of(parameter)});
        for (const scene::NamedUnit& named : scene::unit_names) unit.words.push_back(named.name);
        std::vector<PropertyRule> of_node{{"shape", &shape}}, of_light;
        const auto add = [&](std::vector<PropertyRule>& to, std::string_view key) {
            if (std::ranges::find(to, key, &PropertyRule::name) == to.end()) to.push_back({key, &number});
        };
        scene::for_each_light_kind([&]<class L>(std::type_identity<L>) {
            if constexpr (requires { L::shapes; })
                for (const auto& named : L::shapes) {
                    shape.words.push_back(named.name);
                    for (const auto& size : named.dimensions) add(of_node, size.key);
                }
        });
        scene::for_each_light_kind([&]<class L>(std::type_identity<L>) { // lights of extensions
            if constexpr (
                requires { L::dimensions; } && !requires { L::shapes; })
                for (const auto& size : L::dimensions) {
                    add(of_node, size.key);
                    add(of_light, size.key);
                }
        });
        node.properties.insert(node.properties.begin(), of_node.begin(), of_node.end());
        light.properties.insert(light.properties.begin(), of_light.begin(), of_light.end());
    }

    const Rule* rule_of(const scene::BrdfParameter& parameter) const {
        if (parameter.key == "metal") return &metal;
        if (parameter.key == "ior_spectrum") return &ior_spectrum;
        if (std::holds_alternative<float scene::Material::*>(parameter.member)) return &number;
        if (std::holds_alternative<vec3 scene::Material::*>(parameter.member)) return &three_numbers;
        if (std::holds_alternative<int scene::Material::*>(parameter.member)) return &text;
        return &complex_ior;
    }
};

const ExtrasRules& extras_rules() {
    static const ExtrasRules all;
    return all;
}

} // namespace

const Rule& node_extras_rule() { return extras_rules().node_extras; }
const Rule& light_extras_rule() { return extras_rules().light_extras; }
const Rule& material_extras_rule() { return extras_rules().material_extras; }
const Rule& scene_extras_rule() { return extras_rules().scene_extras; }
const Rule& asset_extras_rule() { return extras_rules().asset_extras; }

} // namespace sr::gltf
