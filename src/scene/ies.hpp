#pragma once
// Photometric profiles, and IES LM-63 files: the intensities of a luminaire, as laboratories publish them.
#include <optional>
#include <string>
#include <string_view>
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

/// How a lamp's output depends on its position (TILT=INCLUDE).
struct IesTilt {
    /// The lamp within a luminaire that is aimed straight down: upright, or lying; a lying one may stay so
    /// when the luminaire is tilted, or tilt with it.
    enum class Geometry { upright = 1, stays_lying = 2, lying = 3 };

    Geometry geometry = Geometry::upright;
    std::vector<double> angles;  // ascending [rad]
    std::vector<double> factors; // of the intensities, one an angle [1]
};

struct IesLuminaire {
    /// All factors but the tilt's are in. Its axis is photometric zero; its φ runs against the file's
    /// horizontal angle (φ = 360° - H), because its frame has the axis along -Y and the file counts about the
    /// opposite of it.
    LightProfile profile;
    std::optional<IesTilt> tilt;
};

/// Reads LM-63-1986, -1991, -1995, -2002 and -2019. Type C photometry as it stands, completed by its symmetry
/// (0, 0–90, 0–180, 0–360 and 90–270 degrees); type B resampled by 1° × 2°.
/// @throws Error with the line of whatever is wrong; type A photometry and TILT=FILE are refused. `name` is
/// the file's, for messages
IesLuminaire read_ies(std::string_view text, const std::string& name);

/// The factor of a luminaire whose axis is turned away from straight down by `angle` [rad]; linear between
/// the table's angles, constant beyond them.
double tilt_factor(const IesTilt& tilt, double angle);

} // namespace sr::scene
