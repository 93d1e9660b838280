#pragma once
// The shadow casters and their tree as shaders read them.
#include "render/gpu/gpu_texture.hpp"
#include "shadow/bvh.hpp"

namespace sr::render {

/// The samplers of shaders/interface/casters.glsl, in the order of their units from first_caster_unit on.
inline constexpr std::array caster_sampler_names{"bvh_nodes", "caster_triangles", "triangle_places",
                                                 "caster_data", "alpha_texels"};

class GpuCasters {
public:
    /// @throws Error if the driver's buffer textures are too small.
    GpuCasters(const shadow::Casters& casters, const shadow::Bvh& bvh);

    /// The triangles in their own order, with a tree of those of glass alone. @throws Error as above
    explicit GpuCasters(const shadow::Casters& casters);

    void bind() const;

private:
    BufferTexture nodes_{"the boxes of the shadow casters", GL_RGBA32I};
    BufferTexture triangles_{"the shadow casters", GL_RGBA32F};
    BufferTexture places_{"the places of the shadow casters", GL_R32I};
    BufferTexture data_{"the transparent shadow casters", GL_RGBA32F};
    BufferTexture alphas_{"the alphas of the shadow casters", GL_R16};
};

} // namespace sr::render
