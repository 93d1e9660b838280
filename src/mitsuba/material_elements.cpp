#include "mitsuba/material_elements.hpp"

#include <fmt/format.h>
#include <variant>

namespace sr::mitsuba {
namespace {

using scene::Model;

void write_attribute(Xml& xml, std::string_view name) {
    xml.open("texture", "mesh_attribute", name);
    xml.text("name", name);
    xml.close();
}

class Elements {
public:
    Elements(Xml& xml, Textures& textures, const scene::Material& material, bool has_tangents)
        : xml_(xml), textures_(textures), m_(material), has_tangents_(has_tangents) {}

    void write_common(const scene::Mesh& mesh) {
        xml_.vector("base_color", vec3(m_.base_color));
        xml_.number("roughness", m_.roughness);
        xml_.flag("double_sided", m_.is_double_sided);
        write_slot("base_color_texture", m_.base_color_texture);
        write_slot("metallic_roughness_texture", m_.metallic_roughness_texture);
        if (!mesh.colors.empty()) write_attribute(xml_, "vertex_color");
        if (!has_tangents_) return;
        xml_.number("normal_scale", m_.normal_scale);
        write_slot("normal_texture", m_.normal_texture);
        for (const char* name : {"vertex_normal", "vertex_tangent", "vertex_handedness"})
            write_attribute(xml_, name);
    }

    void write_model() {
        if (m_.model == Model::metallic_roughness) return write_metallic_roughness();
        if (const auto plugin = scene::brdf_model(m_.model).mitsuba_plugin; !plugin.empty())
            write_inner(plugin);
        for (const scene::BrdfParameter& parameter : scene::brdf_parameters)
            if (parameter.is_of(m_.model) && !parameter.is_alternative)
                std::visit([&](auto member) { write(parameter, member); }, parameter.member);
    }

private:
    void write_slot(std::string_view name, const scene::TextureSlot& slot, Part part = Part::color) {
        if (slot.is_present()) textures_.write(xml_, name, slot.texture, slot.uv_transform, part);
    }

    /// Mitsuba's own, of reflectance 1.
    void write_inner(std::string_view plugin) {
        xml_.open("bsdf", plugin, "inner");
        if (plugin == "diffuse")
            xml_.color("reflectance", vec3(1.0f));
        else
            xml_.text("material", "none");
        xml_.close();
    }

    void write(const scene::BrdfParameter& parameter, float scene::Material::*member) {
        if (member != &scene::Material::roughness_across) return xml_.number(parameter.key, m_.*member);
        if (!has_direction()) return;
        xml_.number(parameter.key, m_.*member);
        write_direction();
    }

    void write(const scene::BrdfParameter& parameter, vec3 scene::Material::*member) {
        if (member == &scene::Material::specular_color) return write_specular_color();
        xml_.vector(parameter.key, m_.*member);
    }

    void write(const scene::BrdfParameter&, scene::ComplexIor scene::Material::*member) {
        xml_.vector("n", (m_.*member).n);
        xml_.vector("k", (m_.*member).k);
    }

    void write(const scene::BrdfParameter&, int scene::Material::*) {} // materials.cpp copies its file

    void write_specular_color() {
        xml_.vector("specular_color", m_.specular_color);
        write_slot("specular_color_texture", m_.specular_color_texture);
    }

    bool has_direction() const { return has_tangents_ && m_.is_anisotropic(); }

    void write_direction() {
        xml_.number("anisotropy_rotation", m_.anisotropy_rotation);
        write_slot("anisotropy_texture", m_.anisotropy_texture);
    }

    void write_metallic_roughness() {
        xml_.number("metallic", m_.metallic);
        xml_.number("F0", scene::F0_from_ior(m_.ior));
        xml_.number("specular", m_.specular);
        write_slot("specular_texture", m_.specular_texture, Part::alpha);
        write_specular_color();
        if (m_.is_specular_glossiness) {
            xml_.flag("specular_glossiness", true);
            write_slot("glossiness_texture", m_.specular_color_texture, Part::alpha);
        }
        for (const scene::MaterialLayer& layer : scene::material_layers)
            if (layer.is_of(m_) && (has_tangents_ || !layer.needs_tangents)) write_layer(layer);
    }

    void write_layer(const scene::MaterialLayer& layer) {
        if (layer.parameters.front().key.empty()) return;
        for (const scene::LayerParameter& parameter : layer.parameters) {
            if (const auto* number = std::get_if<float scene::Material::*>(&parameter.member))
                xml_.number(parameter.key, m_.*(*number));
            if (const auto* color = std::get_if<vec3 scene::Material::*>(&parameter.member))
                xml_.vector(parameter.key, m_.*(*color));
        }
        for (const auto texture : layer.textures)
            if (texture) write_texture_of_layer(scene::texture_inputs[scene::texture_slot(texture)]);
    }

    void write_texture_of_layer(const scene::TextureInput& input) {
        if (input.member == &scene::Material::clearcoat_normal_texture && !has_tangents_) return;
        write_slot(fmt::format("{}_texture", input.name), m_.*input.member,
                   input.is_in_alpha() ? Part::alpha : Part::color);
    }

    Xml& xml_;
    Textures& textures_;
    const scene::Material& m_;
    bool has_tangents_;
};

} // namespace

std::string plugin_for(Model model) {
    const scene::BrdfModel& brdf = scene::brdf_model(model);
    return fmt::format("steradian_{}", brdf.mitsuba_plugin.empty() ? brdf.name : "framed");
}

void write_parameters(Xml& xml, Textures& textures, const scene::Material& material, const scene::Mesh& mesh,
                      bool has_tangents) {
    Elements elements(xml, textures, material, has_tangents);
    elements.write_common(mesh);
    elements.write_model();
}

} // namespace sr::mitsuba
