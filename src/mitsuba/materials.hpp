#pragma once
// Materials as the plugin steradian_metallic_roughness takes them.
#include "mitsuba/textures.hpp"

#include <map>
#include <string>
#include <tuple>

namespace sr::mitsuba {

/// The texture coordinate set that a material's textures read; where they differ, that of the first.
int texcoord_of(const scene::Material& material);

/// Whether shading reads the normal map: the mesh needs tangents for it.
bool reads_normal_map(const scene::Material& material, const scene::Mesh& mesh);

class Materials {
public:
    Materials(const scene::Scene& scene, Textures& textures) : scene_(scene), textures_(textures) {}

    /// The id of the <bsdf> of a mesh, which is written at the first call. @throws Error from Textures
    std::string id_of(Xml& xml, const scene::Mesh& mesh);

    /// The id of a <bsdf> that reflects nothing.
    std::string black(Xml& xml);

    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    void write(Xml& xml, const scene::Material& material, const scene::Mesh& mesh);
    void write_textures(Xml& xml, const scene::Material& material, const scene::Mesh& mesh);
    void warn(const scene::Material& material);

    const scene::Scene& scene_;
    Textures& textures_;
    std::map<std::tuple<int, bool, bool>, std::string> ids_; // material, has colours, reads a normal map
    bool has_black_ = false;
    std::vector<std::string> warnings_;
};

} // namespace sr::mitsuba
