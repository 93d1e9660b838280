#include "gltf/extensions.hpp"

#include "core/error.hpp"
#include "gltf/read/compression.hpp"
#include "gltf/warnings.hpp"
#include "image/texture_formats.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

constexpr std::string_view meshopt_notes = "where `libmeshoptimizer-dev` was found at build time. Version 1 "
                                           "of the attribute codec and the filter COLOR are "
                                           "errors, unless the file has a fallback buffer";
constexpr std::string_view beside = "not read: the PNG or JPEG beside it, else the texture is lost";
constexpr std::string_view no_transcoder = "not read, since Debian 12 packages no transcoder: the PNG or "
                                           "JPEG beside it, else the texture is lost and the "
                                           "warning names a command that converts the file";

// The objects of extensions in materials.
using namespace schemas;

Schema numbers(std::size_t length) { return array(number(), length); }

Schema specular_glossiness() {
    const Schema texture = texture_info_schema();
    return object({{"diffuseFactor", numbers(4)},
                   {"diffuseTexture", texture},
                   {"specularFactor", numbers(3)},
                   {"glossinessFactor", number()},
                   {"specularGlossinessTexture", texture}});
}

Schema anisotropy() {
    const Schema texture = texture_info_schema();
    return object(
        {{"anisotropyStrength", number()}, {"anisotropyRotation", number()}, {"anisotropyTexture", texture}});
}

Schema clearcoat() {
    const Schema texture = texture_info_schema();
    return object({{"clearcoatFactor", number()},
                   {"clearcoatTexture", texture},
                   {"clearcoatRoughnessFactor", number()},
                   {"clearcoatRoughnessTexture", texture},
                   {"clearcoatNormalTexture", texture}});
}

Schema sheen() {
    const Schema texture = texture_info_schema();
    return object({{"sheenColorFactor", numbers(3)},
                   {"sheenColorTexture", texture},
                   {"sheenRoughnessFactor", number()},
                   {"sheenRoughnessTexture", texture}});
}

Schema iridescence() {
    const Schema texture = texture_info_schema();
    return object({{"iridescenceFactor", number()},
                   {"iridescenceTexture", texture},
                   {"iridescenceIor", number()},
                   {"iridescenceThicknessMinimum", number()},
                   {"iridescenceThicknessMaximum", number()},
                   {"iridescenceThicknessTexture", texture}});
}

Schema emissive_strength() { return object({{"emissiveStrength", number()}}); }

Schema ior() { return object({{"ior", number()}}); }

Schema specular() {
    const Schema texture = texture_info_schema();
    return object({{"specularFactor", number()},
                   {"specularTexture", texture},
                   {"specularColorFactor", numbers(3)},
                   {"specularColorTexture", texture}});
}

Schema transmission() {
    const Schema texture = texture_info_schema();
    return object({{"transmissionFactor", number()}, {"transmissionTexture", texture}});
}

Schema volume() {
    const Schema texture = texture_info_schema();
    return object({{"thicknessFactor", number()},
                   {"thicknessTexture", texture},
                   {"attenuationDistance", number()},
                   {"attenuationColor", numbers(3)}});
}

Schema diffuse_transmission() {
    const Schema texture = texture_info_schema();
    return object({{"diffuseTransmissionFactor", number()},
                   {"diffuseTransmissionTexture", texture},
                   {"diffuseTransmissionColorFactor", numbers(3)},
                   {"diffuseTransmissionColorTexture", texture}});
}

Schema unlit() { return object(); }

using enum Support;

