#pragma once
// GLM's vector and matrix types under short names, luminance, and a statistical test.
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

namespace sr {

using glm::mat3;
using glm::mat4;
using glm::quat;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float pi = 3.14159265358979323846f;

/// Luminance of linear RGB with Rec. 709 primaries, in the unit of its argument:
/// Y = 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709-6, item 3.2).
constexpr float luminance(float r, float g, float b) { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }
inline float luminance(vec3 rgb) { return luminance(rgb.r, rgb.g, rgb.b); }
inline double luminance(glm::dvec3 rgb) { return 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b; }

/// Pearson's statistic of counted against expected samples, in its standard deviations above its mean: large
/// if samples do not fall where their density says. Cells that expect fewer than 10 samples are one cell
/// together. Absent where fewer than two cells are left.
std::optional<double> chi_squared_excess(const std::vector<double>& expected,
                                         const std::vector<double>& counts);

} // namespace sr
