#pragma once
// The BRDF at a point as a surface around it: in each direction wi as far out as it reflects towards wo.
// Plain data.
#include "core/math.hpp"

#include <span>
#include <vector>

namespace sr::viewer {

/// Directions over the hemisphere around n, on meridians that leave where a mirror would send wo and end at
/// the horizon. The points of a meridian are the denser the nearer they are to its beginning, a thousandth of
/// its length at first, so that narrow peaks show. The first meridian goes over n; together with the one
/// opposite it is the plane of incidence.
struct LobeGrid {
    static constexpr std::size_t meridians = 48;
    static constexpr std::size_t points = 40; // of a meridian, without its beginning

    static constexpr std::size_t size() { return 1 + meridians * points; }
    /// Where the direction stands; point 0 is the beginning of all meridians.
    static constexpr std::size_t index(std::size_t meridian, std::size_t point) {
        return point == 0 ? 0 : 1 + meridian % meridians * points + point - 1;
    }
};

/// Those directions. `n` and `wo`: unit, wo not below the surface.
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

/// What is shown of f_r in a direction.
struct LobeLook {
    bool has_cosine = true;      // f_r cosθ_i [1/sr] instead of f_r
    bool is_logarithmic = false; // as many decades as it takes to see the lobe's median
};

/// f_r, or f_r cosθ_i, of a direction in which f_r is `f_r`.
float shown_value(const Lobe& lobe, vec3 wi, float f_r, const LobeLook& look);

struct LobeScale {
    float largest = 0.0f; // value over the grid, drawn at 1; 0 where nothing is reflected
    float decades = 0.0f; // below it that are drawn; 0: linear
};
LobeScale scale_of(const Lobe& lobe, const LobeLook& look);
/// How far out a value is drawn, 0 to 1.
float shown_radius(float value, const LobeScale& scale);

/// A direction's angle from n in the plane of incidence, positive on the side that a mirror sends wo to; of
/// directions off that plane θ_i with the sign of the side they are on [rad].
float plane_angle(const Lobe& lobe, vec3 wi);

} // namespace sr::viewer
