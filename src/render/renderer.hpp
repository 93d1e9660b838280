#pragma once
// Renderer of a scene from a camera: each frame adds one sample to every pixel of the film.
#include "render/adaptive/converged_pixels.hpp"
#include "render/adaptive/error_estimate.hpp"
#include "render/films.hpp"
#include "render/gpu/blocks.hpp"
#include "render/passes.hpp"
#include "render/visibility/cpu_shadow_rays.hpp"
#include "render/visibility/deferred_visibility.hpp"
#include "render/visibility/depth_maps.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace sr::render {

/// How the integral over an emitter is evaluated: by samples, which converge to it, or in closed form with
/// few points (shaders/integrator/reflected_analytic.glsl).
enum class Estimator { sampled, analytic };

/// The lights that a sample of a pixel visits: all, or one at a time that the light tree chooses
/// (shaders/integrator/reflected_from_one.glsl). `automatic` is one where there are many.
enum class LightSampling { automatic, all, one };

/// Lights that a sample chooses, each with a shadow ray of its own; tools/bench/results/lights.md compares
/// numbers of them.
inline constexpr int default_light_choices = 4;

/// Points per lobe and emitter of the analytic estimator; tools/ltc/README.md compares numbers of points.
inline constexpr int default_analytic_points = 16;

/// A mesh of more emissive triangles is sampled by the analytic estimator too.
inline constexpr int max_outlined_triangles = 12;

/// Time of the parts of frames [s].
struct PassTimes {
    double depth = 0.0;   // depth maps, depth of opaque surfaces, background
    double shading = 0.0; // of opaque and of blended surfaces, with their shadow rays
    double adding = 0.0;  // of the frame to the film
};

struct RenderOptions {
    int width = 1280;
    int height = 720;
    int samples = 16; // that will be added; a single sample is at the centre of each pixel
    std::uint32_t seed = 0;
    vec3 background{0.0f}; // radiance where there is no surface [cd/m²]
    /// Fragment shader of the surfaces: forward.frag evaluates the equation, those in views/ show terms of
    /// it.
    std::string shader = "forward.frag";
    /// The only part that is drawn; the rest of the film stays black.
    std::optional<PixelRect> window;
    /// Roots of the shader files; the first root that has a file wins.
    std::vector<glsl::Root> shader_path{glsl::embedded()};
    /// Tries what others wrote of that path before this process compiles it; null: nothing is tried.
    std::shared_ptr<gl::TrialCompiler> trial;
    Estimator estimator = Estimator::sampled;
    /// `one` and `automatic` visit all where V comes from depth maps, where the estimator is analytic, and
    /// where a shader other than forward.frag, or a folder of the path that has integrator/reflected.glsl,
    /// sums over the lights itself.
    LightSampling lights = LightSampling::all;
    int light_choices = default_light_choices;     // of a sample that does not visit all lights
    int analytic_points = default_analytic_points; // 0: linearly transformed cosines alone
    MapOptions maps;                               // of a scene whose shadows are found by depth maps
    /// Shadow rays whose answers by the CPU are held at once, 4 bytes each; a picture with more is shaded in
    /// bands.
    std::size_t max_rays = std::size_t{64} << 20;
    /// Takes samples by turns from two independent sequences and keeps a second sum of the first one, which
    /// estimate_error() needs. A single sequence converges a little faster.
    bool estimates_error = false;
    bool has_shadows = true; // false: V = 1, whatever casts them
};

class Renderer {
public:
    /// Needs a current context for as long as it lives. @throws Error
    /// `shaders`: programs() of options with the same shader path and estimator, which renderers may share;
    /// null: its own.
    Renderer(const GpuScene& scene, const scene::Camera& camera, const RenderOptions& options,
             std::shared_ptr<ShaderLibrary> shaders = nullptr);

    /// Makes an empty library of programs for renderers with such options. @throws Error
    static std::shared_ptr<ShaderLibrary> programs(const RenderOptions& options);

    /// Compiles every program that the scene needs, so that no sample has to. @throws ShaderError
    void compile();

    /// Restricts the lights to [first, end) from the next sample on. Each light keeps the samples that it has
    /// among all lights. Surfaces still emit.
    void use_lights(int first, int end);

    /// Starts over with an empty film.
    void clear();

    /// Sets the camera and starts over with an empty film.
    void look_from(const scene::Camera& camera);

    /// Starts over with another size and number of samples, and the same programs. Call it also after
    /// GpuScene::relight. @throws Error if the driver does not take the size.
    void resize(int width, int height, int samples);
    int width() const { return options_.width; }
    int height() const { return options_.height; }

    /// Starts over with an empty film. Pixels freeze after as many samples as before, so that a film of as
    /// many samples has the same ones.
    void repeat();

