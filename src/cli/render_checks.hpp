#pragma once
// Options of `steradian render` that do not go together.
#include "cli/arguments.hpp"

namespace sr::cli {

struct RenderCommand : RenderSettings {
    std::vector<std::string> outputs; // one rendering, written in each form
    bool json = false;
};

/// Refuses them before any work is done. @throws CLI::ValidationError; Error for an unknown format of a file.
void check(const RenderCommand& command);

} // namespace sr::cli
