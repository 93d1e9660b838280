#include "viewer/panels/help.hpp"

#include "viewer/bindings.hpp"

#include <algorithm>
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

void status_line(const Status& status) {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float height = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos({viewport.Pos.x, viewport.Pos.y + viewport.Size.y - height});
    ImGui::SetNextWindowSize({viewport.Size.x, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6.0f, 2.0f});
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
                     | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
    text(status.progress);
    for (const std::string* part : {&status.under_pointer, &status.message}) {
        if (part->empty()) continue;
        ImGui::SameLine(0.0f, 3.0f * ImGui::GetFontSize());
        text(*part);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void help_panel(bool& is_open) {
    if (!is_open) return;
    const ImVec2 center = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(center, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {4e3f, 0.92f * ImGui::GetMainViewport()->Size.y});
    ImGui::Begin("Keys (Esc closes)", &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    const std::vector<HelpLine> lines = help_lines();
    std::size_t half = (lines.size() + 1) / 2;
    while (*lines[half].keys) --half; // the second column begins with a heading
    if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
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
