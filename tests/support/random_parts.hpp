#pragma once
// The parts of a generated scene (random_scene.hpp): each appends to the file and returns an index or a
// property.
#include "support/random.hpp"
#include "support/random_scene.hpp"

namespace sr::testing {

/// The images that all materials choose from, as textures of the same numbers.
enum Picture : int {
    colors_picture,
    data_picture,
    normals_picture,
    alpha_picture,
    glow_picture,
    picture_count
};

/// `first_wrap`: which of the nine ways to wrap the first texture has; the next ones follow.
void append_pictures(MadeGltf& made, int first_wrap, Random& random);

/// @return the material's index
int append_material(MadeGltf& made, Surface surface, Random& random, const Extremes& extremes);

enum class Form { ground, quad, box, ball, soup, form_count };

/// A mesh of about the cube ±1. @return its index
int append_mesh(MadeGltf& made, Form form, Surface surface, int material, Random& random,
                const Extremes& extremes);

/// A light at a node of that index, which emits along its -Z or all around. The node is there.
void append_light(MadeGltf& made, Emitter emitter, int node, Random& random, const Extremes& extremes);

} // namespace sr::testing
