#include "viewer/panels/illuminance.hpp"

#include "gl/object.hpp"
#include "image/colormap.hpp"
#include "viewer/fields.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <functional>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr ImU32 halo = IM_COL32(0, 0, 0, 170);

ImU32 ink_of(vec3 code_values) {
    return ImGui::ColorConvertFloat4ToU32({code_values.r, code_values.g, code_values.b, 1.0f});
}

/// Labels of lines, none of which lies over another.
class Labels {
public:
    Labels(ImDrawList& list, vec2 from, vec2 end) : list_(list), from_(from), end_(end) {}

    /// Draws a label at the first of these places with room for it; absent places are not in the picture.
    void draw(const std::vector<std::optional<vec2>>& places, const std::string& text) {
        const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
        const vec2 half(0.5f * extent.x + 3.0f, 0.5f * extent.y);
        for (const auto& place : places) {
            if (!place) continue;
            const vec2 low = *place - half, high = *place + half;
            const bool is_inside =
                glm::all(glm::greaterThanEqual(low, from_)) && glm::all(glm::lessThanEqual(high, end_));
            const bool is_free = std::ranges::none_of(taken_, [&](const auto& other) {
                return glm::all(glm::lessThan(low, other.second))
                       && glm::all(glm::lessThan(other.first, high));
            });
            if (!is_inside || !is_free) continue;
            taken_.emplace_back(low, high);
            list_.AddRectFilled({low.x, low.y}, {high.x, high.y}, halo, 3.0f);
            return list_.AddText({low.x + 3.0f, low.y}, palette::white, text.c_str());
        }
    }

private:
    ImDrawList& list_;
    vec2 from_, end_; // of the picture
    std::vector<std::pair<vec2, vec2>> taken_;
};

/// Points spread over the longest lines, at which a level can be labelled.
std::vector<vec2> label_points(std::vector<output::Isoline> lines) {
    std::ranges::sort(lines, std::ranges::greater{}, [](const output::Isoline& line) { return line.size(); });
    std::vector<vec2> points;
    for (std::size_t i = 0; i < std::min<std::size_t>(2, lines.size()); ++i)
        for (const double share : {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875})
            if (lines[i].size() >= 6)
                points.push_back(
                    lines[i][static_cast<std::size_t>(share * static_cast<double>(lines[i].size()))]);
    return points;
}

/// A row of the table: a name with its meaning, a value, a place.
void figure(const char* name, const char* meaning, const std::string& value, const std::string& place = {}) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    tooltip(meaning);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
    tooltip(meaning);
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", place.c_str());
    if (!place.empty()) tooltip("the centre of the cell in the file's world: x, y, z [m]");
}

std::string place_text(const output::IlluminanceGrid& grid, output::GridPlace place) {
    const glm::dvec3 at = grid.center(place.column, place.row) + 0.0; // no -0
    return fmt::format("{:.3g}, {:.3g}, {:.3g}", at.x, at.y, at.z);
}

