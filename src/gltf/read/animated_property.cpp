#include "gltf/read/animated_property.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace sr::gltf {
namespace {

using tinygltf::Value;
using Kind = PropertyForm::Kind;
using Tokens = std::span<const std::string_view>;

/// A property of an extension's object, and how many numbers it has.
struct Listed {
    std::string_view extension;
    std::string_view name;
    std::size_t width;
};

constexpr std::array material_properties{
    Listed{"KHR_materials_pbrSpecularGlossiness", "diffuseFactor", 4},
    Listed{"KHR_materials_pbrSpecularGlossiness", "specularFactor", 3},
    Listed{"KHR_materials_pbrSpecularGlossiness", "glossinessFactor", 1},
    Listed{"KHR_materials_emissive_strength", "emissiveStrength", 1},
    Listed{"KHR_materials_ior", "ior", 1},
    Listed{"KHR_materials_specular", "specularFactor", 1},
    Listed{"KHR_materials_specular", "specularColorFactor", 3},
    Listed{"KHR_materials_clearcoat", "clearcoatFactor", 1},
    Listed{"KHR_materials_clearcoat", "clearcoatRoughnessFactor", 1},
    Listed{"KHR_materials_sheen", "sheenColorFactor", 3},
    Listed{"KHR_materials_sheen", "sheenRoughnessFactor", 1},
    Listed{"KHR_materials_anisotropy", "anisotropyStrength", 1},
    Listed{"KHR_materials_anisotropy", "anisotropyRotation", 1},
    Listed{"KHR_materials_iridescence", "iridescenceFactor", 1},
    Listed{"KHR_materials_iridescence", "iridescenceIor", 1},
    Listed{"KHR_materials_iridescence", "iridescenceThicknessMinimum", 1},
    Listed{"KHR_materials_iridescence", "iridescenceThicknessMaximum", 1},
    Listed{"KHR_materials_transmission", "transmissionFactor", 1},
    Listed{"KHR_materials_volume", "thicknessFactor", 1},
    Listed{"KHR_materials_volume", "attenuationDistance", 1},
    Listed{"KHR_materials_volume", "attenuationColor", 3},
    Listed{"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 1},
    Listed{"KHR_materials_diffuse_transmission", "diffuseTransmissionColorFactor", 3},
};

constexpr std::array transform_properties{Listed{"KHR_texture_transform", "offset", 2},
                                          Listed{"KHR_texture_transform", "rotation", 1},
                                          Listed{"KHR_texture_transform", "scale", 2}};

constexpr std::array area_properties{
    Listed{"EXT_lights_area", "color", 3}, Listed{"EXT_lights_area", "intensity", 1},
    Listed{"EXT_lights_area", "size", 1}, Listed{"EXT_lights_area", "aspect", 1}};

constexpr std::array ies_properties{Listed{"EXT_lights_ies", "multiplier", 1},
                                    Listed{"EXT_lights_ies", "color", 3}};

std::vector<std::string_view> tokens_of(std::string_view pointer) {
    std::vector<std::string_view> tokens;
    while (pointer.starts_with('/')) {
        const auto end = std::min(pointer.find('/', 1), pointer.size());
        tokens.push_back(pointer.substr(1, end - 1));
        pointer.remove_prefix(end);
    }
    return tokens;
}

template<class T>
T* element(std::vector<T>& list, std::string_view token) {
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(token.data(), token.data() + token.size(), index);
    const bool is_index = failure == std::errc{} && end == token.data() + token.size();
    return is_index && index < list.size() ? &list[index] : nullptr;
}

std::optional<Property> number(double& value) { return Property({}, &value); }

std::optional<Property> numbers(std::vector<double>& values, std::size_t width) {
    return Property({width}, &values);
}

/// The member `name` of an object, if it is listed for the extension.
std::optional<Property> listed(std::span<const Listed> list, std::string_view extension,
                               std::string_view name, Value& object) {
    const auto found = std::ranges::find_if(
        list, [&](const Listed& entry) { return entry.extension == extension && entry.name == name; });
    if (found == list.end() || !object.IsObject()) return std::nullopt;
    return Property({found->width}, Property::Member{&object, std::string(name)});
}

/// .../extensions/EXTENSION/NAME
std::optional<Property> in_extension(std::span<const Listed> list, tinygltf::ExtensionMap& extensions,
                                     Tokens tokens) {
    if (tokens.size() != 3 || tokens[0] != "extensions") return std::nullopt;
    const auto found = extensions.find(std::string(tokens[1]));
    return found == extensions.end() ? std::nullopt : listed(list, tokens[1], tokens[2], found->second);
}

/// A texture within an extension's object: NAMETexture/extensions/KHR_texture_transform/NAME.
std::optional<Property> in_extension_texture(Value& object, Tokens tokens) {
    if (tokens.size() != 4 || !object.IsObject()) return std::nullopt;
    Value* here = &object;
    for (const std::string_view key : tokens.first(3)) {
        if (!here->IsObject() || !here->Has(std::string(key))) return std::nullopt;
        here = &here->Get<Value::Object>().at(std::string(key));
    }
    return listed(transform_properties, tokens[2], tokens[3], *here);
}

std::optional<Property> weights(Document& document, int mesh, std::vector<double>& own, Tokens tokens) {
    if (mesh < 0 || tokens.empty() || tokens[0] != "weights") return std::nullopt;
    const std::size_t count = target_count(document, mesh);
    if (own.empty()) own = document.model.meshes[static_cast<std::size_t>(mesh)].weights;
    own.resize(count, 0.0);
    if (tokens.size() == 1 && count > 0) return numbers(own, count);
    const double* one = tokens.size() == 2 ? element(own, tokens[1]) : nullptr;
    if (!one) return std::nullopt;
    return Property({}, Property::Element{&own, static_cast<std::size_t>(one - own.data())});
}

std::optional<Property> in_node(Document& document, tinygltf::Node& node, Tokens tokens) {
    if (tokens.size() == 3 && tokens[1] == "KHR_node_visibility") {
        const auto found = node.extensions.find("KHR_node_visibility");
        if (found == node.extensions.end() || !found->second.IsObject() || tokens[2] != "visible")
            return std::nullopt;
        return Property({1, Kind::flag}, Property::Member{&found->second, "visible"});
    }
    if (tokens.size() == 3) return in_extension(ies_properties, node.extensions, tokens);
    if (tokens[0] == "weights") return weights(document, node.mesh, node.weights, tokens);
    if (tokens.size() != 1 || !node.matrix.empty()) return std::nullopt;
    if (tokens[0] == "translation") return numbers(node.translation, 3);
    if (tokens[0] == "rotation") return Property({4, Kind::rotation}, &node.rotation);
    if (tokens[0] == "scale") return numbers(node.scale, 3);
    return std::nullopt;
}

std::optional<Property> in_texture(tinygltf::ExtensionMap& extensions, Tokens tokens) {
    return in_extension(transform_properties, extensions, tokens);
}

std::optional<Property> in_surface(tinygltf::PbrMetallicRoughness& pbr, Tokens tokens) {
    if (tokens[0] == "baseColorTexture")
        return in_texture(pbr.baseColorTexture.extensions, tokens.subspan(1));
    if (tokens[0] == "metallicRoughnessTexture")
        return in_texture(pbr.metallicRoughnessTexture.extensions, tokens.subspan(1));
    if (tokens.size() != 1) return std::nullopt;
    if (tokens[0] == "baseColorFactor") return numbers(pbr.baseColorFactor, 4);
    if (tokens[0] == "metallicFactor") return number(pbr.metallicFactor);
    if (tokens[0] == "roughnessFactor") return number(pbr.roughnessFactor);
    return std::nullopt;
}

std::optional<Property> in_material(tinygltf::Material& material, Tokens tokens) {
    if (tokens[0] == "pbrMetallicRoughness" && tokens.size() > 1)
        return in_surface(material.pbrMetallicRoughness, tokens.subspan(1));
    if (tokens[0] == "emissiveTexture")
        return in_texture(material.emissiveTexture.extensions, tokens.subspan(1));
    if (tokens[0] == "normalTexture" && tokens.size() == 2 && tokens[1] == "scale")
        return number(material.normalTexture.scale);
    if (tokens[0] == "normalTexture") return in_texture(material.normalTexture.extensions, tokens.subspan(1));
    if (tokens[0] == "extensions" && tokens.size() == 6) {
        const auto found = material.extensions.find(std::string(tokens[1]));
        return found == material.extensions.end() ? std::nullopt
                                                  : in_extension_texture(found->second, tokens.subspan(2));
    }
    if (tokens[0] == "extensions") return in_extension(material_properties, material.extensions, tokens);
    if (tokens.size() != 1) return std::nullopt;
    if (tokens[0] == "emissiveFactor") return numbers(material.emissiveFactor, 3);
    if (tokens[0] == "alphaCutoff") return number(material.alphaCutoff);
    return std::nullopt;
}

std::optional<Property> in_camera(tinygltf::Camera& camera, Tokens tokens) {
    if (tokens.size() != 2) return std::nullopt;
    if (tokens[0] == "perspective" && camera.type == "perspective") {
        if (tokens[1] == "yfov") return number(camera.perspective.yfov);
        if (tokens[1] == "aspectRatio") return number(camera.perspective.aspectRatio);
        if (tokens[1] == "znear") return number(camera.perspective.znear);
        if (tokens[1] == "zfar") return number(camera.perspective.zfar);
    }
    if (tokens[0] == "orthographic" && camera.type == "orthographic") {
        if (tokens[1] == "xmag") return number(camera.orthographic.xmag);
        if (tokens[1] == "ymag") return number(camera.orthographic.ymag);
        if (tokens[1] == "znear") return number(camera.orthographic.znear);
        if (tokens[1] == "zfar") return number(camera.orthographic.zfar);
    }
    return std::nullopt;
}

std::optional<Property> in_punctual_light(tinygltf::Light& light, Tokens tokens) {
    if (tokens.size() == 2 && tokens[0] == "spot" && light.type == "spot") {
        if (tokens[1] == "innerConeAngle") return number(light.spot.innerConeAngle);
        if (tokens[1] == "outerConeAngle") return number(light.spot.outerConeAngle);
    }
    if (tokens.size() != 1) return std::nullopt;
    if (tokens[0] == "color") return numbers(light.color, 3);
    if (tokens[0] == "intensity") return number(light.intensity);
    if (tokens[0] == "range") return number(light.range);
    return std::nullopt;
}

/// /extensions/EXTENSION/lights/INDEX/...
std::optional<Property> in_root_extension(tinygltf::Model& model, Tokens tokens) {
    if (tokens.size() < 4 || tokens[1] != "lights") return std::nullopt;
    if (tokens[0] == "KHR_lights_punctual") {
        tinygltf::Light* light = element(model.lights, tokens[2]);
        return light ? in_punctual_light(*light, tokens.subspan(3)) : std::nullopt;
    }
    const auto found = model.extensions.find("EXT_lights_area");
    if (tokens[0] != "EXT_lights_area" || found == model.extensions.end()) return std::nullopt;
    auto& lights = found->second.Get<Value::Object>();
    if (!lights.contains("lights") || !lights.at("lights").IsArray()) return std::nullopt;
    Value* light = element(lights.at("lights").Get<Value::Array>(), tokens[2]);
    if (light && tokens.size() == 5 && tokens[3] == "rect" && light->Has("rect"))
        return listed(area_properties, tokens[0], tokens[4], light->Get<Value::Object>().at("rect"));
    return light && tokens.size() == 4 ? listed(area_properties, tokens[0], tokens[3], *light) : std::nullopt;
}

Value as_value(const PropertyForm& form, std::span<const double> numbers) {
    if (form.kind == Kind::flag) return Value(numbers[0] != 0.0);
    if (form.width == 1) return Value(numbers[0]);
    Value::Array array;
    for (const double n : numbers) array.emplace_back(n);
    return Value(std::move(array));
}

} // namespace

Property::Property(PropertyForm form, Place place) : form_(form), place_(std::move(place)) {
    if (auto* const* number = std::get_if<double*>(&place_))
        rest_ = **number;
    else if (auto* const* array = std::get_if<std::vector<double>*>(&place_))
        rest_ = **array;
    else if (const auto* element = std::get_if<Element>(&place_))
        rest_ = (*element->array)[element->index];
    else if (const auto& [object, key] = std::get<Member>(place_); object->Has(key))
        rest_ = std::optional(object->Get(key));
    else
        rest_ = std::optional<Value>();
}

void Property::set(std::span<const double> numbers) {
    require(numbers.size() == form_.width, "a property is set to as many numbers as it has");
    if (auto** number = std::get_if<double*>(&place_))
        **number = numbers[0];
    else if (auto** array = std::get_if<std::vector<double>*>(&place_))
        (*array)->assign(numbers.begin(), numbers.end());
    else if (const auto* element = std::get_if<Element>(&place_))
        (*element->array)[element->index] = numbers[0];
    else if (auto& [object, key] = std::get<Member>(place_); object)
        object->Get<Value::Object>()[key] = as_value(form_, numbers);
}

void Property::reset() {
    if (auto** number = std::get_if<double*>(&place_))
        **number = std::get<double>(rest_);
    else if (auto** array = std::get_if<std::vector<double>*>(&place_))
        **array = std::get<std::vector<double>>(rest_);
    else if (const auto* element = std::get_if<Element>(&place_))
        (*element->array)[element->index] = std::get<double>(rest_);
    else if (auto& [object, key] = std::get<Member>(place_); object) {
        const auto& value = std::get<std::optional<Value>>(rest_);
        if (value)
            object->Get<Value::Object>()[key] = *value;
        else
            object->Get<Value::Object>().erase(key);
    }
}

std::optional<Property> property_at(Document& document, std::string_view pointer) {
    const std::vector<std::string_view> all = tokens_of(pointer);
    if (all.size() < 3) return std::nullopt;
    const Tokens inner = Tokens(all).subspan(2);
    tinygltf::Model& model = document.model;
    if (all[0] == "nodes")
        if (tinygltf::Node* node = element(model.nodes, all[1])) return in_node(document, *node, inner);
    if (all[0] == "meshes")
        if (tinygltf::Mesh* mesh = element(model.meshes, all[1]))
            return weights(document, static_cast<int>(mesh - model.meshes.data()), mesh->weights, inner);
    if (all[0] == "materials")
        if (tinygltf::Material* material = element(model.materials, all[1]))
            return in_material(*material, inner);
    if (all[0] == "cameras")
        if (tinygltf::Camera* camera = element(model.cameras, all[1])) return in_camera(*camera, inner);
    if (all[0] == "extensions") return in_root_extension(model, Tokens(all).subspan(1));
    return std::nullopt;
}

std::size_t target_count(const Document& document, int mesh) {
    std::size_t count = 0;
    for (const auto& primitive : document.model.meshes[static_cast<std::size_t>(mesh)].primitives)
        count = std::max(count, primitive.targets.size());
    return count;
}

} // namespace sr::gltf
