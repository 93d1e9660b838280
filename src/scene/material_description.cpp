#include "scene/material_description.hpp"

namespace sr::scene {

std::string described(const Material& m) {
    if (m.is_unlit) return "unlit";
    std::string text(m.is_specular_glossiness ? "specular_glossiness" : name_of(m.model));
    const auto add = [&text](bool is_there, const char* layer) {
        if (is_there) text += std::string(", ") + layer;
    };
    add(m.is_anisotropic(), "anisotropic");
    if (m.model != Model::metallic_roughness) return text;
    add(m.iridescence > 0.0f, "thin film");
    add(m.has_sheen(), "sheen");
    add(m.clearcoat > 0.0f, "clearcoat");
    return text;
}

} // namespace sr::scene
