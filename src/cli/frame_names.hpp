#pragma once
// Names of the files of a sequence.
#include <optional>
#include <string>

namespace sr::cli {

/// Returns "out.####.png" or "out.%04d.png" with the frame's number; absent if the name has no place for it.
std::optional<std::string> numbered(const std::string& pattern, int frame);

} // namespace sr::cli
