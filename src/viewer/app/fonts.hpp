#pragma once
// Fonts of the panels, with Greek letters and superscripts where the system has such a font.
#include <string>

struct ImFont;

namespace sr::viewer {

struct Fonts {
    ImFont* text = nullptr;    // the default
    ImFont* heading = nullptr; // larger
    ImFont* code = nullptr;    // all letters as wide
};

/// Replaces the fonts of Dear ImGui. `scale`: of a HiDPI screen. Without DejaVu Sans on the system they are
/// Dear ImGui's own, which has Latin letters alone.
Fonts load_fonts(float scale);

/// Replaces characters that the current font lacks: "π" by "pi".
std::string in_plain_letters(std::string text);

/// Writes units as people do: "cd/m²" for "cd/m^2".
std::string with_superscripts(std::string text);

} // namespace sr::viewer
