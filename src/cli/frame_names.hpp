#pragma once
// The frames of a sequence, and the names of their files.
#include <optional>
#include <string>

namespace sr::cli {

/// Frames from the first to the last, both included; up to the end of the animation where the last is absent.
struct FrameRange {
    int first = 0;
    std::optional<int> last;
};

/// "0:47" or "12:"; absent if it is neither.
std::optional<FrameRange> parsed_frames(const std::string& text);

/// "out.####.png" or "out.%04d.png" with the frame's number; absent if the name has no place for it.
std::optional<std::string> numbered(const std::string& pattern, int frame);

} // namespace sr::cli
