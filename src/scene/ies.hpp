#pragma once
// IES LM-63 files: the intensities of a luminaire, as laboratories publish them.
#include "scene/profile.hpp"

#include <optional>
#include <string_view>

namespace sr::scene {

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