    /// Renders one frame, one sample of every pixel that is not frozen, and adds it to the film.
    void add_sample();
    /// Renders the next `count` rows of a sample, so that the caller can do other work in between. Read the
    /// film only when the sample is complete. @return whether it is complete
    bool add_rows(int count);
    /// Returns the number of samples of the pixels that are not frozen.
    int sample_count() const { return sample_count_; }

    /// Freezes these pixels: they take no more samples, and no time, until clear() or look_from().
    void freeze(const PixelMask& pixels) { converged_.add(pixels, sample_count_); }
    /// True if no pixel is left that takes samples.
    bool is_frozen() const { return converged_.active(sample_count_).is_empty(); }
    const ConvergedPixels& converged_pixels() const { return converged_; }
    /// Returns the number of samples of each pixel, rows from top to bottom.
    std::vector<int> pixel_samples() const;

    bool estimates_error() const { return options_.estimates_error; }
    /// Estimates the error of the film against its limit from two halves of its samples; absent before both
    /// have one. Reads the film back. Only with RenderOptions::estimates_error.
    std::optional<ErrorEstimate> estimate_error() const;

    /// Reads back one pixel of read_film(). @throws LoopError likewise
    std::array<float, 4> read_pixel(int column, int row) const;

    /// Reads back the mean of the first sequence's samples, of which a pixel has one more if their number is
    /// odd. Only with RenderOptions::estimates_error.
    image::Image read_first_half() const;

    /// Reads back the mean of all samples so far: L_o [cd/m²] in RGB, coverage in A. @throws LoopError if a
    /// loop of untrusted code was stopped
    image::Image read_film() const;

    /// The sum of all samples so far, where shaders can read it: read_film() is it over pixel_samples(),
    /// which is sample_count() where no pixel is frozen.
    const gl::Texture& film_sum() const;

    std::size_t program_count() const { return shaders_->program_count(); }
    /// Returns whether the opaque surfaces are shaded once and the CPU adds up what is seen, where it traces
    /// the shadow rays. Otherwise they are shaded twice: to record the rays, and with the answers.
    bool defers_visibility() const { return deferred_.has_value(); }

    /// Returns whether finely meshed surfaces are shaded pixel by pixel (TriangleBuffer).
    bool shades_pixels() const { return triangles_.has_value(); }

    /// The rays that the CPU answered; absent where it answers none.
    std::optional<TracedRays> traced_rays() const;

    /// Adds the time of each part of a frame to `times` from now on, and waits for the GPU after each; null:
    /// no more.
    void measure_passes(PassTimes* times) { pass_times_ = times; }

    /// Returns the number of lights that a sample chooses; 0 if it visits all.
    int light_choices() const { return light_choices_; }

    /// The depth maps; null where shadows are found otherwise.
    const DepthMaps* depth_maps() const { return depth_maps_ ? &*depth_maps_ : nullptr; }

private:
    void ask_for_shadows();
    Depths depths_of_frame() const;
    void ask_for_triangles();
    void ask_for_frame();
    void leave_out_triangles();
    TriangleBuffer* triangles() { return triangles_ ? &*triangles_ : nullptr; }
    View begin_frame();
    PixelRect window() const; // what this frame draws
    void draw(const PixelRect& part);
    void set_scissor(const PixelRect& window) const;
    int choices_of_lights() const;
    bool can_defer_visibility() const;
    ProgramTerms opaque_terms() const;
    ProgramTerms blended_terms() const;
    void shade_opaque(const PixelRect& window);
    int half_of_sample() const;
    const RenderTarget& film_of_sample() const;
    const RenderTarget& target() const; // what surfaces are drawn into, and how
    Writing writing() const;
    Writing writing_of_film() const;
    Pixels open_pixels() const;
    bool skips_background() const;
    Background background() const; // terms of the equation have no environment behind them

    const GpuScene& scene_;
    scene::Camera camera_;
    RenderOptions options_;
    bool has_shadows_ = true; // and the shader asks for them
    int first_light_ = 0;
    int end_light_ = 0;
    std::shared_ptr<ShaderLibrary> shaders_;
    Depths depths_;
    Films films_;
    std::optional<RenderTarget> frame_;       // of a sample that cannot be added as it is drawn
    std::optional<TriangleBuffer> triangles_; // where finely meshed surfaces are shaded pixel by pixel
    ConvergedPixels converged_;
    /// ConvergedPixels::event_of() whose triangles are drawn; absent: all are.
    std::optional<int> triangles_of_;
    FrameData frame_data_;
    std::optional<DeferredVisibility> deferred_;
    // or else:
    std::optional<CpuShadowRays> shadow_rays_;
    int rays_per_point_ = 0; // that these were made for
    int light_choices_ = 0;
    std::optional<DepthMaps> depth_maps_;
    gl::VertexArray no_vertices_{"no vertices"}; // core profile draws need one bound
    int sample_count_ = 0;
    int rows_done_ = 0; // of the next sample
    PassTimes* pass_times_ = nullptr;
};

} // namespace sr::render
