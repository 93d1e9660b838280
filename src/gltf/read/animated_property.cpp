#include "gltf/read/animated_property.hpp"

#include "core/error.hpp"
#include "gltf/schema.hpp"
#include "gltf/tinygltf.hpp"

#include <algorithm>
#include <charconv>

namespace sr::gltf {
namespace {

using Tokens = std::vector<std::string_view>;
using PropertyKind = AnimatedProperty::Kind;

Tokens tokens_of(std::string_view pointer) {
    Tokens tokens;
    while (pointer.starts_with('/')) {
        const auto end = std::min(pointer.find('/', 1), pointer.size());
        tokens.push_back(pointer.substr(1, end - 1));
        pointer.remove_prefix(end);
    }
    return tokens;
}

std::optional<std::size_t> index_in(const json& array, std::string_view token) {
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(token.data(), token.data() + token.size(), index);
    const bool is_index = failure == std::errc{} && end == token.data() + token.size();
    return is_index && index < array.size() ? std::optional(index) : std::nullopt;
}

const Schema* schema_in(const Schema& object, std::string_view name) {
    const auto found = std::ranges::find(object.properties, name, &PropertySchema::name);
    return found == object.properties.end() ? nullptr : found->schema.get();
}

/// Returns the value at the tokens; null if it is not there. A metallic-roughness that is absent is created:
/// it has the same defaults.
json* value_at(json& root, std::span<const std::string_view> tokens) {
    json* value = &root;
    for (const std::string_view token : tokens) {
        if (value->is_array()) {
            const auto index = index_in(*value, token);
            if (!index) return nullptr;
            value = &(*value)[*index];
            continue;
        }
        if (!value->is_object()) return nullptr;
        const auto found = value->find(token);
        if (found == value->end() && token != "pbrMetallicRoughness") return nullptr;
        value = found == value->end() ? &((*value)[std::string(token)] = json::object()) : &*found;
    }
    return value;
}

std::size_t target_count(const Document& document, int mesh) {
    std::size_t count = 0;
    for (const auto& primitive : document.model->meshes[static_cast<std::size_t>(mesh)].primitives)
        count = std::max(count, primitive.targets.size());
    return count;
}

/// /nodes/N/weights, /meshes/M/weights, and one weight of these.
std::optional<AnimatedProperty> weights_at(Document& document, const Tokens& tokens) {
    json* owner = value_at(document.root, std::span(tokens).first(2));
    if (!owner || tokens.size() > 4) return std::nullopt;
    const bool is_node = tokens[0] == "nodes";
    const int mesh = is_node ? integer_in(*owner, "mesh", -1)
                             : static_cast<int>(*index_in(document.root["meshes"], tokens[1]));
    if (mesh < 0) return std::nullopt;
    const std::size_t count = target_count(document, mesh);
    std::vector<double> weights = numbers_in(*owner, "weights");
    if (weights.empty()) weights = numbers_in(document.entry("meshes", mesh), "weights");
    weights.resize(count, 0.0);
    (*owner)["weights"] = weights;
    if (tokens.size() == 3 && count > 0)
        return AnimatedProperty(*owner, "weights", 0, count, PropertyKind::numbers);
    json& list = (*owner)["weights"];
    const auto index = tokens.size() == 4 ? index_in(list, tokens[3]) : std::nullopt;
    if (!index) return std::nullopt;
    return AnimatedProperty(list, "", *index, 1, PropertyKind::numbers);
}

/// `is_list`: the property is an array, if only of one number, as the weights of a mesh with one target are.
json to_json(PropertyKind kind, std::span<const double> numbers, bool is_list) {
    if (kind == PropertyKind::flag) return numbers[0] != 0.0;
    return is_list ? json(std::vector<double>(numbers.begin(), numbers.end())) : json(numbers[0]);
}

} // namespace

AnimatedProperty::AnimatedProperty(json& parent, std::string key, std::size_t index, std::size_t width,
                                   Kind kind)
    : parent_(&parent), key_(std::move(key)), index_(index), width_(width), kind_(kind) {
    if (parent.is_array())
        rest_ = parent[index];
    else if (const auto found = parent.find(key_); found != parent.end())
        rest_ = *found;
}

void AnimatedProperty::set(std::span<const double> numbers) {
    require(numbers.size() == width_, "a property is set to as many numbers as it has");
    const bool is_list = width_ > 1 || (rest_ && rest_->is_array());
    (parent_->is_array() ? (*parent_)[index_] : (*parent_)[key_]) = to_json(kind_, numbers, is_list);
}

void AnimatedProperty::reset() {
    if (parent_->is_array())
        (*parent_)[index_] = *rest_;
    else if (rest_)
        (*parent_)[key_] = *rest_;
    else
        parent_->erase(key_);
}

std::optional<AnimatedProperty> property_at(Document& document, std::string_view pointer) {
    const Tokens tokens = tokens_of(pointer);
    if (tokens.size() < 3 || std::ranges::find(tokens, "extras") != tokens.end()) return std::nullopt;
    const bool is_node = tokens[0] == "nodes";
    if ((is_node || tokens[0] == "meshes") && tokens[2] == "weights") return weights_at(document, tokens);
    // The schema says how many numbers a property has.
    const Schema* schema = &gltf_schema();
    for (const std::string_view token : tokens) {
        schema = schema->items ? schema->items.get() : schema_in(*schema, token);
        if (!schema) return std::nullopt;
    }
    json* parent = value_at(document.root, std::span(tokens).first(tokens.size() - 1));
    if (!parent || !parent->is_object()) return std::nullopt;
    const std::string key(tokens.back());
    const bool is_transform = is_node && tokens.size() == 3;
    if (is_transform && (parent->contains("matrix") || key == "matrix")) return std::nullopt;
    if (schema->kind == Schema::Kind::number)
        return AnimatedProperty(*parent, key, 0, 1, PropertyKind::numbers);
    if (schema->kind == Schema::Kind::boolean && key == "visible")
        return AnimatedProperty(*parent, key, 0, 1, PropertyKind::flag);
    if (!schema->items || schema->items->kind != Schema::Kind::number || schema->length == 0)
        return std::nullopt;
    return AnimatedProperty(*parent, key, 0, schema->length,
                            is_transform && key == "rotation" ? PropertyKind::rotation
                                                              : PropertyKind::numbers);
}

} // namespace sr::gltf
