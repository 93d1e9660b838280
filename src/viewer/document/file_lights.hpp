#pragma once
// Lights and materials of a file at one time, and what a person changed of each. Plain data: no GL.
#include "gltf/editable_factors.hpp"
#include "viewer/document/loaded_scene.hpp"

namespace sr::viewer {

/// Factors of a material that a person sets. What is absent is as the file states it.
struct MaterialFactors {
    std::optional<vec4> base_color{}; // linear, alpha in w
    std::optional<float> metallic{};
    std::optional<float> roughness{};
    gltf::FactorValues others{}; // of gltf::editable_factors

    bool any() const { return base_color || metallic || roughness || !others.empty(); }
    bool operator==(const MaterialFactors&) const = default;
};

/// A light, or an emission and other factors of a material, as a person edits it.
struct LightEdit {
    enum class Kind {
        light,    // a light of the file, or an added one
        material, // a material of the file, on all its surfaces
        softbox,  // a light of the studio rig
    };
    Kind kind = Kind::light;
    /// Number that stays at every time: FileLights::Light::number, or negative for an added light; the file's
    /// number of the material; index of the softbox in the rig.
    int source = 0;
    scene::Light light;              // current value, of lights and softboxes
    vec3 emission{0.0f};             // current value, of materials
    MaterialFactors factors{};       // of materials
    std::size_t material = 0;        // index in the scene, of materials
    std::string name{};              // in the file, before any edit
    int node = -1;                   // of a light of the file
    bool is_enabled = true;          // a disabled light emits nothing and stays where it is
    bool is_present = true;          // the file shows it at this time, in this variant
    bool is_removed = false;         // by a person
    bool overrides_quantity = false; // the quantity is a person's, at every time
    bool overrides_size = false;     // likewise a size
    bool overrides_name = false;     // likewise its name
    mat4 motion{1.0f};               // from the place in the file to the current place, in the world

    bool is_added() const { return kind == Kind::light && source < 0; }
    bool is_shown() const { return is_present && !is_removed; }
    bool is_edited() const {
        return is_removed || overrides_quantity || overrides_size || overrides_name || factors.any()
               || motion != mat4(1.0f);
    }
    /// True if the file does not say it.
    bool is_news() const { return is_added() ? !is_removed : is_edited() || !is_enabled; }
};

/// True if the same lights are there, at the same places and of the same sizes, and materials have the same
/// factors: at most quantities differ.
bool are_at_same_places(const std::vector<LightEdit>& a, const std::vector<LightEdit>& b);

/// The lights of a file at one time, in one variant, before any edit.
class FileLights {
public:
    struct Light {
        scene::Light light;
        int number = 0; // the same at every time
    };
    struct Material {
        int number = 0; // in the file; negative for the default material of glTF
        vec3 emission{0.0f};
        std::string name{};
        scene::Material stated{}; // as the file states it
    };
    std::vector<Light> lights; // the visible ones
    std::vector<Material> materials;

    /// Takes the lights of `loaded`, which has no edits yet.
    void read(const LoadedScene& loaded);

    /// The node of a light.
    int node_of(int number) const { return nodes_[static_cast<std::size_t>(number)]; }
    /// True if the node has several lights.
    bool shares_its_node(int number) const;

private:
    std::vector<int> nodes_; // of every light that was seen so far
};

/// Brings edits to another time or variant: what a person set stays, all else is the file's.
void rebase_edits(std::vector<LightEdit>& edits, const FileLights& now);

} // namespace sr::viewer
