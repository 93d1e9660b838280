#pragma once
// Options of `steradian render` that do not go together.
#include "cli/arguments.hpp"

#include <optional>
#include <string>

namespace sr::cli {

struct RenderCommand : RenderSettings {
    bool json = false;
    bool has_rate = false; // --fps is given

    bool is_sequence() const { return frames || turntable; }
};

/// Refuses them before any work is done. @throws CLI::ValidationError; Error for an unknown format of a file.
void check(const RenderCommand& command);

/// Returns "out.####.png" or "out.%04d.png" with the frame's number; absent if the name has no place for it.
std::optional<std::string> numbered(const std::string& pattern, int frame);

} // namespace sr::cli
