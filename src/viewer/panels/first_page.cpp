#include "viewer/panels/first_page.hpp"

#include "viewer/app/fonts.hpp"
#include "viewer/config.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <filesystem>
#include <imgui.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr float min_two_columns = 46.0f; // width of a page with two columns [heights of a letter]

/// A row with a name at its left and what it is beside that, on as many lines as that needs.
bool draw_row(const std::string& name, const std::string& what, float name_width) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float wrap = std::max(width - name_width, 6.0f * ImGui::GetFontSize());
    const float height = ImGui::CalcTextSize(what.c_str(), nullptr, false, wrap).y;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool is_chosen = ImGui::Selectable(("##" + name).c_str(), false, 0, {0.0f, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(at, palette::blue, name.c_str());
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + name_width, at.y}, palette::white,
                 what.c_str(), nullptr, wrap);
    return is_chosen;
}

} // namespace

FirstPage::FirstPage(std::vector<SampleScene> samples)
    : samples_(std::move(samples)), recent_(recent_files()) {
    browser_.show({scene_extensions.begin(), scene_extensions.end()}, "");
}

std::optional<std::string> FirstPage::draw(const Area& room, const Ui& ui) {
    place_next_window(room);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {24.0f * ui.scale(), 18.0f * ui.scale()});
    ImGui::Begin("first page", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
                     | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    const ImVec2 all = ImGui::GetContentRegionAvail();
    const bool has_two_columns = all.x > min_two_columns * ImGui::GetFontSize();
    const float gap = 28.0f * ui.scale();
    const float width = has_two_columns ? 0.45f * (all.x - gap) : all.x;
    std::optional<std::string> chosen;
    ImGui::BeginChild("open", {width, has_two_columns ? 0.0f : 0.5f * all.y});
    chosen = draw_browser(width, ui);
    ImGui::EndChild();
    if (has_two_columns) ImGui::SameLine(0.0f, gap);
    ImGui::BeginChild("lists");
    if (const auto listed = draw_lists(ui)) chosen = listed;
    ImGui::EndChild();
    ImGui::End();
    return chosen;
}

std::optional<std::string> FirstPage::draw_browser(float width, const Ui& ui) {
    heading("Open a scene", ui);
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("Drop a .gltf or .glb file on this window, or type its path.");
    ImGui::PopTextWrapPos();
    auto chosen = browser_.draw("a path, or the name of a bundled scene", width, -1.0f);
    std::error_code ignored;
    if (!chosen || std::filesystem::exists(*chosen, ignored)) return chosen;
    const auto sample = std::ranges::find(samples_, *chosen, &SampleScene::name);
    return sample == samples_.end() ? chosen : sample->file;
}

std::optional<std::string> FirstPage::draw_lists(const Ui& ui) {
    std::optional<std::string> chosen;
    if (!recent_.empty()) heading("Recent files", ui);
    for (const std::string& file : recent_) {
        const std::filesystem::path path(file);
        const float indent = 11.0f * ImGui::GetFontSize();
        if (draw_row(path.filename().string(), path.parent_path().string(), indent)) chosen = file;
    }
    if (!recent_.empty()) ImGui::Spacing();
    if (!samples_.empty()) heading("Bundled scenes", ui);
    for (const SampleScene& sample : samples_)
        if (draw_row(sample.name, in_plain_letters(sample.what), 6.0f * ImGui::GetFontSize()))
            chosen = sample.file;
    return chosen;
}

} // namespace sr::viewer
