#pragma once
// Textures of emitters and maps of environments, as texels that shaders read.
#include "scene/lights/light.hpp"
#include "scene/scene.hpp"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace sr::render {

/// Where a texture lies among the texels of all: its size, its wrap modes as wrap_u + 4 * wrap_v in the order
/// of scene::Wrap, and for each cell of it, row by row, the block that has its texels. Keep in sync with
/// shaders/light/emission_map.glsl.
struct EmissionMapPlace {
    int width = 0;
    int height = 0;
    int wrap = 0;
    std::vector<int> blocks;
};

/// Textures of emitters, as linear texels that a shader can read at any point of any light. Each texture is
/// there once: a scene at another time, or in other light, has the same textures. Texels are linear RGBA
/// in half precision, whose steps (2^-11) are finer than those of 8-bit sRGB.
///
/// A texture is cut into cells of side × side texels, and the texels of a cell are a block. All cells without
/// light share block 0: most of a texture that glows in places is black, and what a cache holds is not.
class EmissionMaps {
public:
    static constexpr int side = 32;
    static constexpr std::size_t block_texels = std::size_t{side} * side;

    /// Adds the texture behind the others unless it is there. @return its place, until maps are assigned
    const EmissionMapPlace& add(const scene::Scene& scene, int texture);

    /// Returns the mean linear colour of the part of a texture that a triangle covers, from 64 points of it.
    /// Calls for the same triangles in the same order after rewind() return remembered values.
    vec3 mean(const scene::Scene& scene, int texture, const std::array<vec2, 3>& uv);

    void rewind() { next_mean_ = 0; }

    std::size_t texel_count() const { return textures_.empty() ? 0 : block_texels * block_count_; }

    /// Writes the blocks of all textures. A texel is four half floats.
    void write_texels(const scene::Scene& scene, std::span<std::uint64_t> texels) const;

private:
    struct Mean {
        int texture = -1;
        std::array<vec2, 3> uv{};
        vec3 color{0.0f};
    };

    /// True if the part that the triangle covers is known to have no light.
    bool is_dark(const scene::Scene& scene, int texture, const std::array<vec2, 3>& uv) const;
    static vec3 measure_mean(const scene::Scene& scene, int texture, const std::array<vec2, 3>& uv);

    std::vector<int> textures_; // in the order of their texels
    std::map<int, EmissionMapPlace> places_;
    std::size_t block_count_ = 1;
    std::vector<Mean> means_;
    std::size_t next_mean_ = 0; // of means_
};

/// Maps of environments. Each map is there once, as in EmissionMaps. A map begins with a texel for each
/// row: the factor of its density besides the texel's own share [1/sr], where the row begins and ends
/// (EnvironmentMap::pole_heights), and the cdf over rows. Its texels follow, each with the cdf of its row,
/// and then the guides of the cdfs, which shorten the search in them: that over rows, and those of the rows.
/// Keep in sync with shaders/light/environment.glsl and cdf.glsl.
class EnvironmentTexels {
public:
    /// Adds a map with light behind the others unless it is there. @return its first texel. @throws Error if
    /// maps are too large for 32-bit floats to name it
    std::size_t add(const std::shared_ptr<const scene::EnvironmentMap>& map);

    std::size_t texel_count() const { return texel_count_; }

    /// Writes the texels of all maps.
    void write_texels(std::span<vec4> texels) const;

private:
    struct Place {
        std::shared_ptr<const scene::EnvironmentMap> map;
        std::size_t first = 0;
    };

    std::vector<Place> places_;
    std::size_t texel_count_ = 0;
};

} // namespace sr::render