void draw_figures(const MeasuredIlluminance& measured) {
    const output::IlluminanceSummary& summary = measured.summary;
    const output::IlluminanceGrid& grid = measured.grid;
    const auto with_unit = [&](double E) {
        return fmt::format("{:.4g} {}", E, with_superscripts(grid.unit));
    };
    if (ImGui::BeginTable("figures", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) {
        figure("mean", "E_m, the mean of all cells", with_unit(summary.mean));
        figure("min", "the least cell", with_unit(summary.min), place_text(grid, summary.min_place));
        figure("max", "the greatest cell", with_unit(summary.max), place_text(grid, summary.max_place));
        figure("min/mean", "U_o, the uniformity of EN 12464-1, without unit",
               fmt::format("{:.3f}", summary.min_over_mean()));
        figure("min/max", "the diversity, without unit", fmt::format("{:.3f}", summary.min_over_max()));
        ImGui::EndTable();
    }
    const auto cells = static_cast<std::size_t>(grid.columns * grid.rows);
    if (summary.dark_cells == cells) {
        const vec3 n = grid.receiver.normal() + 0.0f; // no -0
        ImGui::TextDisabled("all cells are dark; they face %.3g, %.3g, %.3g", n.x, n.y, n.z);
    } else if (summary.dark_cells > 0) {
        ImGui::TextDisabled("%zu of %zu cells are dark", summary.dark_cells, cells);
    }
    if (summary.dark_cells > 0)
        tooltip(fmt::format("no light reaches them: {}", output::reason_of_dark_cells(grid, summary)));
}

void draw_parts(const MeasuredIlluminance& measured) {
    if (measured.parts.empty()) return;
    ImGui::TextDisabled("mean by light");
    tooltip("the mean over all cells by this light alone; they add up to the mean above");
    if (!ImGui::BeginTable("parts", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) return;
    for (const output::NamedGrid& part : measured.parts) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(part.name.c_str());
        ImGui::TableNextColumn();
        ImGui::Text("%.4g %s", output::summary_of(part.grid).mean, part.grid.unit.c_str());
    }
    ImGui::EndTable();
}

void draw_map_lines(ImDrawList& list, const MeasuredIlluminance& measured, vec2 from, vec2 size) {
    Labels labels(list, from, from + size);
    const auto at = [&](vec2 cell) {
        const vec2 place = measured.place_of(cell);
        return from + size * vec2(place.x, 1.0f - place.y);
    };
    for (const auto& [level, lines] : measured.isolines) {
        const ImU32 ink = level > 0.6 * measured.summary.max ? IM_COL32(20, 20, 20, 255) : palette::white;
        for (const output::Isoline& line : lines) {
            std::vector<ImVec2> points;
            for (const vec2 cell : line) points.emplace_back(at(cell).x, at(cell).y);
            list.AddPolyline(points.data(), static_cast<int>(points.size()), ink, 0, 1.2f);
        }
    }
    for (const auto& [level, lines] : measured.isolines) {
        std::vector<std::optional<vec2>> places;
        for (const vec2 cell : label_points(lines)) places.emplace_back(at(cell));
        labels.draw(places, fmt::format("{:.6g}", level));
    }
}

} // namespace

MeasuredIlluminance::MeasuredIlluminance(output::IlluminanceGrid measured, int count)
    : grid(std::move(measured)), summary(output::summary_of(grid)), samples(count) {
    for (const double level : output::round_levels(summary.min, summary.max, picture::isoline_count))
        isolines.emplace_back(level,
                              output::isolines(
                                  grid.columns, grid.rows,
                                  [this](int column, int row) { return grid.at(column, row); }, level));
}

vec2 MeasuredIlluminance::place_of(vec2 cell) const {
    return {(cell.x + 0.5f) / static_cast<float>(grid.columns),
            1.0f - (cell.y + 0.5f) / static_cast<float>(grid.rows)};
}

std::optional<output::GridPlace> MeasuredIlluminance::cell_at(vec2 place) const {
    if (!(place.x >= 0.0f && place.x < 1.0f && place.y > 0.0f && place.y <= 1.0f)) return std::nullopt;
    return output::GridPlace{static_cast<int>(place.x * static_cast<float>(grid.columns)),
                             static_cast<int>((1.0f - place.y) * static_cast<float>(grid.rows))};
}

std::optional<output::GridPlace> MeasuredIlluminance::cell_on(const PickRay& ray) const {
    const scene::Receiver& receiver = grid.receiver;
    const vec3 n = receiver.normal();
    const float slope = glm::dot(ray.direction, n);
    const float distance = glm::dot(receiver.corner - ray.origin, n) / slope;
    if (!(distance > 0.0f) || !std::isfinite(distance)) return std::nullopt;
    const vec3 offset = ray.origin + distance * ray.direction - receiver.corner;
    return cell_at({glm::dot(offset, receiver.u) / glm::dot(receiver.u, receiver.u),
                    glm::dot(offset, receiver.v) / glm::dot(receiver.v, receiver.v)});
}

vec3 MeasuredIlluminance::color(double E) const {
    return image::colormap(summary.max > 0.0 ? static_cast<float>(E / summary.max) : 0.0f);
}

