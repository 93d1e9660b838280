// The schema of extras.steradian.
#include "gltf/schema.hpp"

#include "scene/conductor.hpp"
#include "scene/lights/light.hpp"
#include "scene/material.hpp"

#include <algorithm>
#include <span>
#include <variant>

namespace sr::gltf {
namespace {

using namespace schemas;

Schema closed(std::vector<PropertySchema> properties) {
    Schema schema = object(std::move(properties));
    schema.additional_properties = false;
    return schema;
}

/// The extras of a glTF object in which `steradian` has these properties.
Schema extras(std::vector<PropertySchema> properties) {
    Schema ours = closed(std::move(properties));
    ours.is_ours = true;
    Schema schema = object({{"steradian", std::move(ours)}});
    schema.is_optional = true;
    return schema;
}

Schema three_numbers() { return array(number(), 3); }

/// The properties of all that emits.
std::vector<PropertySchema> emission_properties() {
    std::vector<std::string_view> units;
    for (const scene::NamedUnit& named : scene::unit_names) units.push_back(named.name);
    return {{"quantity", closed({{"value", number(), true}, {"unit", string(std::move(units)), true}})},
            {"color", three_numbers()},
            {"temperature", number()},
            {"spectrum", array(array(number(), 2))}};
}

/// Appends a size, unless another light has one of this name.
void add_size(std::vector<PropertySchema>& to, std::string_view key) {
    if (std::ranges::find(to, key, &PropertySchema::name) == to.end()) to.emplace_back(key, number());
}

/// Appends the sizes of the lights of extensions.
void add_extension_sizes(std::vector<PropertySchema>& to) {
    scene::for_each_light_kind([&]<class L>(std::type_identity<L>) {
        if constexpr (
            requires { L::dimensions; } && !requires { L::shapes; })
            for (const auto& size : L::dimensions) add_size(to, size.key);
    });
}

Schema parameter_schema(const scene::BrdfParameter& parameter) {
    if (parameter.key == "metal") return string(scene::metal_names());
    if (parameter.key == "ior_spectrum") return array(three_numbers());
    if (std::holds_alternative<float scene::Material::*>(parameter.member)) return number();
    if (std::holds_alternative<vec3 scene::Material::*>(parameter.member)) return three_numbers();
    if (std::holds_alternative<int scene::Material::*>(parameter.member)) return string(); // a file
    return closed({{"n", three_numbers(), true}, {"k", three_numbers(), true}});
}

void append(std::vector<PropertySchema>& to, std::vector<PropertySchema> more) {
    to.insert(to.end(), more.begin(), more.end());
}

} // namespace

Schema node_extras_schema() {
    std::vector<std::string_view> shapes;
    std::vector<PropertySchema> sizes;
    scene::for_each_light_kind([&]<class L>(std::type_identity<L>) {
        if constexpr (requires { L::shapes; })
            for (const auto& named : L::shapes) {
                shapes.push_back(named.name);
                for (const auto& size : named.dimensions) add_size(sizes, size.key);
            }
    });
    add_extension_sizes(sizes);
    std::vector<PropertySchema> properties{{"shape", string(std::move(shapes))}};
    append(properties, std::move(sizes));
    properties.emplace_back("corners", array(three_numbers()));
    append(properties, emission_properties());
    append(properties, {{"texture", index("/textures")}, {"visible", boolean()}, {"two_sided", boolean()}});
    return extras(std::move(properties));
}

Schema light_extras_schema() {
    std::vector<PropertySchema> properties;
    add_extension_sizes(properties);
    append(properties, emission_properties());
    properties.emplace_back("visible", boolean());
    return extras(std::move(properties));
}

Schema material_extras_schema() {
    std::vector<std::string_view> models;
    for (const scene::BrdfModel& model : std::span(scene::brdf_models).subspan(1)) // the first is glTF's own
        models.push_back(model.name);
    std::vector<PropertySchema> properties = emission_properties();
    properties.emplace_back("brdf", string(std::move(models)));
    for (const scene::BrdfParameter& parameter : scene::brdf_parameters)
        properties.emplace_back(parameter.key, parameter_schema(parameter));
    return extras(std::move(properties));
}

Schema scene_extras_schema() {
    Schema environment = closed({{"file", string()},
                                 {"radiance", three_numbers()},
                                 {"strength", number()},
                                 {"rotation", number()},
                                 {"visible", boolean()}});
    environment.is_ours = true;
    return extras({{"environment", std::move(environment)}});
}

Schema asset_extras_schema() { return extras({{"units", string({"photometric", "radiometric"})}}); }

} // namespace sr::gltf
