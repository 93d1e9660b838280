#include "viewer/panels/help.hpp"

#include "viewer/ui.hpp"

#include <algorithm>
#include <array>
#include <imgui.h>
#include <span>
#include <string_view>
#include <vector>

namespace sr::viewer {
namespace {

const ImVec4 orange{0.902f, 0.624f, 0.0f, 1.0f}; // Okabe & Ito 2008

void text(const std::string& line) { ImGui::TextUnformatted(with_superscripts(line).c_str()); }

/// A line of the help; a heading if `keys` is empty.
struct HelpLine {
    std::string keys;
    const char* what = "";
    const char* tip = "";
};

std::vector<HelpLine> help_lines(const Keymap& keys) {
    std::vector<HelpLine> lines{{"", "Pointer"}};
    for (const Gesture& gesture : gestures()) lines.push_back({gesture.gesture, gesture.what});
    std::string_view group;
    for (const CommandInfo& command : all_commands()) {
        if (group != command.group) lines.push_back({"", command.group});
        group = command.group;
        lines.push_back({keys.text(command.command), command.name, command.what});
    }
    return lines;
}

/// Width of the keys and of what they do.
float width_of(std::span<const HelpLine> lines) {
    float keys = 0.0f, what = 0.0f;
    for (const HelpLine& line : lines) {
        keys = std::max(keys, ImGui::CalcTextSize(line.keys.c_str()).x);
        if (!line.keys.empty()) what = std::max(what, ImGui::CalcTextSize(line.what).x);
    }
    return keys + what + 4.0f * ImGui::GetStyle().CellPadding.x;
}

void help_cells(const HelpLine& line) {
    ImGui::TableNextColumn();
    if (line.keys.empty())
        ImGui::TextColored(orange, "%s", line.what);
    else
        ImGui::TextUnformatted(line.keys.c_str());
    ImGui::TableNextColumn();
    if (line.keys.empty()) return;
    ImGui::TextUnformatted(line.what);
    if (*line.tip) tooltip(line.tip);
}

/// As many columns as the lines need in `room`, or as fit beside each other.
std::size_t columns_in(ImVec2 room, std::span<const HelpLine> lines) {
    const float row = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    const float margin = 4.0f * ImGui::GetFontSize(); // title, frame, scrollbar
    const auto rows_in_room = static_cast<std::size_t>(std::max(1.0f, (room.y - margin) / row));
    for (std::size_t columns = (lines.size() + rows_in_room - 1) / rows_in_room; columns > 1; --columns) {
        const std::size_t rows = (lines.size() + columns - 1) / columns;
        float width = margin;
        for (std::size_t i = 0; i < lines.size(); i += rows)
            width += width_of(lines.subspan(i, std::min(rows, lines.size() - i)));
        if (width <= room.x) return columns;
    }
    return 1;
}

/// Draws lines in so many columns, from top to bottom.
void help_table(const std::vector<HelpLine>& lines, std::size_t columns) {
    const std::size_t rows = (lines.size() + columns - 1) / columns;
    if (!ImGui::BeginTable("keys", 2 * static_cast<int>(columns), ImGuiTableFlags_SizingFixedFit)) return;
    for (std::size_t row = 0; row < rows; ++row) {
        ImGui::TableNextRow();
        for (std::size_t i = row; i < lines.size(); i += rows) help_cells(lines[i]);
    }
    ImGui::EndTable();
}

} // namespace

void message_area(const Status& status, Layout& layout) {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const ImVec2 padding{6.0f, 2.0f};
    const float width = viewport.Size.x - 2.0f * padding.x, gap = 3.0f * ImGui::GetFontSize();
    const auto size = [&](const std::string& part) {
        return ImGui::CalcTextSize(part.c_str(), nullptr, false, width);
    };
    const std::array parts{&status.progress, &status.under_pointer, &status.message};
    std::array<bool, 3> begins_line{true, false, false};
    float x = 0.0f, height = 2.0f * padding.y;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i]->empty()) continue;
        const ImVec2 needed = size(*parts[i]);
        begins_line[i] = x == 0.0f || x + gap + needed.x > width || needed.y > ImGui::GetTextLineHeight();
        if (begins_line[i]) height += needed.y + (x == 0.0f ? 0.0f : ImGui::GetStyle().ItemSpacing.y);
        x = begins_line[i] ? needed.x : x + gap + needed.x;
    }
    height = std::min(std::max(height, ImGui::GetFrameHeight()), 0.4f * viewport.Size.y);
    const float two_lines = 2.0f * ImGui::GetTextLineHeightWithSpacing() + 2.0f * padding.y;
    place_next_window(layout.take_bottom(height, layout.is_docked() ? two_lines : 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
                     | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PushTextWrapPos();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i]->empty()) continue;
        if (!begins_line[i]) ImGui::SameLine(0.0f, gap);
        text(*parts[i]);
    }
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void history_panel(bool& is_open, const std::vector<std::string>& messages) {
    if (!is_open) return;
    const ImVec2 size = ImGui::GetMainViewport()->Size;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({0.8f * size.x, 0.6f * size.y});
    ImGui::Begin("Messages (M closes)", &is_open,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    ImGui::PushTextWrapPos();
    for (const std::string& message : messages) text(message);
    ImGui::PopTextWrapPos();
    if (ImGui::IsWindowAppearing()) ImGui::SetScrollHereY(1.0f);
    ImGui::End();
}

void help_panel(bool& is_open, const Keymap& keys) {
    if (!is_open) return;
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const ImVec2 room{0.96f * viewport.Size.x, 0.92f * viewport.Size.y};
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, room);
    ImGui::Begin("Keys (Esc closes)", &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    const std::vector<HelpLine> lines = help_lines(keys);
    help_table(lines, columns_in(room, lines));
    ImGui::End();
}

void error_panel(const std::string& title, const std::string& message) {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({viewport.GetCenter().x, viewport.Pos.y + 12.0f}, ImGuiCond_Always, {0.5f, 0.0f});
    ImGui::SetNextWindowSize({0.9f * viewport.Size.x, 0.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.15f, 0.07f, 0.0f, 0.94f});
    ImGui::Begin("error", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings
                     | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::TextColored(orange, "%s", title.c_str());
    ImGui::PushTextWrapPos();
    text(message);
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleColor();
}

} // namespace sr::viewer
