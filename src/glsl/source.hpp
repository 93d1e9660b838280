#pragma once
// OpenGL has no #include, so it is expanded before the driver sees the text, and a table leads the driver's
// line numbers back to the files that people edit. No #line is emitted: Mesa loses its string number in most
// errors.
#include "core/error.hpp"
#include "glsl/root.hpp"
#include "glsl/untrusted.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::glsl {

/// A shader with its includes expanded, ready for glShaderSource.
struct Source {
    /// The origin of an expanded line.
    struct Line {
        int file = 0; // index into `files`
        int line = 0; // from 1
    };

    std::string text;
    std::vector<std::string> files; // as errors name them; files[0] is the entry. A hot reload watches these.
    std::vector<Line> lines;        // lines[i] is the origin of the text's line i + 1
    std::vector<std::string> foreign; // those of `files` that somebody else wrote (Root::is_foreign)
    std::vector<Loop> loops;          // of untrusted roots

    /// The place of a flat line, which counts from 1. Beyond the end: the last line; 0: the entry file alone.
    Location location(int flat_line) const;
};

/// Expands `#include "brdf/ggx.glsl"` lines, recursively; a file is included at most once.
/// Names are relative to the roots, in every file; the first root in `path` that has the file wins.
/// A directive inside a comment does not count, one inside `#if` does: the preprocessor runs later, in the
/// driver.
/// `#version` may stand on the entry file's first line and nowhere else.
/// Files of untrusted roots pass the gate, and their loops are bounded (untrusted.hpp). A fragment shader
/// whose output is `film` or `answer` then writes there that a loop was stopped.
/// @throws Error for a file that no root has, an include cycle (with its chain), a malformed include line, a
/// misplaced #version, a comment that never ends, and what the gate refuses.
Source expand(std::span<const Root> path, std::string_view file);

/// True if the text has `function(…) {`: not a call and no prototype, which a ';' follows.
bool declares(std::string_view text, std::string_view function);

} // namespace sr::glsl
