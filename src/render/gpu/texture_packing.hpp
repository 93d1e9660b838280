#pragma once
// Metalness and roughness in the spare channels of other textures.
#include "scene/scene.hpp"

#include <vector>

namespace sr::render {

/// The source of the alpha of a texture that needs none of its own.
struct PackedAlpha {
    int image = -1;  // index into Scene::images; negative: from its own image
    int channel = 0; // of that image

    bool operator==(const PackedAlpha&) const = default;
};

/// The materials that read their metalness from the alpha of their normal map, and their roughness from that
/// of their base colour, so that they read a texture less. That takes an opaque material whose three textures
/// have one size, one sampler and the same coordinates, and that shares the two only with materials of the
/// same three.
struct TexturePacking {
    std::vector<bool> is_packed;         // by material
    std::vector<bool> is_needed;         // by texture: not all that it says lies elsewhere
    std::vector<PackedAlpha> alpha_from; // by texture

    /// Materials that came later are not packed.
    bool packs(int material) const {
        const auto i = static_cast<std::size_t>(material);
        return i < is_packed.size() && is_packed[i];
    }
};

/// Packs what can be packed; `is_wanted`: false packs nothing.
TexturePacking pack_textures(const scene::Scene& scene, bool is_wanted);

} // namespace sr::render
