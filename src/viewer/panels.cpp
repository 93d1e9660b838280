#include "viewer/panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <vector>

namespace sr::viewer {
namespace {

const ImVec4 orange{0.902f, 0.624f, 0.0f, 1.0f}; // Okabe & Ito 2008

void text(const std::string& line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }

/// A line of the help; without `keys` a heading.
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

CameraWish camera_panel(const Eye& eye, std::span<const scene::Camera> cameras) {
    CameraWish wish;
    if (!ImGui::CollapsingHeader("Camera", ImGuiTreeNodeFlags_DefaultOpen)) return wish;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const std::string name = fmt::format("{} {}##camera{}", i, cameras[i].name, i);
        if (ImGui::Selectable(name.c_str())) wish.file_camera = i;
    }
    Viewpoint view = eye.view();
    float degrees = glm::degrees(view.yfov);
    if (ImGui::SliderFloat("field of view", &degrees, 1.0f, 150.0f, "%.1f deg",
                           ImGuiSliderFlags_AlwaysClamp)) {
        view.yfov = glm::radians(degrees);
        wish.moved = view;
    }
    const auto button = [&](const char* label, Command command, bool is_first = false) {
        if (!is_first) ImGui::SameLine();
        if (ImGui::Button(label)) wish.command = command;
    };
    button("frame all", Command::frame_all, true);
    button("level", Command::level);
    button("copy", Command::copy_view);
    button("paste", Command::paste_view);
    ImGui::TextDisabled("--camera %s", eye.argument().c_str());
    return wish;
}

void picture_panel(Exposure& exposure, Look& look, std::string_view unit) {
    if (!ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) return;
    bool is_automatic = exposure.is_automatic();
    if (ImGui::Checkbox("auto", &is_automatic)) {
        if (is_automatic)
            exposure.make_automatic();
        else
            exposure.fix(exposure.ev100());
    }
    ImGui::SameLine();
    float ev = exposure.ev100();
    if (ImGui::SliderFloat("EV100", &ev, -10.0f, 20.0f, "%.2f")) exposure.fix(ev);
    constexpr std::array curves{"linear", "ACES", "neutral", "AgX"}; // the order of ToneCurve
    int curve = static_cast<int>(look.curve);
    if (ImGui::Combo("tone curve", &curve, curves.data(), static_cast<int>(curves.size())))
        look.curve = static_cast<image::ToneCurve>(curve);
    ImGui::Checkbox("false colour", &look.is_false_color);
    if (!look.is_false_color) return;
    image::Decades& decades = look.decades;
    ImGui::DragFloatRange2("decades", &decades.first, &decades.last, 0.05f, -12.0f, 12.0f, "1e%.1f");
    decades.last = std::max(decades.last, decades.first + 0.5f);
    legend(decades, unit);
}

void legend(const image::Decades& decades, std::string_view unit) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth(), height = ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float step = width / static_cast<float>(image::viridis.size() - 1);
    const auto color = [](const vec3& c) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1.0f}); };
    for (std::size_t i = 0; i + 1 < image::viridis.size(); ++i) {
        const float x = at.x + step * static_cast<float>(i);
        const ImU32 left = color(image::viridis[i]), right = color(image::viridis[i + 1]);
        list.AddRectFilledMultiColor({x, at.y}, {x + step, at.y + height}, left, right, right, left);
    }
    const float range = decades.last - decades.first;
    const int labelled = static_cast<int>(std::ceil(range / 4.0f)); // so many decades from label to label
    for (int k = static_cast<int>(std::ceil(decades.first)); static_cast<float>(k) <= decades.last; ++k) {
        const float x = at.x + width * (static_cast<float>(k) - decades.first) / range;
        list.AddLine({x, at.y + 0.6f * height}, {x, at.y + height}, IM_COL32_WHITE);
        if (k % labelled != 0) continue;
        const std::string label = fmt::format("1e{}", k);
        const float half = 0.5f * ImGui::CalcTextSize(label.c_str()).x;
        list.AddText({x - half, at.y + height}, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    }
    ImGui::Dummy({width, 2.0f * height});
    ImGui::SameLine();
    text(std::string(unit));
}

} // namespace sr::viewer
