#include "mitsuba/materials.hpp"

#include "mitsuba/material_elements.hpp"
#include "mitsuba/new_folder.hpp"
#include "scene/measured_brdf.hpp"

#include <fmt/format.h>

namespace sr::mitsuba {

int texcoord_of(const scene::Material& material) {
    for (const scene::TextureInput& input : scene::texture_inputs)
        if ((material.*input.member).is_present()) return (material.*input.member).texcoord;
    return 0;
}

bool reads_tangents(const scene::Material& material, const scene::Mesh& mesh) {
    return scene::needs_tangents(material) && !mesh.tangents.empty();
}

std::string Materials::id_of(Xml& xml, const scene::Mesh& mesh) {
    const scene::Material& material = scene_.materials[static_cast<std::size_t>(mesh.material)];
    if (material.is_unlit) {
        warnings_.push_back(fmt::format("material '{}' is unlit: exported as black", material.name));
        return black(xml);
    }
    const std::tuple key{mesh.material, !mesh.colors.empty(), reads_tangents(material, mesh)};
    const auto [entry, is_new] = ids_.try_emplace(key, fmt::format("material-{}", ids_.size()));
    if (is_new) {
        warn(material);
        xml.open("bsdf", plugin_for(material.model), "", entry->second);
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
    if (material.alpha_mode == scene::AlphaMode::mask) add("has an alpha mask: exported as opaque");
    if (material.alpha_mode == scene::AlphaMode::blend) add("is blended: exported as opaque");
    if (material.is_transmissive()) add("is of glass: exported as opaque, with all of its diffuse base");
    if (material.transmits_diffusely()) add("transmits diffusely: exported without that");
    if (material.is_emissive() && material.clearcoat > 0.0f)
        add("emits under a coat: exported with what it emits, uncoated");
    for (const scene::TextureInput& input : scene::texture_inputs)
        if (const scene::TextureSlot& slot = material.*input.member;
            slot.is_present() && slot.texcoord != texcoord_of(material))
            return add("reads two sets of texture coordinates: exported with the first for all its textures");
}

void Materials::write(Xml& xml, const scene::Material& material, const scene::Mesh& mesh) {
    write_parameters(xml, textures_, material, mesh, reads_tangents(material, mesh));
    if (material.measured < 0) return;
    xml.text("filename", measured_file(material.measured));
    xml.number("alpha", scene_.measured[static_cast<std::size_t>(material.measured)].alpha);
}

std::string Materials::measured_file(int index) {
    const auto [entry, is_new] = measured_.try_emplace(index, fmt::format("measured/{}.binary", index));
    if (is_new) {
        const std::vector<std::byte> file =
            scene::merl_file(scene_.measured[static_cast<std::size_t>(index)].values);
        make_folder(folder_ / "measured");
        write_text(folder_ / entry->second, {reinterpret_cast<const char*>(file.data()), file.size()});
    }
    return entry->second;
}

} // namespace sr::mitsuba
