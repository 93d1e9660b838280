#include "viewer/panels/pixels.hpp"

#include "image/display.hpp"
#include "output/variables.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr float min_numbered_side = 44.0f; // of a pixel with numbers in it [pixels, before scaling]
constexpr std::array channel_colors{IM_COL32(255, 110, 110, 255), IM_COL32(120, 220, 120, 255),
                                    IM_COL32(130, 170, 255, 255)};

ImVec2 point(vec2 at) { return {at.x, at.y}; }

/// The pixel as the screen shows it.
ImU32 color_of(const ShownFilm& film, glm::ivec2 pixel) {
    const auto from = film.numbers.at(pixel.x, pixel.y);
    image::Image one(1, 1, 4);
    std::copy_n(from.begin(), std::min<std::size_t>(4, from.size()), one.pixels.begin());
    if (from.size() < 4) one.pixels[3] = 1.0f;
    const output::Variable* const view = film.display.view;
    const bool is_exposed = !view || view->display == output::Display::exposed;
    const image::Image shown = is_exposed ? image::displayed(one, film.display.ev100, *film.display.curve)
                                          : output::colors_of(*view, one);
    return ImGui::ColorConvertFloat4ToU32({shown.pixels[0], shown.pixels[1], shown.pixels[2], 1.0f});
}

std::string short_text(float value) {
    if (!std::isfinite(value)) return std::isnan(value) ? "nan" : "inf";
    const float size = std::abs(value);
    return size != 0.0f && (size < 0.001f || size >= 100000.0f) ? fmt::format("{:.1e}", value)
           : size < 10.0f                                       ? fmt::format("{:.3f}", value)
           : size < 1000.0f                                     ? fmt::format("{:.1f}", value)
                                                                : fmt::format("{:.0f}", value);
}

void draw_loupe(const ShownFilm& film, const std::optional<glm::ivec2>& pointed) {
    constexpr int reach = 5; // pixels on each side of the middle
    const float room = 0.55f * ImGui::GetContentRegionAvail().x;
    const float side = std::floor(std::min(12.0f * film.scale, room / (2 * reach + 1)));
    const float all = side * (2 * reach + 1);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::Dummy({all, all});
    tooltip("the pixels around the pointer");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + all, from.y + all}, IM_COL32(30, 30, 32, 255));
    if (!pointed) return;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const glm::ivec2 pixel = *pointed + glm::ivec2(x, y);
            if (pixel.x < 0 || pixel.y < 0 || pixel.x >= film.numbers.width || pixel.y >= film.numbers.height)
                continue;
            const ImVec2 at{from.x + side * static_cast<float>(x + reach),
                            from.y + side * static_cast<float>(y + reach)};
            list.AddRectFilled(at, {at.x + side, at.y + side}, color_of(film, pixel));
        }
    const ImVec2 middle{from.x + side * reach, from.y + side * reach};
    list.AddRect(middle, {middle.x + side, middle.y + side}, palette::orange, 0.0f, 0, 2.0f);
}

/// Lines of a pixel's place and values beside the loupe.
void draw_pointed(const ShownFilm& film, const std::optional<glm::ivec2>& pointed) {
    ImGui::BeginGroup();
    if (pointed) {
        const auto p = film.numbers.at(pointed->x, pointed->y);
        ImGui::Text("%d, %d", pointed->x, pointed->y);
        constexpr std::array names{"R", "G", "B"};
        for (std::size_t i = 0; i < names.size(); ++i)
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(channel_colors[i]), "%s %.6g", names[i],
                               static_cast<double>(p[i]));
        ImGui::Text("Y %.6g", static_cast<double>(luminance(p[0], p[1], p[2])));
        ImGui::TextDisabled("%s", film.unit.c_str());
    } else {
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("point at the picture");
        ImGui::PopTextWrapPos();
    }
    ImGui::EndGroup();
}

