#pragma once
// The images that the materials read, and their samplers.
#include "gltf/document.hpp"
#include "gltf/warnings.hpp"
#include "scene/material.hpp"

#include <map>
#include <vector>

namespace sr::gltf {

/// Collects textures as materials ask for them. Equal (image, sampler, colour space) share an entry, and only
/// images that a material reads are listed.
class TextureTable {
public:
    TextureTable(const Document& document, Warnings& warnings);

    /// The number (in textures()) of an entry of the JSON's `textures`; negative where it has no image.
    int texture(int gltf_texture, scene::ColorSpace color_space);

    /// In the order of their numbers; Texture::image counts in image_sources().
    const std::vector<scene::Texture>& textures() const { return textures_; }
    /// Indices into Document::images.
    const std::vector<int>& image_sources() const { return sources_; }

private:
    const Document& document_;
    Warnings& warnings_;
    std::vector<scene::Texture> textures_;
    std::vector<int> sources_;
    std::map<int, int> image_of_source_; // Document::images → image_sources()
};

} // namespace sr::gltf
