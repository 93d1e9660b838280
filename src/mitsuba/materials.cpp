#include "mitsuba/materials.hpp"

#include "scene/material_description.hpp"

#include <fmt/format.h>

namespace sr::mitsuba {
namespace {

/// ((ior - 1) / (ior + 1))²; 0 stands for an infinite ior (KHR_materials_ior).
float F0_from_ior(float ior) {
    if (ior == 0.0f) return 1.0f;
    const float r = (ior - 1.0f) / (ior + 1.0f);
    return r * r;
}

void write_attribute(Xml& xml, std::string_view name) {
    xml.open("texture", "mesh_attribute", name);
    xml.text("name", name);
    xml.close();
}

} // namespace

int texcoord_of(const scene::Material& material) {
    for (const scene::TextureSlot* slot : scene::texture_slots(material))
        if (slot->is_present()) return slot->texcoord;
    return 0;
}

bool reads_normal_map(const scene::Material& material, const scene::Mesh& mesh) {
    return material.normal_texture.is_present() && !mesh.tangents.empty();
}

std::string Materials::id_of(Xml& xml, const scene::Mesh& mesh) {
    const scene::Material& material = scene_.materials[static_cast<std::size_t>(mesh.material)];
    if (material.is_unlit) {
        warnings_.push_back(fmt::format("material '{}' is unlit: exported as black", material.name));
        return black(xml);
    }
    const std::tuple key{mesh.material, !mesh.colors.empty(), reads_normal_map(material, mesh)};
    const auto [entry, is_new] = ids_.try_emplace(key, fmt::format("material-{}", ids_.size()));
    if (is_new) {
        warn(material);
        xml.open("bsdf", "steradian_metallic_roughness", "", entry->second);
        write(xml, material, mesh);
        xml.close();
    }
    return entry->second;
}

std::string Materials::black(Xml& xml) {
    if (!has_black_) {
        xml.open("bsdf", "diffuse", "", "black");
        xml.color("reflectance", vec3(0.0f));
        xml.close();
        has_black_ = true;
    }
    return "black";
}

void Materials::warn(const scene::Material& material) {
    const auto add = [&](std::string_view what) {
        warnings_.push_back(fmt::format("material '{}' {}", material.name, what));
    };
    const std::string brdf = scene::described(material);
    if (brdf != "metallic_roughness")
        add(fmt::format("has the BRDF {}: exported as plain metallic-roughness", brdf));
    if (material.alpha_mode == scene::AlphaMode::mask) add("has an alpha mask: exported as opaque");
    if (material.alpha_mode == scene::AlphaMode::blend) add("is blended: exported as opaque");
    for (const scene::TextureSlot* slot : scene::texture_slots(material))
        if (slot->is_present() && slot->texcoord != texcoord_of(material))
            return add("reads two sets of texture coordinates: exported with the first for all its textures");
}

void Materials::write(Xml& xml, const scene::Material& material, const scene::Mesh& mesh) {
    xml.vector("base_color", vec3(material.base_color));
    xml.number("metallic", material.metallic);
    xml.number("roughness", material.roughness);
    xml.number("F0", F0_from_ior(material.ior));
    xml.number("specular", material.specular);
    xml.vector("specular_color", material.specular_color);
    xml.number("normal_scale", material.normal_scale);
    xml.flag("double_sided", material.is_double_sided);
    write_textures(xml, material, mesh);
}

void Materials::write_textures(Xml& xml, const scene::Material& material, const scene::Mesh& mesh) {
    const auto write_slot = [&](std::string_view name, const scene::TextureSlot& slot,
                                Part part = Part::color) {
        if (slot.is_present()) textures_.write(xml, name, slot.texture, slot.uv_transform, part);
    };
    write_slot("base_color_texture", material.base_color_texture);
    write_slot("metallic_roughness_texture", material.metallic_roughness_texture);
    write_slot("specular_texture", material.specular_texture, Part::alpha);
    write_slot("specular_color_texture", material.specular_color_texture);
    if (!mesh.colors.empty()) write_attribute(xml, "vertex_color");
    if (!reads_normal_map(material, mesh)) return;
    write_slot("normal_texture", material.normal_texture);
    for (const char* name : {"vertex_normal", "vertex_tangent", "vertex_handedness"})
        write_attribute(xml, name);
}

} // namespace sr::mitsuba
