#pragma once
// The equation at one pixel, term by term.
#include "render/renderer.hpp"

#include <memory>
#include <span>
#include <stop_token>

namespace sr::render {

/// Contribution of one light to a pixel. Its values are means over all samples. E and the values derived from
/// it are estimated by points on the light.
struct LightTerms {
    float solid_angle = 0.0f; // Ω [sr]; 0 for emitters without extent
    vec3 wi{0.0f};            // the mean direction, weighted by E; shorter than 1 the larger the light is
    float cos_i = 0.0f;       // the mean cosθ_i, weighted by E
    vec3 E{0.0f};             // irradiance [lx], shadows included
    float V = 1.0f;           // E over E without shadows, as luminance
    vec3 V_color{1.0f};       // the same for red, green and blue, which glass makes differ
    vec3 f_r{0.0f};           // L_r / E [1/sr]
    vec3 L_r{0.0f};           // what the pixel gains by this light [cd/m²]
};

struct PixelTerms {
    vec3 x{0.0f};          // at the pixel's centre [m]
    vec3 n{0.0f};          // at the pixel's centre
    vec3 wo{0.0f};         // at the pixel's centre
    float coverage = 0.0f; // how much of the pixel surfaces cover, 0 to 1
    vec3 L_e{0.0f};        // what remains when no light shines: emission and background [cd/m²]
    std::vector<LightTerms> lights;
    vec3 L_o{0.0f}; // the pixel as rendered [cd/m²]; L_e + Σ L_r, but for rounding
};

/// Probe of the pixel (column, row), counted from the picture's upper left corner, in steps between which
/// others can work: one render for each term and light, with the samples that the whole picture would have.
/// The order: x, n, wo, L_o and L_e at once, then one kind of term after the other, for all lights.
class Probing {
public:
    /// Kinds of terms of lights, in the order in which they are rendered.
    enum Kind { radiance, irradiance, direction, solid_angle_and_V };

    /// `scene` outlives it. `first_samples`: if above 0, a first round takes at most so many samples.
    Probing(const GpuScene& scene, const scene::Camera& camera, const RenderOptions& options, int column,
            int row, int first_samples = 0);
    ~Probing();

    /// Renders the next term. Only before is_done(). @throws ShaderError, LoopError, Error
    void step();
    bool is_done() const;
    bool is_first_round() const;
    /// True if all lights have terms of this kind, by the first round at least.
    bool has(Kind kind) const;
    const PixelTerms& terms() const;

private:
    struct Run;
    std::unique_ptr<Run> run_;
};

/// Probes in one go. @return absent if it was stopped
std::optional<PixelTerms> probe(const GpuScene& scene, const scene::Camera& camera,
                                const RenderOptions& options, int column, int row,
                                const std::stop_token& stop = {});

// The BRDF of the surface at a pixel, direction by direction.

struct PixelBrdf {
    bool is_mirror = false; // a delta towards reflect(-wo, n): f_r is its reflectance ρ instead
    std::vector<vec3> f_r;  // [1/sr], one for each wi
};

/// f_r(x, wi, wo) for each `wi` (unit, world space) of the surface that the centre of the pixel (column, row)
/// sees, counted from the upper left corner, its textures and normal map included: the fragment that renders
/// there, with another direction each time. Only the pixel's triangle is drawn, so that it takes some 10 µs a
/// direction in software GL.
/// @return absent where nothing is seen. @throws ShaderError, Error
std::optional<PixelBrdf> evaluate_brdf(const GpuScene& scene, const scene::Camera& camera,
                                       const RenderOptions& options, int column, int row,
                                       std::span<const vec3> wi);

} // namespace sr::render
