#pragma once
// A photometric profile: the intensity of a luminaire by direction.
#include <string>
#include <vector>

namespace sr::scene {

/// I(γ, φ) on a grid, to be interpolated linearly in both angles. γ is the angle from the luminaire's axis
/// (its nadir, -Y of the profile's frame) up to π; φ turns around it, from +X of the frame towards +Z, and
/// the grid always covers the whole turn: the first column stands at 0, the last at 2π and repeats the first.
/// Beyond the first and last γ there is no light.
struct LightProfile {
    std::string name;
    std::vector<float> gamma; // ascending [rad], two or more
    std::vector<float> phi;   // ascending from 0 to 2π [rad], two or more
    std::vector<float> I;     // [cd]: phi.size() columns of gamma.size() values each
};

/// ∫ I dω of a profile [lm], exact for its interpolation: in closed form over γ, by trapezoids over φ.
double flux_of(const LightProfile& profile);

} // namespace sr::scene
