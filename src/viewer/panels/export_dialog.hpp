#pragma once
// Export dialog: size, samples, error and file of a picture.
#include "viewer/panels/picture_fields.hpp"

#include <optional>
#include <string>

namespace sr::viewer {

/// A picture, and the file that a person wants it in.
struct ExportRequest {
    PictureRequest picture;
    std::string file;
};

class ExportDialog {
public:
    /// Opens it with these values. `window`: the size of the picture in the window.
    void show(const ExportRequest& proposed, settings::Size window);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }
    bool wants_focus() const { return form_.wants_focus(); }
    /// The label of a field that got the keyboard, once; empty if none did.
    std::string take_focused() { return form_.take_focused(); }

    /// Draws the dialog, if it is open. It stays open until close().
    /// @return the request, once Enter or the button has taken it
    std::optional<ExportRequest> draw();

private:
    /// The fields as values. @throws Error that says which one is wrong
    ExportRequest request() const;

    bool is_open_ = false;
    TextForm form_;
    PictureFields picture_;
    TextForm::Text file_{};
};

} // namespace sr::viewer
