#pragma once
// Values that people type.
#include "core/math.hpp"
#include "glsl/root.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::cli {

struct Size {
    int width = 0;
    int height = 0;
};

/// Returns the default size of a picture: 720 rows in the camera's aspect ratio, 16:9 if it has
/// none.
Size picture_size(std::optional<float> aspect_ratio);

/// "1280x720"; absent if it is not two whole numbers from 1 to 65536.
std::optional<Size> parsed_size(const std::string& text);

/// Returns the message for a number that is not finite, which range checks accept; empty for others.
std::string refusal_of_number(const std::string& text);

/// "0.1,0.2,0.3" or a single number for all three; absent if it is neither, or not finite.
std::optional<vec3> parsed_color(const std::string& text);

/// "0.5%" is 0.005; absent if it is not a percentage above 0 and below 100.
std::optional<double> parsed_percentage(const std::string& text);

/// "2", "2s", "1.5min" [s]; absent if it is not above 0.
std::optional<double> parsed_duration(const std::string& text);

/// The given folders in front of the built-in shaders; remarks on those that replace nothing.
/// @param is_untrusted whether they pass the gate of glsl/untrusted.hpp. @throws Error if one is no folder.
std::vector<glsl::Root> shader_path(const std::vector<std::string>& folders, bool is_untrusted = false);

} // namespace sr::cli
