#include "viewer/panels/legend.hpp"

#include "core/math.hpp"
#include "viewer/app/fonts.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

constexpr int steps = 64; // of the bar

/// Colours of the bar from left to right, and labels at places from 0 to 1.
struct ColorBar {
    std::vector<vec3> colors; // code values; empty: no bar
    std::vector<std::pair<float, std::string>> labels;
};

float between(float first, float last, int step) {
    return first + (last - first) * static_cast<float>(step) / static_cast<float>(steps - 1);
}

/// Labels the whole decades of a range.
void label_decades(ColorBar& bar, float first, float last) {
    const int stride = std::max(1, static_cast<int>(std::ceil((last - first) / 5.0f)));
    for (int k = static_cast<int>(std::ceil(first)); static_cast<float>(k) <= last; k += stride)
        bar.labels.emplace_back((static_cast<float>(k) - first) / (last - first),
                                fmt::format("{:g}", std::pow(10.0, k)));
}

ColorBar bar_of(const output::Variable& view, const DisplaySettings& display) {
    using output::Display;
    ColorBar bar;
    if (view.display == Display::share) {
        for (int i = 0; i < steps; ++i) bar.colors.emplace_back(image::srgb_encoded(between(0.0f, 1.0f, i)));
        bar.labels = {{0.0f, "0"}, {0.5f, "0.5"}, {1.0f, "1"}};
    } else if (view.display == Display::false_color) {
        for (int i = 0; i < steps; ++i) bar.colors.push_back(image::colormap(between(0.0f, 1.0f, i)));
        label_decades(bar, display.decades.first, display.decades.last);
    } else if (view.display == Display::count) {
        const image::Decades& range = output::count_decades;
        for (int i = 0; i < steps; ++i) bar.colors.push_back(image::colormap(between(0.0f, 1.0f, i)));
        for (int n = 1; n <= 32; n *= 2)
            bar.labels.emplace_back((std::log10(static_cast<float>(n)) - range.first)
                                        / (range.last - range.first),
                                    std::to_string(n));
    } else if (view.display == Display::exposed) {
        // Greys around the value that is exposed as 1.
        const float white = -std::log10(image::exposure_factor(display.ev100));
        const float first = white - 2.5f, last = white + 0.5f;
        image::Image greys(steps, 1, 3);
        for (int i = 0; i < steps; ++i)
            std::ranges::fill(greys.at(i, 0), std::pow(10.0f, between(first, last, i)));
        greys = image::displayed(greys, display.ev100, *display.curve);
        for (int i = 0; i < steps; ++i)
            bar.colors.emplace_back(greys.at(i, 0)[0], greys.at(i, 0)[1], greys.at(i, 0)[2]);
        label_decades(bar, first, last);
    }
    return bar;
}

void draw_bar(ImDrawList& list, const ColorBar& bar, ImVec2 from, ImVec2 size) {
    const auto code = [](vec3 c) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1.0f}); };
    const float step = size.x / static_cast<float>(bar.colors.size());
    for (std::size_t i = 0; i < bar.colors.size(); ++i) {
        const float x = from.x + step * static_cast<float>(i);
        list.AddRectFilled({x, from.y}, {x + step + 1.0f, from.y + size.y}, code(bar.colors[i]));
    }
    for (const auto& [place, label] : bar.labels) {
        const float x = from.x + place * size.x, width = ImGui::CalcTextSize(label.c_str()).x;
        const float left = std::clamp(x - 0.5f * width, from.x, from.x + size.x - width);
        list.AddLine({x, from.y + size.y}, {x, from.y + size.y + 3.0f}, palette::white);
        list.AddText({left, from.y + size.y + 3.0f}, palette::white, label.c_str());
    }
}

} // namespace

void draw_legend(const Area& picture, const output::Variable& view, const DisplaySettings& display,
                 const std::string& unit, float scale) {
    const float margin = 10.0f * scale, line = ImGui::GetTextLineHeight();
    const float width = std::min(300.0f * scale, picture.size.x - 4.0f * margin);
    const ColorBar bar = bar_of(view, display);
    const std::string text =
        in_plain_letters(with_superscripts(fmt::format("{} [{}]: {}", view.name, unit, view.what)));
    const ImVec2 title = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
    const float bar_height = bar.colors.empty() ? 0.0f : 2.0f * line + 8.0f * scale;
    const float height = title.y + bar_height + margin;
    const ImVec2 from{picture.from.x + margin, picture.from.y + picture.size.y - height - margin};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(from, {from.x + width + margin, from.y + height}, IM_COL32(0, 0, 0, 190),
                       4.0f * scale);
    const ImVec2 inside{from.x + 0.5f * margin, from.y + 0.5f * margin};
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), inside, palette::white, text.c_str(), nullptr,
                 width);
    if (!bar.colors.empty())
        draw_bar(list, bar, {inside.x, inside.y + title.y + 4.0f * scale}, {width, line});
}

std::optional<image::Decades> range_of(const image::Image& film) {
    std::vector<float> lit;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const auto pixel = film.at(x, y);
            const float Y = luminance(pixel[0], pixel[1], pixel[2]);
            if (std::isfinite(Y) && Y > 0.0f) lit.push_back(std::log10(Y));
        }
    if (lit.empty()) return std::nullopt;
    const auto quantile = [&](double share) {
        const auto at =
            lit.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(lit.size() - 1));
        std::ranges::nth_element(lit, at);
        return *at;
    };
    constexpr float tenths = 10.0f, narrowest = 0.5f; // [decades]
    image::Decades range{std::floor(tenths * quantile(0.01)) / tenths,
                         std::ceil(tenths * quantile(0.99)) / tenths};
    range.last = std::max(range.last, range.first + narrowest);
    return range;
}

} // namespace sr::viewer
