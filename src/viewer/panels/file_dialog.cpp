#include "viewer/panels/file_dialog.hpp"

#include "viewer/config.hpp"

#include <algorithm>
#include <filesystem>
#include <imgui.h>

namespace sr::viewer {
namespace {

const char* title_of(FileDialog::Purpose purpose) {
    switch (purpose) {
    case FileDialog::Purpose::open: return "Open a glTF file";
    case FileDialog::Purpose::save: return "Save lights, materials and view as a new glTF";
    case FileDialog::Purpose::compare: return "Compare with an EXR, HDR, PNG or JPEG";
    }
    return "";
}

/// "" for a file in the working directory, or else its folder with a '/' at its end.
std::string folder_of(const std::string& file) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    return folder.empty() ? std::string() : folder.string() + "/";
}

} // namespace

void FileDialog::show(Purpose purpose, const std::string& file) {
    is_open_ = true;
    is_waiting_ = false;
    purpose_ = purpose;
    recent_.clear();
    if (purpose == Purpose::compare) return browser_.show({".exr", ".hdr", ".png", ".jpg", ".jpeg"}, "");
    browser_.show({scene_extensions.begin(), scene_extensions.end()},
                  purpose == Purpose::save ? file : folder_of(file));
    if (purpose == Purpose::open) recent_ = recent_files();
}

std::optional<std::string> FileDialog::draw() {
    if (!is_open_) return std::nullopt;
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float width = std::min(36.0f * ImGui::GetFontSize(), 0.85f * window.x);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {4e3f, 0.8f * window.y});
    ImGui::Begin(title_of(purpose_), &is_open_,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    auto chosen = browser_.draw("a path, then Enter; Tab completes it", width,
                                std::min(0.35f * window.y, 14.0f * ImGui::GetTextLineHeightWithSpacing()));
    if (const auto recent = draw_recent()) browser_.type(*(chosen = recent));
    ImGui::End();
    is_waiting_ = is_waiting_ || chosen.has_value();
    return chosen;
}

std::optional<std::string> FileDialog::draw_recent() {
    std::optional<std::string> chosen;
    if (recent_.empty()) return chosen;
    ImGui::TextDisabled("recent files");
    for (const std::string& file : recent_)
        if (ImGui::Selectable(file.c_str())) chosen = file;
    return chosen;
}

} // namespace sr::viewer
