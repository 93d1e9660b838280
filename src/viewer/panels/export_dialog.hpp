#pragma once
// Export dialog: size, samples, error and file of a picture.
#include "settings/values.hpp"
#include "viewer/ui.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace sr::viewer {

/// A picture that a person asks for.
struct ExportRequest {
    settings::Size size;
    int samples = 0;             // a pixel, at most
    std::optional<double> error; // √relMSE at which it stops; absent: after all samples
    std::string file;
};

class ExportDialog {
public:
    /// Opens it with these values. `window`: the size of the picture in the window.
    void show(const ExportRequest& proposed, settings::Size window);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }
    bool wants_focus() const { return focus_.is_pending(); }
    /// The label of a field that got the keyboard, once; empty if none did.
    std::string take_focused() { return std::exchange(focused_, {}); }

    /// Draws the dialog, if it is open. It stays open until close().
    /// @return the request, once Enter or the button has taken it
    std::optional<ExportRequest> draw();

private:
    using Text = std::array<char, 512>;

    bool field(const char* label, Text& text, const char* tip, bool is_first = false);
    void draw_sizes();
    /// The fields as values. @throws Error that says which one is wrong
    ExportRequest request() const;

    bool is_open_ = false;
    FocusRequest focus_;
    settings::Size window_;
    Text size_{}, samples_{}, error_{}, file_{};
    std::string focused_;
    std::string problem_; // of what was entered last
};

} // namespace sr::viewer
