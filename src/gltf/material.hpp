#pragma once
// glTF materials.
#include "gltf/texture.hpp"

#include <map>

namespace sr::gltf {

/// Collects the materials that primitives ask for, in that order, and the textures that those read.
class MaterialTable {
public:
    MaterialTable(const Document& document, Warnings& warnings);

    /// The number (in materials()) of an entry of the JSON's `materials`; of glTF's default material for -1.
    /// @throws Error if a factor makes no sense
    int material(int gltf_material);

    const std::vector<scene::Material>& materials() const { return materials_; }
    const TextureTable& textures() const { return textures_; }

private:
    scene::Material read(const tinygltf::Material& from);
    void read_specular(const tinygltf::Material& from, scene::Material& to);
    scene::TextureSlot slot(const tinygltf::Value& info, scene::ColorSpace color_space);
    scene::TextureSlot slot(int texture, int texcoord, const tinygltf::ExtensionMap& extensions,
                            scene::ColorSpace color_space);
    float fraction(double value, const char* factor, const std::string& material);

    const Document& document_;
    Warnings& warnings_;
    TextureTable textures_;
    std::vector<scene::Material> materials_;
    std::map<int, int> number_of_;
};

} // namespace sr::gltf
