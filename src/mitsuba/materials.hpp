#pragma once
// Materials as Mitsuba's plugins and ours (plugin/) take them.
#include "mitsuba/textures.hpp"

#include <map>
#include <string>
#include <tuple>

namespace sr::mitsuba {

/// The texture coordinate set that a material's textures read; where they differ, that of the first.
int texcoord_of(const scene::Material& material);

/// Returns whether shading reads the tangents of the mesh: for a normal map or a lobe with a direction, if
/// there are any.
bool reads_tangents(const scene::Material& material, const scene::Mesh& mesh);

class Materials {
public:
    /// Measured BRDFs go to folder/measured/.
    Materials(const scene::Scene& scene, Textures& textures, std::filesystem::path folder)
        : scene_(scene), textures_(textures), folder_(std::move(folder)) {}

    /// The id of the <bsdf> of a mesh, which is written at the first call. @throws Error if a file cannot be
    /// written
    std::string id_of(Xml& xml, const scene::Mesh& mesh);

    /// The id of a <bsdf> that reflects nothing.
    std::string black(Xml& xml);

    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    void write(Xml& xml, const scene::Material& material, const scene::Mesh& mesh);
    void warn(const scene::Material& material);
    std::string measured_file(int index);

    const scene::Scene& scene_;
    Textures& textures_;
    std::filesystem::path folder_;
    std::map<std::tuple<int, bool, bool>, std::string> ids_; // material, has colours, reads tangents
    std::map<int, std::string> measured_;                    // by the index into Scene::measured
    bool has_black_ = false;
    std::vector<std::string> warnings_;
};

} // namespace sr::mitsuba
