#pragma once
// Changes of a scene that its picture must follow. They share nothing with the code that renders.
#include "scene/scene.hpp"
#include "support/random.hpp"

namespace sr::testing {

/// Moves, turns, scales, and perhaps mirrors, everything.
struct Similarity {
    double scale = 1.0;
    glm::dmat3 turn{1.0};        // orthonormal; of determinant -1 where it mirrors
    glm::dvec3 translation{0.0}; // [m]
};

/// The scene with its lights and cameras elsewhere. Intensities go with the square of the scale, so that what
/// arrives is the same. Cameras do not mirror: under a turn that does, theirs is followed by a mirror along
/// their own X, and the picture is the former one seen in a mirror.
scene::Scene placed(scene::Scene scene, const Similarity& similarity);

/// The same surfaces with the transforms of their instances worked into their vertices.
scene::Scene baked(const scene::Scene& scene);

/// Every mesh that neither emits nor is blended in two, each with some of its triangles.
scene::Scene split(const scene::Scene& scene, Random& random);

/// Textures are read at full resolution with one filter. A driver chooses the mip level, and between
/// magnification and minification, by differences to the pixel's neighbours on one side, which are on the
/// other side in a mirrored picture.
scene::Scene without_minification(scene::Scene scene);

/// Triangles that begin with another corner, triangles, meshes, instances, materials and lights in another
/// order. The triangles of what emits or is blended stay as they are; instances of one distance from the
/// viewer too.
scene::Scene shuffled(const scene::Scene& scene, Random& random);

} // namespace sr::testing
