#include "viewer/panels/file_dialog.hpp"

#include "viewer/config.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <imgui.h>

namespace sr::viewer {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_beside(const fs::path& file, const std::vector<std::string>& extensions) {
    std::vector<std::string> files;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure))
        if (std::ranges::find(extensions, entry->path().extension().string()) != extensions.end())
            files.push_back(entry->path().string());
    std::ranges::sort(files);
    return files;
}

const char* title_of(FileDialog::Purpose purpose) {
    switch (purpose) {
    case FileDialog::Purpose::open: return "Open a glTF file";
    case FileDialog::Purpose::save: return "Save lights and view as a new glTF";
    case FileDialog::Purpose::compare: return "Compare with an EXR, HDR, PNG or JPEG";
    }
    return "";
}

} // namespace

void FileDialog::show(Purpose purpose, const std::string& file) {
    is_open_ = true;
    is_waiting_ = false;
    focus_.begin();
    purpose_ = purpose;
    type(purpose == Purpose::save ? file : "");
    here_ = purpose == Purpose::open      ? files_beside(file, {".gltf", ".glb"})
            : purpose == Purpose::compare ? files_beside("./", {".exr", ".hdr", ".png", ".jpg", ".jpeg"})
                                          : std::vector<std::string>{};
    recent_ = purpose == Purpose::open ? recent_files() : std::vector<std::string>{};
}

/// Puts a path into the field.
void FileDialog::type(const std::string& path) {
    typed_.fill('\0');
    std::strncpy(typed_.data(), path.c_str(), typed_.size() - 1);
}

std::optional<std::string> FileDialog::draw() {
    if (!is_open_) return std::nullopt;
    std::optional<std::string> chosen;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {4e3f, 0.8f * ImGui::GetMainViewport()->Size.y});
    ImGui::Begin(title_of(purpose_), &is_open_,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushItemWidth(30.0f * ImGui::GetFontSize());
    if (focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    const bool is_entered =
        ImGui::InputTextWithHint("##file", "a path, then Enter", typed_.data(), typed_.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    focus_.update(ImGui::IsItemActive());
    if (is_entered && typed_[0] != '\0') chosen = typed_.data();
    if (const auto listed = draw_lists()) type(*(chosen = listed));
    ImGui::PopItemWidth();
    ImGui::End();
    is_waiting_ = is_waiting_ || chosen.has_value();
    return chosen;
}

std::optional<std::string> FileDialog::draw_lists() {
    std::optional<std::string> chosen;
    const auto list = [&](const char* title, const std::vector<std::string>& files) {
        if (files.empty()) return;
        ImGui::TextDisabled("%s", title);
        for (const std::string& file : files)
            if (ImGui::Selectable((file + "##" + title).c_str())) chosen = file;
    };
    list("recent files", recent_);
    list("in this folder", here_);
    return chosen;
}

} // namespace sr::viewer
