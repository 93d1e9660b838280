#pragma once
// KHR_materials_variants: other materials for the same primitives, chosen by name.
#include "gltf/document.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

std::vector<std::string> variants_of(const Document& document);

/// The number of the variant with this name; absent for an empty name. @throws Error naming those there are
std::optional<int> variant_named(const Document& document, std::string_view name);

/// The material of a primitive in a variant, or without one: an index into the file's materials, negative for
/// glTF's default material.
int material_of(const tinygltf::Primitive& primitive, std::optional<int> variant);

} // namespace sr::gltf
