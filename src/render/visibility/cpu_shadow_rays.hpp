#pragma once
// Shadow rays of a frame: recorded by shaders, traced on the CPU.
#include "render/film.hpp"
#include "render/gpu/blocks.hpp"
#include "render/gpu/gpu_scene.hpp"
#include "render/gpu/shader_library.hpp"
#include "render/visibility/recorded_ray.hpp"

namespace sr::render {

/// Traces the rays from the opaque surfaces of a frame to its lights.
class CpuShadowRays {
public:
    /// For the opaque surfaces whose depth lies in `frame`. `light_choices`: Renderer::light_choices().
    /// @throws Error if the driver refuses the targets.
    CpuShadowRays(const GpuScene& scene, const RenderTarget& frame, int width, int height,
                  std::size_t max_rays, int light_choices);

    /// Divides the rows into bands whose rays to this many lights fit into memory.
    /// @throws Error if not even one row does.
    std::vector<RowRange> divide(RowRange rows, int light_count) const;

    /// Finds V of every ray of the band to the lights [first, end), and binds it for
    /// visibility/resolve.glsl. `frame_data` then has these lights.
    void find(RowRange band, int first_light, int end_light, FrameData& frame_data, ShaderLibrary& shaders);

    const TracedRays& traced() const { return traced_; } // so far

private:
    /// The answers' planes: which ray the first is of, and how many pixels each has.
    struct Planes {
        int first_ray = 0;
        std::size_t size = 0;
    };

    /// Records and traces the rays that come after the first `taken` of each pixel.
    /// @return whether there may be more
    bool record_and_answer(RowRange band, int taken, ShaderLibrary& shaders);
    void read(RowRange band, int attachment, std::vector<vec4>& texels);
    std::size_t answer(RowRange band); // @return how many rays there were
    std::size_t answer_row(std::size_t first, std::size_t end);
    void upload_answers();
    void upload_block(const RaysBlock& block);
    std::size_t channels() const; // of V
    /// Returns the number of rays that a pixel may send to this many lights.
    int rays_to(int light_count) const { return (chooses_ ? 1 : light_count) * rays_per_light_; }

    const GpuScene& scene_;
    int width_;
    int height_;
    bool chooses_;         // a sample chooses lights, and their rays share the planes of one light
    int rays_per_light_;   // as visibility/record.glsl counts them
    std::size_t max_rays_; // held at once
    std::vector<gl::Texture> targets_; // the receivers, then a ray each
    gl::Texture last_rays_;            // the last target as the pass before left it
    gl::Framebuffer framebuffer_{"rays"};
    gl::Buffer block_{"rays"};
    BufferTexture answers_{"the answered rays", GL_R32F};
    BufferTexture tinted_answers_{"the answered rays", GL_RGB32F}; // where V has a colour
    std::vector<vec4> receivers_;                                  // of the band
    std::vector<vec4> rays_;
    std::vector<float> values_; // one an answer, three where V has a colour
    Planes planes_;
    TracedRays traced_;
};

} // namespace sr::render
