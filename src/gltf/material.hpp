#pragma once
// glTF materials.
#include "gltf/measured.hpp"
#include "gltf/read/emission.hpp"
#include "gltf/read/texture.hpp"
#include "scene/scene.hpp"

#include <array>
#include <map>
#include <optional>

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
    void read_emission(const tinygltf::Material& from, scene::Material& to);
    scene::Material read(const tinygltf::Material& from, int number);
    void read_metallic_roughness(const tinygltf::Material& from, scene::Material& to);
    void read_specular_glossiness(const tinygltf::Material& from, const tinygltf::Value& stated,
                                  scene::Material& to);
    void read_specular(const tinygltf::Material& from, scene::Material& to);
    void read_anisotropy(const tinygltf::Material& from, scene::Material& to);
    void read_clearcoat(const tinygltf::Material& from, scene::Material& to);
    void read_sheen(const tinygltf::Material& from, scene::Material& to);
    void read_iridescence(const tinygltf::Material& from, scene::Material& to);
    void read_transmission(const tinygltf::Material& from, scene::Material& to);
    void read_volume(const tinygltf::Material& from, scene::Material& to);
    void read_diffuse_transmission(const tinygltf::Material& from, scene::Material& to);
    vec3 color(const tinygltf::Value& object, const char* factor, const std::string& material);
    void read_brdf(const tinygltf::Material& from, scene::Material& to);
    using TextureMember = scene::TextureSlot scene::Material::*;
    /// Reads the textureInfo `key` of an extension, if it is there.
    void read_texture(const tinygltf::Value& from, const char* key, TextureMember texture,
                      scene::Material& to);
    /// @return the texture `index`, for a material's `texture`
    scene::TextureSlot slot(int index, int texcoord, const tinygltf::ExtensionMap& extensions,
                            TextureMember texture);
    /// Returns the set of a mesh, 0 or 1, that is TEXCOORD_n for the material at hand. It takes a free set if
    /// none is yet; absent if both are taken.
    std::optional<int> texcoord_set(int n);
    /// The value, or with a warning the nearest of [least, most].
    float clamped(double value, double least, double most, const char* factor, const std::string& material);
    float fraction(double value, const char* factor, const std::string& material); // 0 to 1

    const Document& document_;
    MeasuredTable& measured_;
    Warnings& warnings_;
    TextureTable textures_;
    std::vector<scene::Material> materials_;
    std::map<int, int> number_of_;
    std::map<int, StatedFlux> fluxes_;       // by number
    std::array<std::optional<int>, 2> sets_; // of texture coordinates that the material at hand reads
};

/// Three numbers of an extension's object, which the rules (rules.cpp) have counted.
vec3 three_in(const tinygltf::Value& object, const std::string& key, vec3 fallback);

/// The same angle [rad] within half a turn of 0, so that a float keeps its digits.
double within_a_turn(double angle);

/// The steepest that a normal map is made by its scale: beyond, only the direction of its slope is left.
inline constexpr double steepest_map = 1e6;

/// @throws Error unless all components are 0 to `most`; `remedy` says what is allowed
vec3 within(const Document& document, vec3 value, float most, const char* factor, const std::string& material,
            const char* remedy);

/// @throws Error unless all components are zero or more, and floats
vec3 not_negative(const Document& document, vec3 value, const char* factor, const std::string& material);

} // namespace sr::gltf