void IlluminancePanel::upload(const MeasuredIlluminance& measured) {
    const output::IlluminanceGrid& grid = measured.grid;
    std::vector<std::uint8_t> texels;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const glm::ivec3 code(measured.color(grid.at(column, row)) * 255.0f + 0.5f);
            for (int i = 0; i < 3; ++i) texels.push_back(static_cast<std::uint8_t>(code[i]));
            texels.push_back(255);
        }
    map_.emplace(GL_TEXTURE_2D, "illuminance");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, grid.columns, grid.rows, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// Draws the plan. @return the cell under the pointer
std::optional<output::GridPlace> IlluminancePanel::draw_map(const MeasuredIlluminance& measured) {
    if (!map_) upload(measured);
    const scene::Receiver& receiver = measured.grid.receiver;
    const float aspect = glm::length(receiver.u) / glm::length(receiver.v);
    const float room = ImGui::GetContentRegionAvail().x, highest = 0.45f * ImGui::GetWindowHeight();
    const float width = std::max(16.0f, std::min(room, highest * aspect));
    const vec2 size(width, std::max(4.0f, width / aspect));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(map_->id())), {size.x, size.y});
    const bool is_pointed = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const vec2 from(corner.x, corner.y);
    list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
    draw_map_lines(list, measured, from, size);
    list.PopClipRect();
    const ImVec2 pointer = ImGui::GetMousePos();
    const vec2 place = (vec2(pointer.x, pointer.y) - from) / size;
    return is_pointed ? measured.cell_at({place.x, 1.0f - place.y}) : std::nullopt;
}

/// Fields of the plane and its cells.
void IlluminancePanel::draw_choice(IlluminanceChoice& choice, IlluminanceOutcome& outcome) {
    const auto drag = [&](const char* label, double& metres, float least, const char* meaning) {
        auto value = static_cast<float>(metres);
        const bool is_changed = number_field(label, value, {least, 1e6f, "%.2f m", false}, 0.01f);
        tooltip(meaning);
        if (is_changed) metres = std::max(value, least);
        outcome.measures_again |= is_changed;
    };
    ImGui::PushItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    if (!choice.receiver.plane)
        drag("height", choice.receiver.height, -1e6f,
             "of the horizontal plane above the scene's lowest point [m]; a click with Ctrl types a number");
    drag("border", choice.receiver.border, 0.0f, "strip along all edges that is left out [m]");
    outcome.measures_again |=
        ImGui::SliderInt("cells", &choice.cells, 4, 256, "%d", ImGuiSliderFlags_AlwaysClamp);
    tooltip("number of cells along the longer edge of the plane; each is the mean over its area");
    const bool is_entered =
        ImGui::InputTextWithHint("plane", "horizontal", choice.plane.data(), choice.plane.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    outcome.measures_again |= is_entered || ImGui::IsItemDeactivatedAfterEdit();
    tooltip(
        "corner and two perpendicular edges [m]: 0,0.8,0;4,0,0;0,0,-3 (Enter). Light counts on the side that "
        "edge 1 x edge 2 points to. Empty: horizontal, as wide and deep as the scene, lit from above");
    ImGui::PopItemWidth();
    outcome.redraws |= ImGui::Checkbox("over the picture", &choice.is_over_picture);
    tooltip("draw the plane's edges and isolines where they are in the scene, faint behind things");
    const float room =
        ImGui::GetWindowContentRegionMax().x - ImGui::GetItemRectMax().x + ImGui::GetWindowPos().x;
    if (room > 7.0f * ImGui::GetFontSize()) ImGui::SameLine();
    outcome.measures_again |= ImGui::Checkbox("by light", &choice.has_parts);
    tooltip("measure each light alone as well, for the table and the CSV; takes about twice as long");
}

IlluminanceOutcome IlluminancePanel::draw(IlluminanceChoice& choice, const MeasuredIlluminance* measured,
                                          const std::string& progress, const std::string& problem,
                                          std::optional<output::GridPlace> pointed,
                                          const std::optional<Area>& area, const Ui& ui) {
    IlluminanceOutcome outcome;
    if (area)
        place_next_window(*area);
    else
        ImGui::SetNextWindowSize({22.0f * ImGui::GetFontSize(), 0.0f});
    if (ImGui::Begin(side::illuminance, nullptr,
                     ui.panel_flags(area.has_value()) & ~ImGuiWindowFlags_AlwaysAutoResize)) {
        if (area) heading(side::illuminance, ui);
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("%s", in_plain_letters(progress).c_str());
        if (!problem.empty())
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette::orange), "%s",
                               in_plain_letters(problem).c_str());
        ImGui::PopTextWrapPos();
        draw_choice(choice, outcome);
        if (measured) {
            ImGui::Separator();
            if (const auto in_map = draw_map(*measured)) pointed = in_map;
            ImGui::PushTextWrapPos();
            if (pointed)
                ImGui::Text("%.4g %s at %s", measured->grid.at(pointed->column, pointed->row),
                            measured->grid.unit.c_str(), place_text(measured->grid, *pointed).c_str());
            else
                ImGui::TextDisabled("point at the plane for a cell's value");
            ImGui::PopTextWrapPos();
            draw_figures(*measured);
            outcome.writes_csv = ImGui::Button("CSV");
            tooltip(
                "write the place and E of every cell, by light if it was measured, to a file in the working "
                "folder");
            ImGui::SameLine();
            outcome.writes_plan = ImGui::Button("plan");
            tooltip("write the plan with its isolines as an SVG file in the working folder");
            ImGui::SameLine();
        }
        outcome.closes = ImGui::Button("done");
        tooltip("close this panel");
        if (measured) draw_parts(*measured);
    }
    if (!area) keep_in_viewport();
    ImGui::End();
    return outcome;
}

