#include "gltf/variants.hpp"

#include "gltf/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {

using tinygltf::Value;

std::vector<std::string> variants_of(const Document& document) {
    std::vector<std::string> names;
    if (const Value* extension = gltf::extension(document.model.extensions, "KHR_materials_variants"))
        for (const Value& variant : extension->Get("variants").Get<Value::Array>())
            names.push_back(variant.Get("name").Get<std::string>());
    return names;
}

std::optional<int> variant_named(const Document& document, std::string_view name) {
    if (name.empty()) return std::nullopt;
    std::vector<std::string> names = variants_of(document);
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    for (std::string& known : names) known = in_quotes(known);
    document.fail(fmt::format("there is no material variant {}", in_quotes(name)),
                  names.empty() ? std::string("name none: the file has none")
                                : fmt::format("choose one of {}", fmt::join(names, ", ")));
}

int material_of(const tinygltf::Primitive& primitive, std::optional<int> variant) {
    const Value* extension = gltf::extension(primitive.extensions, "KHR_materials_variants");
    if (!variant || !extension) return primitive.material;
    for (const Value& mapping : extension->Get("mappings").Get<Value::Array>())
        for (const Value& chosen : mapping.Get("variants").Get<Value::Array>())
            if (chosen.GetNumberAsInt() == *variant) return mapping.Get("material").GetNumberAsInt();
    return primitive.material;
}

} // namespace sr::gltf
