#pragma once
// GLSL of the equation, term by term: the line that computes a term, and the code without that term.
#include "glsl/root.hpp"
#include "glsl/source.hpp"
#include "scene/lights/light.hpp"
#include "scene/material.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sr::viewer {

/// A factor or a summand of L_o = L_e + Σ f_r L V cosθ.
enum class EquationTerm { emission, f_r, light, visibility, cosine };
inline constexpr std::size_t equation_term_count = 5;

/// The lines of a file around the one that computes a term.
struct CodeExcerpt {
    std::string file; // as errors name it
    int line = 0;     // that computes the term, from 1
    int first = 0;    // of `lines`
    std::vector<std::string> lines;

    const std::string& computing_line() const { return lines[static_cast<std::size_t>(line - first)]; }
};

/// A line before and after a term is left out.
struct LeftOut {
    std::string file; // as errors name it
    int line = 0;     // from 1
    std::string before, after;
    glsl::Root overlay; // stands in front of the shader path
};

/// Shaders and surface of a pixel, whose terms have their code here.
struct EquationCode {
    std::span<const glsl::Root> path; // of the render; the last root is ours
    scene::Model model{};             // of the surface there
    bool is_mirror = false;           // the pixel's f_r is a delta
    std::string visibility{};         // "ray": shaders/visibility/ray.glsl answers

    /// The line that computes a term. `light`: the emitter, for EquationTerm::light.
    /// @return absent if the path computes the equation in another way. @throws Error if it cannot be
    /// expanded
    std::optional<CodeExcerpt> of(EquationTerm term, const scene::Light* light) const;

    /// The code without a term: a factor becomes 1, L_e becomes 0, light number `light` is not added.
    /// @return absent likewise
    std::optional<LeftOut> without(EquationTerm term, int light) const;

private:
    glsl::Source expanded() const;
};

} // namespace sr::viewer