void draw_histogram(const PixelStatistics& statistics) {
    std::array<float, PixelStatistics::bins> heights{};
    std::ranges::transform(statistics.histogram, heights.begin(), [](std::size_t n) {
        return std::sqrt(static_cast<float>(n)); // few bright pixels are seen, too
    });
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PlotHistogram("##histogram", heights.data(), static_cast<int>(heights.size()), 0, nullptr, 0.0f,
                         std::max(1.0f, *std::ranges::max_element(heights)),
                         {width, 5.0f * ImGui::GetTextLineHeight()});
    tooltip("pixels by luminance, on a logarithmic axis; heights are square roots of their numbers");
    ImGui::TextDisabled("1e%g", statistics.first);
    const std::string last = fmt::format("1e{}", statistics.last);
    ImGui::SameLine(width - ImGui::CalcTextSize(last.c_str()).x);
    ImGui::TextDisabled("%s", last.c_str());
}

void draw_table(const PixelStatistics& statistics, const std::string& unit) {
    if (!ImGui::BeginTable("statistics", 4)) return;
    for (const char* head : {"", "min", "mean", "max"}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", head);
        if (*head) tooltip(fmt::format("{} of these pixels [{}]", head, unit));
    }
    constexpr std::array names{"R", "G", "B", "Y"};
    for (int i = 0; i < 4; ++i) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(names[static_cast<std::size_t>(i)]);
        tooltip(i < 3 ? "linear, primaries of Rec. 709" : "luminance");
        for (const double value : {statistics.min[i], statistics.mean[i], statistics.max[i]}) {
            ImGui::TableNextColumn();
            ImGui::Text("%.4g", value);
        }
    }
    ImGui::EndTable();
}

std::optional<std::size_t> draw_pinned(const ShownFilm& film, const std::vector<glm::ivec2>& pinned,
                                       const Keymap& keys) {
    std::optional<std::size_t> unpinned;
    for (std::size_t i = 0; i < pinned.size(); ++i) {
        const glm::ivec2 at = pinned[i];
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton("x")) unpinned = i;
        tooltip("remove this pixel from the list");
        ImGui::SameLine();
        if (at.x < film.numbers.width && at.y < film.numbers.height) {
            const auto p = film.numbers.at(at.x, at.y);
            ImGui::Text("%zu  %d, %d: %.4g %.4g %.4g, Y %.4g", i + 1, at.x, at.y, static_cast<double>(p[0]),
                        static_cast<double>(p[1]), static_cast<double>(p[2]),
                        static_cast<double>(luminance(p[0], p[1], p[2])));
        } else {
            ImGui::TextDisabled("%zu  %d, %d: outside of the picture", i + 1, at.x, at.y);
        }
        ImGui::PopID();
    }
    if (pinned.empty())
        ImGui::TextDisabled("%s", keys.hint("point at a pixel to pin it", Command::pin_pixel).c_str());
    return unpinned;
}

} // namespace

std::optional<glm::ivec2> ShownFilm::pixel_at(vec2 at) const {
    if (!shown.contains(at)) return std::nullopt;
    const glm::ivec2 pixel =
        glm::floor((at - picture.from) / picture.size * vec2(numbers.width, numbers.height));
    return glm::clamp(pixel, glm::ivec2(0), glm::ivec2(numbers.width - 1, numbers.height - 1));
}

Area ShownFilm::area_of(glm::ivec2 pixel) const {
    const vec2 side = picture.size / vec2(numbers.width, numbers.height);
    return {picture.from + side * vec2(pixel), side};
}

