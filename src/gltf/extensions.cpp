#include "gltf/extensions.hpp"

#include "core/error.hpp"
#include "gltf/read/compression.hpp"
#include "gltf/warnings.hpp"
#include "image/webp.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

constexpr std::array<std::string_view, 21> supported{"EXT_lights_area",
                                                     "EXT_lights_ies",
                                                     "EXT_mesh_gpu_instancing",
                                                     "KHR_animation_pointer",
                                                     "KHR_lights_punctual",
                                                     "KHR_materials_anisotropy",
                                                     "KHR_materials_clearcoat",
                                                     "KHR_materials_diffuse_transmission",
                                                     "KHR_materials_emissive_strength",
                                                     "KHR_materials_ior",
                                                     "KHR_materials_iridescence",
                                                     "KHR_materials_sheen",
                                                     "KHR_materials_specular",
                                                     "KHR_materials_pbrSpecularGlossiness",
                                                     "KHR_materials_transmission",
                                                     "KHR_materials_unlit",
                                                     "KHR_materials_variants",
                                                     "KHR_materials_volume",
                                                     "KHR_mesh_quantization",
                                                     "KHR_node_visibility",
                                                     "KHR_texture_transform"};

// Extensions that change no picture: metadata, sound, physics, interaction; how polygons were
// triangulated; coarser meshes and other packings of what is there anyway.
constexpr std::array<std::string_view, 28> without_effect{"AGI_articulations",
                                                          "AGI_stk_metadata",
                                                          "EXT_feature_metadata",
                                                          "EXT_instance_features",
                                                          "EXT_mesh_features",
                                                          "EXT_mesh_manifold",
                                                          "EXT_structural_metadata",
                                                          "FB_ngon_encoding",
                                                          "GODOT_single_root",
                                                          "KHR_audio",
                                                          "KHR_audio_emitter",
                                                          "KHR_implicit_shapes",
                                                          "KHR_interactivity",
                                                          "KHR_node_hoverability",
                                                          "KHR_node_selectability",
                                                          "KHR_physics_rigid_bodies",
                                                          "KHR_xmp",
                                                          "KHR_xmp_json_ld",
                                                          "MSFT_audio_emitter",
                                                          "MSFT_lod",
                                                          "MSFT_packing_normalRoughnessMetallic",
                                                          "MSFT_packing_occlusionRoughnessMetallic",
                                                          "OMI_collider",
                                                          "OMI_physics_body",
                                                          "OMI_physics_joint",
                                                          "OMI_physics_shape",
                                                          "VRMC_node_constraint",
                                                          "VRMC_springBone"};

// Formats of textures: what is lost without them is told texture by texture.
constexpr std::array<std::string_view, 5> texture_formats{
    "EXT_texture_avif", "EXT_texture_webp", "GOOGLE_texture_basis", "KHR_texture_basisu", "MSFT_texture_dds"};

/// Returns whether a file looks the same without the extension, except for textures that report it
/// themselves.
bool is_dispensable(std::string_view extension) {
    return std::ranges::find(without_effect, extension) != without_effect.end()
           || std::ranges::find(texture_formats, extension) != texture_formats.end();
}

std::string_view remedy_for(const std::vector<std::string>& missing) {
    const auto any_ends_with = [&](std::string_view end) {
        return std::ranges::any_of(missing, [&](const std::string& name) { return name.ends_with(end); });
    };
    if (any_ends_with("_compression\""))
        return "build Steradian with libmeshoptimizer-dev and libdraco-dev, or export it without";
    return "export it without";
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
        if (extension.is_string()) {
            const auto& text = extension.get_ref<const std::string&>();
            if (!is_supported(text) && !is_dispensable(text)) missing.push_back(in_quotes(text));
        }
    if (missing.empty()) return;
    throw Error({name}, fmt::format("it requires what is not supported yet, {}", fmt::join(missing, ", ")),
                remedy_for(missing));
}

void warn_of_unsupported(const std::vector<std::string>& extensions_used, Warnings& warnings) {
    std::vector<std::string> missing;
    for (const std::string& extension : extensions_used)
        if (!is_supported(extension) && !is_dispensable(extension)) missing.push_back(in_quotes(extension));
    if (missing.empty()) return;
    warnings.add(fmt::format("it uses what is not supported yet, {}", fmt::join(missing, ", ")),
                 "shown without, which may look different");
}

} // namespace sr::gltf
