#include "output/illuminance_plan.hpp"

#include "core/markup.hpp"
#include "image/colormap.hpp"
#include "output/isolines.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::output {
namespace {

constexpr double longer_side = 720.0; // of the map [px]
constexpr double left = 64.0, top = 74.0, right = 120.0, bottom = 56.0;

std::string hex(vec3 code_values) {
    const glm::ivec3 c(code_values * 255.0f + 0.5f);
    return fmt::format("#{:02x}{:02x}{:02x}", c.x, c.y, c.z);
}

/// Draws a grid; lengths in pixels, the map's upper left corner at (left, top).
class Plan {
public:
    explicit Plan(const IlluminanceGrid& grid)
        : grid_(grid),
          summary_(summary_of(grid)),
          metres_(glm::length(grid.receiver.u), glm::length(grid.receiver.v)),
          scale_(longer_side / std::max(metres_.x, metres_.y)),
          width_(metres_.x * scale_),
          height_(metres_.y * scale_) {}

    std::string svg(const std::vector<double>& levels, const std::vector<PlanMark>& marks,
                    const std::string& title) {
        const double whole_width = left + std::max(width_, 420.0) + right;
        const double whole_height = top + std::max(height_, 160.0) + bottom;
        text_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" "
            "height=\"{:.0f}\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" font-size=\"12\">\n"
            "<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
            whole_width, whole_height, whole_width, whole_height, escape_markup(title));
        add_heading(title);
        add_cells();
        for (const double level : levels) add_isolines(level);
        for (const PlanMark& mark : marks) add_mark(mark);
        add_rulers();
        add_legend(levels);
        return text_ + "</svg>\n";
    }

private:
    vec3 color(double E) const {
        return image::colormap(summary_.max > 0.0 ? static_cast<float>(E / summary_.max) : 0.0f);
    }

    void add_text(double x, double y, std::string_view anchor, const std::string& text,
                  std::string_view attributes = "") {
        text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y,
                             anchor, attributes, escape_markup(text));
    }

    void add_heading(const std::string& title) {
        add_text(left, 28, "start", title, "font-size=\"16\" font-weight=\"600\"");
        add_text(left, 50, "start",
                 fmt::format("mean {:.4g} {}   min {:.4g}   max {:.4g}   min/mean {:.2f}   min/max {:.2f}",
                             summary_.mean, grid_.unit, summary_.min, summary_.max, summary_.min_over_mean(),
                             summary_.min_over_max()),
                 "fill=\"#444\" xml:space=\"preserve\"");
    }

    void add_cells() {
        const double w = width_ / grid_.columns, h = height_ / grid_.rows;
        text_ += "<g shape-rendering=\"crispEdges\">\n";
        for (int row = 0; row < grid_.rows; ++row)
            for (int column = 0; column < grid_.columns; ++column) {
                const double E = grid_.at(column, row);
                text_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                                     "fill=\"{}\"/>\n",
                                     left + column * w, top + row * h, w, h, hex(color(E)));
            }
        text_ += "</g>\n";
    }

    /// A cell's centre, or any place between centres, in the picture.
    glm::dvec2 place(vec2 cell) const {
        return {left + (cell.x + 0.5) * width_ / grid_.columns, top + (cell.y + 0.5) * height_ / grid_.rows};
    }

    void add_isolines(double level) {
        const auto lines = isolines(
            grid_.columns, grid_.rows, [this](int x, int y) { return grid_.at(x, y); }, level);
        const std::string_view ink = level > 0.6 * summary_.max ? "#222" : "#fff";
        for (const Isoline& line : lines) {
            text_ += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\" points=\"", ink);
            for (const vec2 point : line)
                text_ += fmt::format("{:.1f},{:.1f} ", place(point).x, place(point).y);
            text_ += "\"/>\n";
        }
        const auto longest = std::ranges::max_element(
            lines, [](const Isoline& a, const Isoline& b) { return a.size() < b.size(); });
        if (longest == lines.end() || longest->size() < 6) return; // no room for a label
        const glm::dvec2 middle = place((*longest)[longest->size() / 2]);
        add_text(std::clamp(middle.x, left + 16, left + width_ - 16),
                 std::clamp(middle.y + 4, top + 12, top + height_ - 4), "middle",
                 fmt::format("{:.6g}", level),
                 fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"3\" paint-order=\"stroke\" "
                             "stroke-linejoin=\"round\"",
                             ink, hex(color(level))));
    }

    void add_mark(const PlanMark& mark) {
        text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"none\" stroke=\"#f33\" "
                             "stroke-width=\"2\"><title>{}</title></circle>\n",
                             left + mark.place.x * width_, top + (1.0 - mark.place.y) * height_,
                             escape_markup(mark.name));
    }

    void add_rulers() {
        text_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
                             "stroke=\"#444\"/>\n",
                             left, top, width_, height_);
        const auto ticks = [](double length) {
            std::vector<double> at = round_levels(0.0, length, 8);
            at.insert(at.begin(), 0.0);
            return at;
        };
        for (const double x : ticks(metres_.x))
            add_text(left + x * scale_, top + height_ + 18, "middle", fmt::format("{:.6g}", x));
        for (const double y : ticks(metres_.y))
            add_text(left - 8, top + height_ - y * scale_ + 4, "end", fmt::format("{:.6g}", y));
        add_text(left + width_ / 2.0, top + height_ + 38, "middle", "metres along u", "fill=\"#444\"");
        add_text(16, top + height_ / 2.0, "middle", "metres along v",
                 fmt::format("fill=\"#444\" transform=\"rotate(-90 16 {:.1f})\"", top + height_ / 2.0));
    }

    void add_legend(const std::vector<double>& levels) {
        constexpr int steps = 64;
        constexpr double bar = 16.0;
        const double x = left + width_ + 24, height = std::max(height_, 160.0);
        for (int i = 0; i < steps; ++i)
            text_ +=
                fmt::format("<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                            x, top + height * (1.0 - (i + 1.0) / steps), bar, height / steps + 0.5,
                            hex(image::colormap((static_cast<float>(i) + 0.5f) / steps)));
        add_text(x, top - 8, "start", grid_.unit, "fill=\"#444\"");
        add_text(x + bar + 6, top + height, "start", "0");
        constexpr double line_height = 13.0; // nearer to one another, labels would overlap
        double above = top + height;
        for (const double level : levels) {
            const double y = top + height * (1.0 - level / summary_.max) + 4;
            if (level <= 0.0 || above - y < line_height || y - (top + 4) < line_height) continue;
            add_text(x + bar + 6, y, "start", fmt::format("{:.6g}", level));
            above = y;
        }
        add_text(x + bar + 6, top + 4, "start", fmt::format("{:.4g}", summary_.max));
    }

    const IlluminanceGrid& grid_;
    IlluminanceSummary summary_;
    glm::dvec2 metres_;
    double scale_; // pixels a metre
    double width_;
    double height_;
    std::string text_;
};

} // namespace

std::string plan_svg(const IlluminanceGrid& grid, const std::vector<double>& levels,
                     const std::vector<PlanMark>& marks, const std::string& title) {
    return Plan(grid).svg(levels, marks, title);
}

} // namespace sr::output
