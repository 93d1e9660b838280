#pragma once
// glTF materials.
#include "gltf/read/emission.hpp"
#include "gltf/read/material_brdf.hpp"
#include "gltf/read/texture.hpp"
#include "scene/scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace sr::gltf {

/// Collects the materials that primitives ask for, in that order, and the textures that those read.
class MaterialTable {
public:
    MaterialTable(const Document& document, MeasuredTable& measured, Warnings& warnings);

    /// The number (in materials()) of an entry of the JSON's `materials`; of glTF's default material for -1.
    /// @throws Error if a factor makes no sense
    int material(int gltf_material);

    const std::vector<scene::Material>& materials() const { return materials_; }
    /// The number in the file of each of them; negative for glTF's default material.
    std::vector<int> numbers() const;
    /// Lights ask for textures, too.
    TextureTable& textures() { return textures_; }

    /// Gives each material that states a flux its radiance: L = Φ / (π A), A being the area of all surfaces
    /// of the scene that have the material, on both sides if they emit on both. To be called when all
    /// instances are there.
    void share_fluxes(scene::Scene& scene) const;

private:
    struct StatedFlux {
        glm::dvec3 Phi{0.0}; // in the scene's units
        std::string title;
    };

    const Document& document_;
    MeasuredTable& measured_;
    Warnings& warnings_;
    TextureTable textures_;
    std::vector<scene::Material> materials_;
    std::map<int, int> number_of_;
    std::map<int, StatedFlux> fluxes_; // by number
};

} // namespace sr::gltf