const std::array table{
    Extension{"EXT_lights_area", full, "the draft"},
    Extension{"EXT_lights_ies"},
    Extension{"EXT_mesh_gpu_instancing", full, "not of skinned meshes"},
    Extension{"EXT_meshopt_compression", full, meshopt_notes, reads_meshopt},
    Extension{"EXT_texture_webp", full,
              "where `libwebp-dev` was found at build time; else the PNG or JPEG beside it",
              image::decodes_webp, texture_format},
    Extension{"KHR_animation_pointer", full,
              "nodes, weights, visibility; factors of materials and of these extensions, texture transforms; "
              "lights; "
              "cameras. Others: a warning"},
    Extension{"KHR_draco_mesh_compression", full, "where `libdraco-dev` was found at build time",
              reads_draco},
    Extension{"KHR_lights_punctual"},
    Extension{.name = "KHR_materials_anisotropy", .of_material = anisotropy},
    Extension{.name = "KHR_materials_clearcoat", .of_material = clearcoat},
    Extension{.name = "KHR_materials_diffuse_transmission",
              .notes = "Lambert's lobe on the other side; nothing is scattered within a volume",
              .of_material = diffuse_transmission},
    Extension{.name = "KHR_materials_emissive_strength", .of_material = emissive_strength},
    Extension{.name = "KHR_materials_ior", .of_material = ior},
    Extension{.name = "KHR_materials_iridescence", .of_material = iridescence},
    Extension{.name = "KHR_materials_pbrSpecularGlossiness",
              .notes =
                  "preferred to metallic-roughness: F0 = specular, ρ = diffuse (1 − max F0), roughness = 1 − "
                  "glossiness; "
                  "under glTF's own Fresnel and GGX",
              .of_material = specular_glossiness},
    Extension{.name = "KHR_materials_sheen", .of_material = sheen},
    Extension{.name = "KHR_materials_specular", .of_material = specular},
    Extension{.name = "KHR_materials_transmission",
              .notes = "light goes straight through, tinted: not refracted, not blurred",
              .of_material = transmission},
    Extension{.name = "KHR_materials_unlit", .of_material = unlit},
    Extension{"KHR_materials_variants", full, "`--variant NAME`; without it each primitive's own material"},
    Extension{
        .name = "KHR_materials_volume", .notes = "light is attenuated, not refracted", .of_material = volume},
    Extension{"KHR_mesh_quantization"},
    Extension{"KHR_meshopt_compression", full, meshopt_notes, reads_meshopt},
    Extension{"KHR_node_visibility", full, "meshes and lights below, not cameras and joints"},
    Extension{"KHR_texture_transform"},

    Extension{"EXT_texture_avif", texture_format, beside},
    Extension{"GOOGLE_texture_basis", texture_format, no_transcoder},
    Extension{"KHR_texture_basisu", texture_format, no_transcoder},
    Extension{"MSFT_texture_dds", texture_format, beside},

    // Metadata, sound, physics, interaction; how polygons were triangulated; coarser meshes and other
    // packings of what is there anyway.
    Extension{"AGI_articulations", no_effect},
    Extension{"AGI_stk_metadata", no_effect},
    Extension{"EXT_feature_metadata", no_effect},
    Extension{"EXT_instance_features", no_effect},
    Extension{"EXT_mesh_features", no_effect},
    Extension{"EXT_mesh_manifold", no_effect},
    Extension{"EXT_structural_metadata", no_effect},
    Extension{"FB_ngon_encoding", no_effect},
    Extension{"GODOT_single_root", no_effect},
    Extension{"KHR_audio", no_effect},
    Extension{"KHR_audio_emitter", no_effect},
    Extension{"KHR_implicit_shapes", no_effect},
    Extension{"KHR_interactivity", no_effect},
    Extension{"KHR_node_hoverability", no_effect},
    Extension{"KHR_node_selectability", no_effect},
    Extension{"KHR_physics_rigid_bodies", no_effect},
    Extension{"KHR_xmp", no_effect},
    Extension{"KHR_xmp_json_ld", no_effect},
    Extension{"MSFT_audio_emitter", no_effect},
    Extension{"MSFT_lod", no_effect},
    Extension{"MSFT_packing_normalRoughnessMetallic", no_effect},
    Extension{"MSFT_packing_occlusionRoughnessMetallic", no_effect},
    Extension{"OMI_collider", no_effect},
    Extension{"OMI_physics_body", no_effect},
    Extension{"OMI_physics_joint", no_effect},
    Extension{"OMI_physics_shape", no_effect},
    Extension{"VRMC_node_constraint", no_effect},
    Extension{"VRMC_springBone", no_effect},
};

Support support_of(std::string_view extension) {
    const auto found = std::ranges::find(table, extension, &Extension::name);
    if (found == table.end()) return none;
    return found->is_built && !found->is_built() ? found->unbuilt : found->support;
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

std::span<const Extension> known_extensions() { return table; }

bool is_supported(std::string_view extension) { return support_of(extension) == full; }

void check_required_extensions(const nlohmann::json& root, const std::string& name) {
    const auto required = root.find("extensionsRequired");
    if (required == root.end() || !required->is_array()) return;
    std::vector<std::string> missing;
    for (const auto& extension : *required)
        if (extension.is_string()) {
            const auto& text = extension.get_ref<const std::string&>();
            if (support_of(text) == none) missing.push_back(in_quotes(text));
        }
    if (missing.empty()) return;
    throw Error({name}, fmt::format("it requires what is not supported yet, {}", fmt::join(missing, ", ")),
                remedy_for(missing));
}

void warn_of_unsupported(const std::vector<std::string>& extensions_used, Warnings& warnings) {
    std::vector<std::string> missing;
    for (const std::string& extension : extensions_used)
        if (support_of(extension) == none) missing.push_back(in_quotes(extension));
    if (missing.empty()) return;
    warnings.add(fmt::format("it uses what is not supported yet, {}", fmt::join(missing, ", ")),
                 "shown without, which may look different");
}

} // namespace sr::gltf
