#pragma once
// A frame whose shadow rays the CPU traces, shaded once. V is a factor of each sample: the shader writes the
// samples and their rays down, and the CPU adds up what is seen.
#include "render/film.hpp"
#include "render/gpu/blocks.hpp"
#include "render/gpu/gpu_scene.hpp"
#include "render/gpu/shader_library.hpp"
#include "render/passes.hpp"
#include "render/triangle_buffer.hpp"
#include "render/visibility/pixel_sums.hpp"
#include "render/visibility/recorded_ray.hpp"

namespace sr::render {

/// Shades the opaque surfaces of a frame by shaders/deferred.frag. It needs shader storage buffers, which
/// OpenGL 4.1 does not promise, but Mesa's software renderers have.
class DeferredVisibility {
public:
    /// Returns whether the current context runs on the CPU and has what this needs.
    static bool is_offered();

    /// `max_rays`: RenderOptions::max_rays; `light_choices`: Renderer::light_choices(). @throws Error if the
    /// samples of a row of pixels take too much memory
    DeferredVisibility(const GpuScene& scene, int width, int height, std::size_t max_rays, int light_choices);

    /// Compiles the programs that shade() uses. @throws ShaderError
    /// `has_triangles`: for shade() with a TriangleBuffer.
    void compile(ShaderLibrary& shaders, bool has_triangles) const;

    /// Writes L_e of the opaque surfaces, where their depth lies in `frame`, and adds L_r under the lights
    /// [first, end) to `sums`, in the columns and rows of this window. `frame_data` then has these lights.
    /// `triangles` as in forward_pass(), and `writing`, which can add only if shades_once().
    void shade(const RenderTarget& frame, const TriangleBuffer* triangles, const PixelRect& window,
               int first_light, int end_light, FrameData& frame_data, ShaderLibrary& shaders, PixelSums& sums,
               Writing writing);

    /// Returns whether L_e is written once. Many lights take several passes.
    bool shades_once() const { return lights_at_once_ >= scene_.light_count(); }

    const TracedRays& traced() const { return traced_; } // so far

private:
    ProgramTerms terms() const { return {VisibilityTerm::defer, light_choices_}; }
    std::size_t pixel_words() const; // of its samples, in shaders/interface/deferred.glsl
    void add_seen(RowRange band, PixelSums& sums);
    std::size_t add_seen_of_row(std::int32_t* words, std::size_t first, std::size_t plane,
                                std::span<float> sums) const;

    const GpuScene& scene_;
    int width_;
    int light_choices_;
    int lights_at_once_;
    int most_rays_; // of a pixel, to this many lights
    int rows_at_once_;
    gl::Buffer samples_{"deferred samples"};
    gl::Buffer block_{"rays"};
    TracedRays traced_;
};

} // namespace sr::render
