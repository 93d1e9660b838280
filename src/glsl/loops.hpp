#pragma once
// Loop inversion: the test of a loop moves behind its body (Muchnick 1997, "Advanced Compiler Design and
// Implementation", section 18.5).
#include <string>
#include <string_view>

namespace sr::glsl {

/// Writes `for (a; b; c) body` as `{ a; if (b) do body while ((c, b)); }`, and `while` likewise, on as many
/// lines. Drivers that run many pixels at once on a CPU do not jump over a body whose test fails for all of
/// them: they run it once more than it turns, for nobody. Loops that count to a constant stay as they are,
/// since compilers unroll them. `text` is a whole shader with "\n" at the ends of its lines.
/// @throws Error for what is no GLSL (tokens.hpp)
std::string invert_loops(std::string_view text);

} // namespace sr::glsl