void draw_isolines(const MeasuredIlluminance& measured, const Projection& projection, float scale,
                   const std::function<bool(vec3 point)>& hides) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const scene::Receiver& receiver = measured.grid.receiver;
    const auto segment = [&](vec2 a, vec2 b, ImU32 ink, float width) {
        const auto from = projection(receiver.at(a.x, a.y)), to = projection(receiver.at(b.x, b.y));
        if (!from || !to) return;
        const vec2 middle = 0.5f * (a + b);
        const bool is_hidden = hides(receiver.at(middle.x, middle.y));
        list.AddLine({from->x, from->y}, {to->x, to->y}, is_hidden ? palette::behind(ink) : ink,
                     width * scale);
    };
    const auto edges = [&](ImU32 ink, float width) {
        constexpr std::array<vec2, 5> corners{vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1), vec2(0, 0)};
        constexpr int parts = 60; // each of which is seen, hidden or behind the camera
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            for (int k = 0; k < parts; ++k)
                segment(glm::mix(corners[i], corners[i + 1], static_cast<float>(k) / parts),
                        glm::mix(corners[i], corners[i + 1], static_cast<float>(k + 1) / parts), ink, width);
    };
    edges(halo, 3.0f);
    edges(palette::white, 1.0f);
    for (const auto& [level, lines] : measured.isolines)
        for (const auto& [ink, width] : {std::pair(halo, 3.5f), {ink_of(measured.color(level)), 1.8f}})
            for (const output::Isoline& line : lines)
                for (std::size_t i = 0; i + 1 < line.size(); ++i)
                    segment(measured.place_of(line[i]), measured.place_of(line[i + 1]), ink, width);
    const ImVec2 low = list.GetClipRectMin(), high = list.GetClipRectMax();
    Labels labels(list, {low.x, low.y}, {high.x, high.y});
    for (const auto& [level, lines] : measured.isolines) {
        std::vector<std::optional<vec2>> places;
        for (const vec2 cell : label_points(lines)) {
            const vec2 place = measured.place_of(cell);
            const vec3 point = receiver.at(place.x, place.y);
            places.push_back(hides(point) ? std::nullopt : projection(point));
        }
        labels.draw(places, fmt::format("{:.6g} {}", level, with_superscripts(measured.grid.unit)));
    }
}

} // namespace sr::viewer
