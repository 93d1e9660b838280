#pragma once
// The light tree, from which a sample of a pixel chooses one light.
#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace sr::render {

/// A node of the light tree: bounds of what its lights send out (Conty Estevez & Kulla 2018, section 4.1).
/// Lights at infinity have a subtree of their own.
struct LightNode {
    scene::Bounds box;  // of the emitters [m]; of lights at infinity: of the unit directions to them
    float power = 0.0f; // intensity along the normals, of lights at infinity irradiance; the whole is 1
    vec3 axis{0.0f, 1.0f, 0.0f}; // of the cone of normals, at infinity of the directions to the lights; unit
    float theta_o = 0.0f;        // half angle of that cone [rad]
    float theta_e = 0.0f;        // how far from its normal an emitter sends light [rad]
    bool is_two_sided = false;
    bool is_far = false;   // at infinity
    bool is_met = false;   // a direction of the BRDF's choice can meet one of the lights
    bool has_mesh = false; // one of the lights is a mesh, which only mirrors meet
    int light = -1;        // of a leaf
    int second_child = -1; // of an inner node, whose first child is the next node
    int parent = -1;
    int end = 0; // one past the last node of the subtree

    bool is_leaf() const { return light >= 0; }
};

/// Builds the tree over all lights that send out anything. Children come after their parent, depth first. The
/// tree is at most `max_light_tree_depth` deep. @return empty without such lights
std::vector<LightNode> build_light_tree(const scene::Scene& scene, std::span<const scene::Light> lights);

/// Keep in sync with shaders/light/tree.glsl.
inline constexpr int max_light_tree_depth = 64;
inline constexpr int texels_per_light_node = 5;

/// Returns the texels of the nodes, as shaders/light/tree.glsl reads them.
std::vector<vec4> pack_light_tree(std::span<const LightNode> nodes);

} // namespace sr::render
