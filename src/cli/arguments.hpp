#pragma once
// Arguments of commands: the table of options on a command line, and checks of what people type.
#include "settings/options.hpp"

#include <string>

namespace CLI {
class App;
}

namespace sr::cli {

using settings::RenderSettings;
using settings::Size;

/// Declares the options that `taker` takes on `command`; parsing fills `settings`.
void declare(CLI::App& command, settings::Taker taker, RenderSettings& settings);

/// Returns the message for a number that is not finite, which range checks accept; empty for others.
std::string refusal_of_number(const std::string& text);

} // namespace sr::cli
