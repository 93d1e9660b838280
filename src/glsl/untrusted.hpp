#pragma once
// Gate for GLSL that somebody untrusted wrote: what the driver must not see is refused, and every loop ends.
#include "core/error.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::glsl {

/// The turns that all loops of untrusted code may take in one shader invocation. llvmpipe ends all loops of
/// an invocation after 65,535 turns, silently; half of that is left for ours.
inline constexpr int max_turns = 32'768;

inline constexpr std::size_t max_untrusted_bytes = 256 << 10; // of one file

/// A loop of untrusted code.
struct Loop {
    Location where;
    int number = 0; // from its place, 1 to 2²⁰ - 1: what a shader writes that it stopped

    bool operator==(const Loop& other) const { return number == other.number; }
};

/// An untrusted text that passed the gate.
struct Bounded {
    std::string text; // as many lines, and then #undef of each macro
    std::vector<Loop> loops;
    std::string code; // without comments and directives, macros written out, on one line
};

/// Checks a text and bounds its loops: each condition counts a turn, and all loops end after max_turns.
/// `permitted`: words that are refused otherwise ("discard", "gl_FragDepth"). Line breaks are "\n".
/// README.md has the rules. @throws Error for the first that is broken
Bounded bounded(std::string_view text, const std::string& place, std::span<const std::string> permitted = {});

/// @throws Error for names that no untrusted folder or archive may give a file: other than letters, digits,
/// `_`, `-` and `.`
void require_plain_name(std::string_view name, const std::string& place);

/// Declares what bounded loops call. Stands behind #version.
std::string_view turn_counter();

/// GLSL before and behind a fragment shader: writes the number of the loop that was stopped to the output
/// `out` ("film", "answer").
std::string_view main_renamed();
std::string main_that_tells(std::string_view out);

/// A loop that was stopped.
class LoopError : public Error {
public:
    explicit LoopError(const Location& where);
    const Location& where() const { return where_; }

private:
    Location where_;
};

/// Looks for what main_that_tells() wrote in pixels (R G B A), or in means of pixels. @throws LoopError
void require_ended_loops(std::span<const float> pixels, std::span<const Loop> loops);

} // namespace sr::glsl
