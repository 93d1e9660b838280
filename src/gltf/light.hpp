#pragma once
// Lights: KHR_lights_punctual (light.cpp), EXT_lights_area (area_light.cpp), EXT_lights_ies (ies_light.cpp),
// and the shapes of extras.steradian (shape_light.cpp).
#include "gltf/hierarchy.hpp"
#include "gltf/statement.hpp"
#include "gltf/texture.hpp"
#include "gltf/warnings.hpp"
#include "scene/ies.hpp"
#include "scene/light.hpp"

#include <map>
#include <vector>

namespace sr::gltf {

/// Collects the lights of placed nodes, in world space. They keep their photometric numbers whatever the
/// node's scale is; only sizes scale.
class LightTable {
public:
    /// Textures of emitters are asked for in `textures`.
    LightTable(const Document& document, TextureTable& textures) : document_(document), textures_(textures) {}

    /// Appends the lights that a node carries, whether or not it is visible. A lamp that glTF states wrongly
    /// or whose node is scaled to nothing is off, with a warning.
    /// @throws Error naming what extras.steradian states of a light and makes no sense
    void append(const PlacedNode& placed, Warnings& warnings);

    const std::vector<scene::Light>& lights() const { return lights_; }
    /// Forgets the lights, and keeps their profiles: what comes next is another moment of the same file.
    void clear() { lights_.clear(); }
    const std::vector<scene::LightProfile>& profiles() const { return profiles_; }

private:
    void append_punctual(const PlacedNode& placed, Warnings& warnings);
    void append_area(const PlacedNode& placed, Warnings& warnings);
    void append_shape(const PlacedNode& placed, Warnings& warnings);
    void append_ies(const PlacedNode& placed, Warnings& warnings);

    /// The emission map of extras.steradian.texture; none where there is no texture. A node that mirrors
    /// mirrors the picture, too.
    scene::EmissionMap map_of(const tinygltf::Value* stated, const PlacedNode& placed);
    /// An IES file of the glTF, read once; with the index of its profile.
    const std::pair<int, scene::IesLuminaire>& luminaire(int index, const std::string& title);

    const Document& document_;
    TextureTable& textures_;
    std::vector<scene::Light> lights_;
    std::vector<scene::LightProfile> profiles_;
    std::map<int, std::pair<int, scene::IesLuminaire>> luminaires_;
};

/// How a light stands in the world: orthonormal, with one scale.
struct LightFrame {
    glm::dvec3 position{0.0}; // [m]
    glm::dvec3 front{0.0};    // the node's -Z, where the light goes
    glm::dvec3 u{0.0};        // along the node's X or against it, so that cross(u, v) is the front
    glm::dvec3 v{0.0};        // along the node's Y
    double scale = 1.0; // the largest of the node's axes: what the draft of EXT_lights_area scales sizes by
};

/// @throws Error naming the light if its node is scaled to nothing along its Z
LightFrame frame_of(const Document& document, const PlacedNode& placed, const std::string& title);

/// The same for a light that has sides. @throws Error if they are scaled to nothing, too
LightFrame sided_frame_of(const Document& document, const PlacedNode& placed, const std::string& title);

/// What is done without a lamp that is lost.
inline constexpr std::string_view without_lamp = "until then that lamp is off";

/// A size in the file times the frame's scale [m]. @throws Error unless it is positive and finite
float scaled_size(const Document& document, double size, const LightFrame& frame, std::string_view what,
                  const std::string& title);

/// What errors call a light: "light "Key" (/extensions/…/lights/0)".
std::string light_title(std::string_view extension, int index, std::string_view name);

/// Colour times quantity. @throws Error if either is negative
glm::dvec3 emitted_color(const Document& document, glm::dvec3 color, double quantity,
                         const std::string& title);

/// The text, the flag and the three numbers of an object's property, or what stands for them where it is
/// absent.
std::string text_in(const tinygltf::Value& object, const std::string& key);
bool flag_in(const tinygltf::Value* object, const std::string& key, bool fallback);
glm::dvec3 color_in(const tinygltf::Value& object);

/// Which units an area light can be stated in.
inline constexpr std::string_view area_takes =
    "state an area light in lm, cd or cd/m^2, or in W, W/sr or W/(m^2 sr): lx says what arrives elsewhere";

/// Sets L, and what else a flat light's statement says. @throws Error
template<class Flat>
void state_flat(const Document& document, Flat& light, const tinygltf::Value* stated, glm::dvec3 own,
                const std::string& title) {
    light.is_visible = flag_in(stated, "visible", true);
    light.is_two_sided = flag_in(stated, "two_sided", false);
    const scene::Radiator radiator = scene::radiator_of(light);
    const Conversion conversion = [&](scene::Quantity quantity, double value) {
        return scene::radiance_from(quantity, value, radiator);
    };
    light.L = emitted(document, statement_of(document, stated, title), own, conversion, title, area_takes);
}

} // namespace sr::gltf
