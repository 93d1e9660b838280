#include "golden_mutants/bases.hpp"

#include "core/math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace sr::testing {
namespace {

using image::Image;

/// Dots of a letter, 5 wide and 7 high, and one row below the line.
struct Glyph {
    char letter;
    std::array<std::string_view, 8> rows;
};

constexpr std::array glyphs{
    Glyph{'S', {" ### ", "#   #", "#    ", " ### ", "    #", "#   #", " ### ", "     "}},
    Glyph{'a', {"     ", "     ", " ### ", "    #", " ####", "#   #", " ####", "     "}},
    Glyph{'v', {"     ", "     ", "#   #", "#   #", "#   #", " # # ", "  #  ", "     "}},
    Glyph{'n', {"     ", "     ", "# ## ", "##  #", "#   #", "#   #", "#   #", "     "}},
    Glyph{'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### ", "     "}},
    Glyph{'c', {"     ", "     ", " ### ", "#   #", "#    ", "#   #", " ### ", "     "}},
    Glyph{'o', {"     ", "     ", " ### ", "#   #", "#   #", "#   #", " ### ", "     "}},
    Glyph{'t', {" #   ", " #   ", "###  ", " #   ", " #   ", " #  #", "  ## ", "     "}},
    Glyph{'i', {"  #  ", "     ", " ##  ", "  #  ", "  #  ", "  #  ", " ### ", "     "}},
    Glyph{'l', {" ##  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### ", "     "}},
    Glyph{'g', {"     ", "     ", " ####", "#   #", "#   #", " ####", "    #", " ### "}},
    Glyph{'s', {"     ", "     ", " ####", "#    ", " ### ", "    #", "#### ", "     "}},
    Glyph{'r', {"     ", "     ", "# ## ", "##  #", "#    ", "#    ", "#    ", "     "}},
    Glyph{'m', {"     ", "     ", "## # ", "# # #", "# # #", "# # #", "# # #", "     "}},
    Glyph{'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### ", "     "}},
    Glyph{'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### ", "     "}},
    Glyph{'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### ", "     "}},
    Glyph{'6', {" ### ", "#    ", "#    ", "#### ", "#   #", "#   #", " ### ", "     "}},
    Glyph{'7', {"#####", "    #", "   # ", "  #  ", "  #  ", "  #  ", "  #  ", "     "}},
    Glyph{'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### ", "     "}},
    Glyph{'O', {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### ", "     "}},
    Glyph{'Q', {" ### ", "#   #", "#   #", "#   #", "# # #", "#  # ", " ## #", "     "}},
    Glyph{',', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  ", " #   "}},
    Glyph{'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  ", "     "}},
    Glyph{':', {"     ", " ##  ", " ##  ", "     ", " ##  ", " ##  ", "     ", "     "}}};

bool is_ink(char letter, float x, float y) {
    const auto glyph = std::ranges::find(glyphs, letter, &Glyph::letter);
    if (glyph == glyphs.end() || x < 0.0f || y < 0.0f || x >= 5.0f || y >= 8.0f) return false;
    return glyph->rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
}

void blend(Image& image, int x, int y, vec3 color, float cover) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    for (std::size_t c = 0; c < 3; ++c)
        image.at(x, y)[c] += cover * (color[static_cast<int>(c)] - image.at(x, y)[c]);
}

void put_rectangle(Image& image, int left, int top, int width, int height, vec3 color) {
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x) blend(image, x, y, color, 1.0f);
}

/// Text whose letters are 6 dots apart, with the coverage of 4×4 places in each pixel.
void put_text(Image& image, std::string_view text, int left, int top, vec3 color, const InterfaceBase& o) {
    const int width = static_cast<int>(static_cast<float>(text.size()) * 6.0f * o.text_size) + 1;
    for (int y = 0; y < static_cast<int>(8.0f * o.text_size) + 1; ++y)
        for (int x = 0; x < width; ++x) {
            int covered = 0;
            for (int s = 0; s < 16; ++s) {
                const float u =
                    (static_cast<float>(x) + (static_cast<float>(s % 4) + 0.5f) / 4.0f) / o.text_size;
                const float v =
                    (static_cast<float>(y) + (static_cast<float>(s / 4) + 0.5f) / 4.0f) / o.text_size;
                const auto letter = static_cast<std::size_t>(u / 6.0f);
                covered +=
                    letter < text.size() && is_ink(text[letter], u - 6.0f * static_cast<float>(letter), v);
            }
            const float cover = static_cast<float>(covered) / 16.0f;
            if (covered > 0)
                blend(image, left + x, top + y, color, o.has_antialiasing ? cover : std::round(cover));
        }
}

} // namespace

Image interface_base(Extent size, const InterfaceBase& o) {
    Image image(size.width, size.height, 3);
    image.channel_names = {"R", "G", "B"};
    const vec3 ink(0.1f, 0.1f, 0.13f), paper(0.97f), accent(0.1f, 0.4f, o.button);
    put_rectangle(image, 0, 0, size.width, size.height, paper);
    put_rectangle(image, 0, 0, size.width, 30, vec3(0.2f, 0.22f, 0.26f));
    InterfaceBase smaller = o;
    smaller.text_size = 0.8f * o.text_size;
    put_text(image, o.title, 10, 8, paper, smaller);
    if (o.has_badge) { // a plus of five pixels
        constexpr std::array<std::pair<int, int>, 5> plus{{{0, 1}, {1, 0}, {1, 1}, {1, 2}, {2, 1}}};
        for (const auto& [x, y] : std::span(plus).first(static_cast<std::size_t>(o.badge_pixels)))
            blend(image, size.width - 20 + o.badge_offset + x, 12 + y, vec3(0.9f, 0.2f, 0.2f), 1.0f);
    }
    put_text(image, "Total:", 12, 44, ink, o);
    put_text(image, o.amount, 100, 44, ink, o);
    if (o.has_rule)
        put_rectangle(image, 12, 70 + o.rule_offset, std::min(800, size.width - 24), 1, vec3(0.7f));
    put_rectangle(image, 12, 84, 90 + o.button_growth, 30, accent);
    if (o.has_round_corners)
        for (const auto& [x, y] : {std::pair{12, 84}, {101, 84}, {12, 113}, {101, 113}})
            put_rectangle(image, x, y, 1, 1, paper);
    if (o.has_focus_ring) {
        put_rectangle(image, 9, 81, 96, 1, accent);
        put_rectangle(image, 9, 116, 96, 1, accent);
        put_rectangle(image, 9, 81, 1, 36, accent);
        put_rectangle(image, 104, 81, 1, 36, accent);
    }
    const auto kerned = std::min(static_cast<std::size_t>(o.kerned), o.label.size());
    put_text(image, std::string_view(o.label).substr(0, kerned), 30 + o.label_offset, 91, paper, o);
    put_text(image, std::string_view(o.label).substr(kerned),
             30 + o.label_offset + static_cast<int>(static_cast<float>(kerned) * 6.0f * o.text_size)
                 + (kerned > 0),
             91, paper, o);
    if (o.has_icon)
        for (const auto& [x, y] : {std::pair{0, 2}, {1, 3}, {2, 4}, {3, 3}, {4, 2}, {5, 1}, {6, 0}})
            blend(image, 120 + x, 96 + y, vec3(o.icon, ink.y, ink.z), 1.0f); // a tick, one pixel wide
    put_rectangle(image, 140, 84, size.width - 152, 30, vec3(1.0f));
    if (o.has_caret) put_rectangle(image, 146, 90, 1, 16, ink);
    const float line_size = 1.2f;
    InterfaceBase lines = o;
    lines.text_size = line_size * o.text_size / 2.0f;
    const std::array<std::string_view, 3> words{"settings are not so easy:", o.body,
                                                "areas are stored once."};
    for (int y = 128, line = 0; y < size.height - 16; y += 16, ++line)
        put_text(image, words[static_cast<std::size_t>(line % 3)], 12, y, ink, lines);
    round_to_codes(image);
    return image;
}

} // namespace sr::testing
