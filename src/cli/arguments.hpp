#pragma once
// Arguments of commands: the table of options on a command line, and checks of what people type.
#include "glsl/root.hpp"
#include "settings/options.hpp"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sr::cli {

using settings::RenderSettings;
using settings::Size;

/// Declares the options that `taker` takes on `command`; parsing fills `settings`.
void declare(CLI::App& command, settings::Taker taker, RenderSettings& settings);

/// Returns the default size of a picture: 720 rows in the camera's aspect ratio, 16:9 if it has
/// none.
Size picture_size(std::optional<float> aspect_ratio);

/// Returns the message for a number that is not finite, which range checks accept; empty for others.
std::string refusal_of_number(const std::string& text);

/// Returns the given folders in front of the built-in shaders; remarks on those that replace nothing.
/// @param is_untrusted whether they pass the gate of glsl/untrusted.hpp. @throws Error if one is no folder.
std::vector<glsl::Root> shader_path(const std::vector<std::string>& folders, bool is_untrusted = false);

} // namespace sr::cli
