#pragma once
// Colours of overlays, which all kinds of colour vision can distinguish (Okabe & Ito 2008).
#include <array>
#include <imgui.h>

namespace sr::viewer::palette {

inline constexpr ImU32 blue = IM_COL32(86, 180, 233, 255);
inline constexpr ImU32 orange = IM_COL32(230, 159, 0, 255);
inline constexpr ImU32 green = IM_COL32(0, 158, 115, 255);
inline constexpr ImU32 vermilion = IM_COL32(213, 94, 0, 255);
inline constexpr ImU32 white = IM_COL32(235, 235, 235, 255);
inline constexpr ImU32 grey = IM_COL32(150, 150, 150, 255);

/// The colour of a line that lies behind a surface.
constexpr ImU32 behind(ImU32 ink) {
    return (ink & ~IM_COL32_A_MASK) | ((ink >> IM_COL32_A_SHIFT) / 4) << IM_COL32_A_SHIFT;
}

/// Of the axes X, Y, Z.
inline constexpr std::array axes{vermilion, green, blue};

} // namespace sr::viewer::palette