PixelsOutcome draw_pixels_panel(const ShownFilm& film, const std::optional<PixelRectangle>& rectangle,
                                const PixelStatistics& statistics, const std::vector<glm::ivec2>& pinned,
                                const std::optional<glm::ivec2>& pointed, const std::optional<Area>& area,
                                const Ui& ui, const Keymap& keys) {
    PixelsOutcome outcome;
    if (area)
        place_next_window(*area);
    else
        ImGui::SetNextWindowSize({22.0f * ImGui::GetFontSize(), 0.0f});
    if (ImGui::Begin(side::pixels, nullptr,
                     ui.panel_flags(area.has_value()) & ~ImGuiWindowFlags_AlwaysAutoResize)) {
        if (area) heading(side::pixels, ui);
        ImGui::TextDisabled("of %s", film.source.c_str());
        draw_loupe(film, pointed);
        ImGui::SameLine();
        draw_pointed(film, pointed);
        ImGui::Separator();
        const glm::ivec2 size = rectangle ? rectangle->end - rectangle->from
                                          : glm::ivec2(film.numbers.width, film.numbers.height);
        ImGui::Text("%s, %d x %d pixels", rectangle ? "the rectangle" : "the picture", size.x, size.y);
        tooltip("a Shift drag over the picture chooses a rectangle");
        if (rectangle) {
            ImGui::SameLine();
            outcome.drops_rectangle = ImGui::SmallButton("whole picture");
            tooltip("statistics of all pixels again");
        }
        draw_table(statistics, film.unit);
        ImGui::Text("deviation of Y %.4g %s", statistics.deviation, film.unit.c_str());
        tooltip("the standard deviation of luminance among these pixels: noise, and what is to be seen");
        if (statistics.not_finite > 0)
            ImGui::TextColored({0.9f, 0.4f, 0.0f, 1.0f}, "%zu pixels are not finite", statistics.not_finite);
        draw_histogram(statistics);
        ImGui::Separator();
        outcome.unpinned = draw_pinned(film, pinned, keys);
        ImGui::Spacing();
        outcome.closes = ImGui::Button("done");
        tooltip(keys.hint("close this panel", Command::pixels));
    }
    if (!area) keep_in_viewport();
    ImGui::End();
    return outcome;
}

void draw_pixel_numbers(const ShownFilm& film) {
    const float side = film.area_of({0, 0}).size.x;
    if (side < min_numbered_side * film.scale) return;
    const auto first = film.pixel_at(film.shown.from + 0.5f);
    const auto last = film.pixel_at(film.shown.from + film.shown.size - 1.0f);
    if (!first || !last) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float font = std::min(ImGui::GetFontSize(), 0.27f * side);
    for (int y = first->y; y <= last->y; ++y)
        for (int x = first->x; x <= last->x; ++x) {
            const Area area = film.area_of({x, y});
            const auto p = film.numbers.at(x, y);
            for (std::size_t i = 0; i < 3; ++i) {
                const std::string text = short_text(p[i]);
                const float width = ImGui::CalcTextSize(text.c_str()).x * font / ImGui::GetFontSize();
                const vec2 at =
                    area.from + vec2(0.5f * (side - width), (0.08f + 0.29f * static_cast<float>(i)) * side);
                list.AddText(ImGui::GetFont(), font, point(at + 1.0f), IM_COL32(0, 0, 0, 220), text.c_str());
                list.AddText(ImGui::GetFont(), font, point(at), channel_colors[i], text.c_str());
            }
        }
}

void draw_pixel_marks(const ShownFilm& film, const std::optional<PixelRectangle>& rectangle,
                      const std::vector<glm::ivec2>& pinned) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    if (rectangle) {
        const Area first = film.area_of(rectangle->from), end = film.area_of(rectangle->end);
        list.AddRect(point(first.from), point(end.from), palette::white, 0.0f, 0, 1.5f * film.scale);
    }
    for (std::size_t i = 0; i < pinned.size(); ++i) {
        const Area area = film.area_of(pinned[i]);
        const vec2 middle = area.from + 0.5f * area.size;
        const float reach = std::max(5.0f * film.scale, 0.5f * area.size.x);
        list.AddRect(point(middle - reach), point(middle + reach), palette::orange, 0.0f, 0,
                     1.5f * film.scale);
        const std::string label = std::to_string(i + 1);
        list.AddText({middle.x + reach + 2.0f, middle.y - reach}, palette::orange, label.c_str());
    }
}

} // namespace sr::viewer
