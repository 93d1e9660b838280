#include "viewer/panels/export_dialog.hpp"

#include "core/error.hpp"
#include "viewer/config.hpp"

#include <algorithm>
#include <array>
#include <imgui.h>
#include <string_view>

namespace sr::viewer {
namespace {

constexpr std::array<std::string_view, 5> extensions{".png", ".exr", ".hdr", ".jpg", ".jpeg"};

} // namespace

void ExportDialog::show(const ExportRequest& proposed, settings::Size window) {
    is_open_ = true;
    picture_.show(proposed.picture, window);
    TextForm::put(file_, proposed.file);
    form_.begin();
}

ExportRequest ExportDialog::request() const {
    ExportRequest wanted{picture_.request(), file_.data()};
    if (!has_extension(wanted.file, extensions))
        throw Error({wanted.file}, "has no extension of a picture",
                    "give .png or .jpg for a screen, .exr or .hdr for cd/m²");
    return wanted;
}

std::optional<ExportRequest> ExportDialog::draw() {
    if (!is_open_) return std::nullopt;
    const float width = std::min(30.0f * ImGui::GetFontSize(), 0.85f * ImGui::GetMainViewport()->Size.x);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, 0.0f});
    ImGui::Begin("Export a picture", &is_open_, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize);
    ImGui::PushItemWidth(0.72f * ImGui::GetContentRegionAvail().x);
    bool is_entered = picture_.draw(form_, true);
    is_entered |= form_.field("file", file_, "in the working directory, or a path: .png, .jpg, .exr or .hdr");
    ImGui::PopItemWidth();
    ImGui::Spacing();
    is_entered |= ImGui::Button("export");
    tooltip("Enter does it, too; Esc closes this dialog, and later cancels the export");
    form_.draw_problem();
    ImGui::End();
    if (!is_entered) return std::nullopt;
    try {
        form_.accept();
        return request();
    } catch (const Error& error) {
        form_.refuse(error.what());
        return std::nullopt;
    }
}

} // namespace sr::viewer
