#include "gltf/extensions.hpp"

#include "core/error.hpp"
#include "gltf/compression.hpp"
#include "gltf/text.hpp"
#include "image/webp.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

constexpr std::array<std::string_view, 18> supported{"EXT_lights_area",
                                                     "EXT_lights_ies",
                                                     "EXT_mesh_gpu_instancing",
                                                     "KHR_animation_pointer",
                                                     "KHR_lights_punctual",
                                                     "KHR_materials_anisotropy",
                                                     "KHR_materials_clearcoat",
                                                     "KHR_materials_emissive_strength",
                                                     "KHR_materials_ior",
                                                     "KHR_materials_iridescence",
                                                     "KHR_materials_sheen",
                                                     "KHR_materials_specular",
                                                     "KHR_materials_pbrSpecularGlossiness",
                                                     "KHR_materials_unlit",
                                                     "KHR_materials_variants",
                                                     "KHR_mesh_quantization",
                                                     "KHR_node_visibility",
                                                     "KHR_texture_transform"};

std::string_view remedy_for(const std::vector<std::string>& missing) {
    const auto any_ends_with = [&](std::string_view end) {
        return std::ranges::any_of(missing, [&](const std::string& name) { return name.ends_with(end); });
    };
    if (any_ends_with("_compression\""))
        return "build Steradian with libmeshoptimizer-dev and libdraco-dev, or export it without";
    return any_ends_with("_basisu\"") ? convert_ktx : "export it without";
}

} // namespace

bool is_supported(std::string_view extension) {
    if (extension == "EXT_meshopt_compression" || extension == "KHR_meshopt_compression")
        return reads_meshopt();
    if (extension == "KHR_draco_mesh_compression") return reads_draco();
    if (extension == "EXT_texture_webp") return image::decodes_webp();
    return std::find(supported.begin(), supported.end(), extension) != supported.end();
}

void check_required_extensions(const nlohmann::json& root, const std::string& name) {
    const auto required = root.find("extensionsRequired");
    if (required == root.end() || !required->is_array()) return;
    std::vector<std::string> missing;
    for (const auto& extension : *required)
        if (extension.is_string() && !is_supported(extension.get_ref<const std::string&>()))
            missing.push_back(in_quotes(extension.get_ref<const std::string&>()));
    if (missing.empty()) return;
    throw Error({name}, fmt::format("it requires what is not supported yet, {}", fmt::join(missing, ", ")),
                remedy_for(missing));
}

void warn_of_unsupported(const std::vector<std::string>& extensions_used, Warnings& warnings) {
    std::vector<std::string> missing;
    for (const std::string& extension : extensions_used)
        if (!is_supported(extension)) missing.push_back(in_quotes(extension));
    if (missing.empty()) return;
    warnings.add(fmt::format("it uses what is not supported yet, {}", fmt::join(missing, ", ")),
                 "shown without, which may look different");
}

} // namespace sr::gltf
