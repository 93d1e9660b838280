#pragma once
// The vector and matrix types of the whole program: GLM's, under short names.
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sr {

using glm::mat3;
using glm::mat4;
using glm::quat;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float pi = 3.14159265358979323846f;

} // namespace sr
