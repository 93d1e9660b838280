#pragma once
// Options of `steradian render` that do not go together.
#include "cli/render_options.hpp"

namespace sr::cli {

/// Refuses them before any work is done. @throws CLI::ValidationError; Error for an unknown format of a file.
void check(const RenderCommand& command);

} // namespace sr::cli
