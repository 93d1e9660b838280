#include "viewer/app/fonts.hpp"

#include <array>
#include <filesystem>
#include <imgui.h>
#include <string_view>
#include <utility>

namespace sr::viewer {
namespace {

constexpr float text_size = 14.0f; // [pixels], before scaling
constexpr float heading_size = 18.0f;
constexpr float code_size = 13.0f;
constexpr float own_size = 13.0f; // that Dear ImGui's own font is drawn for

/// Path of a font on Debian, Fedora, Arch, openSUSE and macOS; empty if there is none.
std::string font_file(const std::string& name) {
    for (const char* const folder :
         {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu-sans-fonts/",
          "/usr/share/fonts/dejavu-sans-mono-fonts/", "/usr/share/fonts/TTF/", "/usr/share/fonts/dejavu/",
          "/opt/homebrew/share/fonts/"}) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(folder + name, ignored)) return folder + name;
    }
    return {};
}

/// Latin, Greek, punctuation, super- and subscripts, arrows, mathematical signs, triangles.
constexpr std::array<ImWchar, 19> letters{0x20,   0x17f,  0x370,  0x3ff,  0x1d62, 0x1d65, 0x2010,
                                          0x2033, 0x2070, 0x209c, 0x2190, 0x2193, 0x2200, 0x2265,
                                          0x22c5, 0x22c5, 0x25a0, 0x25cf, 0};

} // namespace

Fonts load_fonts(float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const auto font = [&](const std::string& file, float size) {
        ImFontConfig config;
        config.OversampleH = config.OversampleV = 2;
        config.PixelSnapH = true;
        config.SizePixels = own_size / text_size * size * scale;
        return file.empty() ? atlas.AddFontDefault(&config)
                            : atlas.AddFontFromFileTTF(file.c_str(), size * scale, &config, letters.data());
    };
    const std::string sans = font_file("DejaVuSans.ttf");
    return {font(sans, text_size), font(sans, heading_size),
            font(font_file("DejaVuSansMono.ttf"), code_size)};
}

std::string in_plain_letters(std::string text) {
    constexpr std::array<std::pair<const char*, const char*>, 43> spellings{
        {{"α", "alpha"}, {"β", "beta"},   {"γ", "gamma"}, {"δ", "delta"},     {"ε", "epsilon"}, {"η", "eta"},
         {"θ", "theta"}, {"λ", "lambda"}, {"μ", "mu"},    {"ν", "nu"},        {"π", "pi"},      {"ρ", "rho"},
         {"σ", "sigma"}, {"τ", "tau"},    {"φ", "phi"},   {"χ", "chi"},       {"ω", "omega"},   {"Σ", "sum "},
         {"∑", "sum "},  {"Φ", "Phi"},    {"Ω", "Omega"}, {"∫", "integral "}, {"√", "sqrt"},    {"≤", "<="},
         {"≥", ">="},    {"≠", "!="},     {"≈", "~"},     {"∞", "infinity"},  {"−", "-"},       {"⁻", "^-"},
         {"⁴", "^4"},    {"⁵", "^5"},     {"→", "->"},    {"…", "..."},       {"“", "\""},      {"”", "\""},
         {"’", "'"},     {"–", "-"},      {"ᵢ", "_i"},    {"ᵣ", "_r"},        {"ₒ", "_o"},      {"ₑ", "_e"},
         {"Θ", "Theta"}}};
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    constexpr ImWchar theta = 0x3b8;
    if (!fonts.empty() && fonts.front()->FindGlyphNoFallback(theta)) return text;
    for (const auto& [sign, spelling] : spellings)
        for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos;)
            text.replace(at, std::string_view(sign).size(), spelling);
    return text;
}

std::string with_superscripts(std::string text) {
    for (std::size_t at = 0; (at = text.find("^2", at)) != std::string::npos;) text.replace(at, 2, "²");
    return text;
}

} // namespace sr::viewer
