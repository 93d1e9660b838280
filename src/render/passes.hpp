#pragma once
// The passes of a frame, in the order in which they run. Each sets all the state that it depends on.
#include "render/film.hpp"
#include "render/gpu/gpu_scene.hpp"
#include "render/gpu/shader_library.hpp"
#include "render/triangle_buffer.hpp"
#include "render/view.hpp"

namespace sr::render {

/// The way in which a pass changes the colours of its target.
enum class Writing { replaces, adds };

/// Pixels of the scissor that a pass goes over: all; those that no mask_pass() closed; or those that see an
/// opaque surface, where no pixel is closed.
enum class Pixels { all, open, with_surface };

/// Begins a frame: no surface, at any depth. Its colours are those of before until background_pass() and
/// forward_pass() write them: drivers on the CPU take several times as long to clear floats as to draw them.
void begin_pass(const RenderTarget& frame);

/// Closes the pixels where the texture of unit 0 is not 0 to all passes that follow.
void mask_pass(const RenderTarget& frame, ShaderLibrary& shaders);

/// Lays down the depth of opaque and masked surfaces. `triangles`: of this frame, gets the triangles that
/// pixels see; null: nobody asks for them.
void depth_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                const mat4& clip_from_world, TriangleBuffer* triangles);

/// The fragment shader of the depth pass. `has_triangles`: with a TriangleBuffer.
const char* depth_shader_of(const Draw& draw, bool has_triangles);

/// The background of the surfaces, which has no coverage.
struct Background {
    vec3 L{0.0f};                  // [cd/m²]
    bool has_environments = false; // those that cameras see are added
    bool is_behind_all = false;    // it is written where surfaces are, too

    bool is_black() const { return L == vec3(0.0f) && !has_environments && !is_behind_all; }
};

/// Writes the background where the depth pass left no surface, under a vertex array without vertices.
void background_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                     const Background& background, Writing writing);

/// Compiles what background_pass() takes. @throws ShaderError
void compile_background(ShaderLibrary& shaders, const Background& background);

/// Writes the rays that the forward pass will ask about within the scissor into the bound framebuffer, whose
/// depth is the pre-pass's: to attachment 0 the receivers, to `attachments` - 1 others a ray each. With
/// `light_choices` as the forward pass has it.
void record_pass(const GpuScene& scene, ShaderLibrary& shaders, int attachments, int light_choices);

/// Shades the surfaces whose depth the pre-pass left by the fragment shader `shader`. `triangles`: those of
/// the depth pass, by which a pixel is shaded once; null: rasterisation finds them again, and of surfaces in
/// one place the last one stays, so it cannot add.
void forward_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                  const std::string& shader, ProgramTerms terms, const TriangleBuffer* triangles,
                  Writing writing = Writing::replaces);

/// Compiles what forward_pass() takes for this draw. @throws ShaderError, Error
void compile_shading(ShaderLibrary& shaders, const Draw& draw, const std::string& shader, ProgramTerms terms,
                     bool has_triangles);

/// Adds what the CPU summed for these pixels (DeferredVisibility) to the frame, under a vertex array without
/// vertices.
void add_pass(const RenderTarget& frame, ShaderLibrary& shaders, Pixels pixels);

/// True for the shader that counts surfaces: the passes add them all up, and there is no background.
bool counts_surfaces(const std::string& shader);

/// The fragment shader that draws this in the place of `shader`: glass multiplies what is behind it by a
/// colour, which takes glass.frag instead of forward.frag.
const std::string& fragment_of(const Draw& draw, const std::string& shader);

/// Blends the transparent instances over what is behind them, the farthest first; of double-sided ones the
/// backs first. Instances that interpenetrate are not split.
void blend_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders,
                const std::string& shader, vec4 eye, ProgramTerms terms);

/// Not of a frame that is rendered: writes which instance and triangle each pixel sees, transparent ones
/// included.
void seen_pass(const RenderTarget& frame, const GpuScene& scene, ShaderLibrary& shaders);

/// Adds these pixels of the frame to the film, or copies them. All of them, if the film has another depth
/// buffer than the frame.
void accumulate_pass(const RenderTarget& film, const RenderTarget& frame, ShaderLibrary& shaders,
                     Writing writing, Pixels pixels);

} // namespace sr::render
