#include "viewer/panels/help.hpp"

#include "viewer/bindings.hpp"

#include <algorithm>
#include <array>
#include <imgui.h>
#include <string_view>
#include <vector>

namespace sr::viewer {
namespace {

const ImVec4 orange{0.902f, 0.624f, 0.0f, 1.0f}; // Okabe & Ito 2008

void text(const std::string& line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }

/// A line of the help; a heading if `keys` is empty.
struct HelpLine {
    const char* keys = "";
    const char* what = "";
};

std::vector<HelpLine> help_lines() {
    std::vector<HelpLine> lines{{"", "Pointer"}};
    for (const Gesture& gesture : gestures()) lines.push_back({gesture.gesture, gesture.what});
    std::string_view group;
    for (const Binding& binding : bindings()) {
        if (!*binding.what) continue;
        if (group != binding.group) lines.push_back({"", binding.group});
        group = binding.group;
        lines.push_back({binding.keys, binding.what});
    }
    return lines;
}

/// Width of the keys and of what they do.
float width_of(const std::vector<HelpLine>& lines) {
    float keys = 0.0f, what = 0.0f;
    for (const HelpLine& line : lines) {
        keys = std::max(keys, ImGui::CalcTextSize(line.keys).x);
        if (*line.keys) what = std::max(what, ImGui::CalcTextSize(line.what).x);
    }
    return keys + what + 2.0f * ImGui::GetStyle().CellPadding.x;
}

void help_cells(const HelpLine& line) {
    ImGui::TableNextColumn();
    if (!*line.keys)
        ImGui::TextColored(orange, "%s", line.what);
    else
        ImGui::TextUnformatted(line.keys);
    ImGui::TableNextColumn();
    if (*line.keys) ImGui::TextUnformatted(line.what);
}

} // namespace

void message_area(const Status& status) {
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
        begins_line[i] = i == 0 || x + gap + needed.x > width || needed.y > ImGui::GetTextLineHeight();
        if (begins_line[i]) height += needed.y + (i == 0 ? 0.0f : ImGui::GetStyle().ItemSpacing.y);
        x = begins_line[i] ? needed.x : x + gap + needed.x;
    }
    height = std::min(std::max(height, ImGui::GetFrameHeight()), 0.4f * viewport.Size.y);
    ImGui::SetNextWindowPos({viewport.Pos.x, viewport.Pos.y + viewport.Size.y - height});
    ImGui::SetNextWindowSize({viewport.Size.x, height});
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

void help_panel(bool& is_open) {
    if (!is_open) return;
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const ImVec2 room{0.96f * viewport.Size.x, 0.92f * viewport.Size.y};
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, room);
    ImGui::Begin("Keys (Esc closes)", &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    const std::vector<HelpLine> lines = help_lines();
    const bool is_wide = room.x > 2.0f * width_of(lines) + 6.0f * ImGui::GetFontSize();
    std::size_t half = is_wide ? (lines.size() + 1) / 2 : lines.size();
    while (is_wide && *lines[half].keys) --half; // the second column begins with a heading
    if (ImGui::BeginTable("keys", is_wide ? 4 : 2, ImGuiTableFlags_SizingFixedFit)) {
        for (std::size_t i = 0; i < std::max(half, lines.size() - half); ++i) {
            ImGui::TableNextRow();
            help_cells(i < half ? lines[i] : HelpLine{" ", ""});
            if (half + i < lines.size()) help_cells(lines[half + i]);
        }
        ImGui::EndTable();
    }
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
