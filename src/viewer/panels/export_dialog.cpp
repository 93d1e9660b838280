#include "viewer/panels/export_dialog.hpp"

#include "core/error.hpp"
#include "viewer/config.hpp"

#include <array>
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
    TextForm::begin_window("Export a picture", is_open_);
    bool is_entered = picture_.draw(form_, true);
    is_entered |= form_.field("file", file_, "in the working directory, or a path: .png, .jpg, .exr or .hdr");
    is_entered |= form_.end_window(
        "export", "Enter does it, too; Esc closes this dialog, and later cancels the export");
    return is_entered ? form_.taken([this] { return request(); }) : std::nullopt;
}

} // namespace sr::viewer
