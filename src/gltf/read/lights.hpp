#pragma once
// The lights of a glTF: KHR_lights_punctual, EXT_lights_area, EXT_lights_ies, and the shapes of
// extras.steradian.
#include "gltf/read/emission.hpp"
#include "gltf/read/nodes.hpp"
#include "gltf/read/texture.hpp"
#include "gltf/warnings.hpp"
#include "scene/ies.hpp"
#include "scene/lights/light.hpp"

#include <map>
#include <vector>

namespace sr::gltf {

/// Collects the lights of transform nodes, in world space. They keep their photometric numbers whatever the
/// node's scale is; only sizes scale.
class LightTable {
public:
    /// Takes the textures of emitters from `textures`.
    LightTable(const Document& document, TextureTable& textures) : document_(document), textures_(textures) {}

    /// Appends the lights that a node carries, whether or not it is visible. A lamp that glTF states wrongly
    /// or whose node is scaled to nothing is off, with a warning.
    /// @throws Error naming what extras.steradian states of a light and makes no sense
    void append(const NodeTransform& transform, Warnings& warnings);

    const std::vector<scene::Light>& lights() const { return lights_; }
    /// Forgets the lights, and keeps their profiles: what comes next is another moment of the same file.
    void clear() { lights_.clear(); }
    const std::vector<scene::LightProfile>& profiles() const { return profiles_; }

private:
    void append_punctual(const NodeTransform& transform, Warnings& warnings);
    void append_area(const NodeTransform& transform, Warnings& warnings);
    void append_shape(const NodeTransform& transform, Warnings& warnings);
    void append_ies(const NodeTransform& transform, Warnings& warnings);

    /// The emission map of extras.steradian.texture; none where there is no texture. A node that mirrors
    /// mirrors the picture, too.
    scene::EmissionMap map_of(const json* authored, const NodeTransform& transform);
    /// An IES file of the glTF, read once; with the index of its profile.
    const std::pair<int, scene::IesLuminaire>& luminaire(int index, const std::string& title);

    const Document& document_;
    TextureTable& textures_;
    std::vector<scene::Light> lights_;
    std::vector<scene::LightProfile> profiles_;
    std::map<int, std::pair<int, scene::IesLuminaire>> luminaires_;
};

} // namespace sr::gltf
