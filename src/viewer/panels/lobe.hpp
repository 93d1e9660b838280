#pragma once
// Lobe of a BRDF at a point, as a surface whose distance in each direction wi is f_r(wi, wo). Plain data.
#include "core/math.hpp"

#include <span>
#include <vector>

namespace sr::viewer {

/// Grid of directions over the hemisphere around n. Meridians begin at the mirror direction of wo and end at
/// the horizon. Their points are denser near the beginning (a thousandth of the length at first), so that
/// narrow peaks show. The first meridian goes over n; with the opposite one it spans the plane of incidence.
struct LobeGrid {
    static constexpr std::size_t meridians = 48;
    static constexpr std::size_t points = 40; // of a meridian, without its beginning

    static constexpr std::size_t size() { return 1 + meridians * points; }
    /// Index of a direction; point 0 is the beginning of all meridians.
    static constexpr std::size_t index(std::size_t meridian, std::size_t point) {
        return point == 0 ? 0 : 1 + meridian % meridians * points + point - 1;
    }
};

/// Directions of the grid. `n` and `wo` are unit vectors; wo is not below the surface.
std::vector<vec3> lobe_directions(vec3 n, vec3 wo);

struct Lobe {
    vec3 n{0.0f};
    vec3 wo{0.0f};
    bool is_mirror = false; // a delta: values are its reflectance
    std::vector<vec3> wi;   // lobe_directions()
    std::vector<float> f_r; // in each of them, as luminance [1/sr]
    std::vector<vec3>
        light_wi; // mean directions of the lights, unit; (0, 0, 0) of those that do not shine here
    std::vector<float> light_f_r; // in each of them
};

/// How f_r is shown.
struct LobeSettings {
    bool has_cosine = true;      // f_r cosθ_i [1/sr] instead of f_r
    bool is_logarithmic = false; // with enough decades to show the median of the lobe
};

/// The shown value of a direction wi: f_r, or f_r cosθ_i.
float shown_value(const Lobe& lobe, vec3 wi, float f_r, const LobeSettings& look);

struct LobeScale {
    float largest = 0.0f; // value over the grid, drawn at 1; 0 where nothing is reflected
    float decades = 0.0f; // below it that are drawn; 0: linear
};
LobeScale scale_of(const Lobe& lobe, const LobeSettings& look);
/// Radius that a value is drawn at, 0 to 1.
float shown_radius(float value, const LobeScale& scale);

/// Angle from n in the plane of incidence, positive on the side of the mirror direction. Off that plane, θ_i
/// with the sign of the side [rad].
float plane_angle(const Lobe& lobe, vec3 wi);

} // namespace sr::viewer
