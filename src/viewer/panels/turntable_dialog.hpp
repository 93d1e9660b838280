#pragma once
// Turntable dialog: pictures, axis and form of a full turn.
#include "scene/camera.hpp"
#include "viewer/panels/picture_fields.hpp"

#include <optional>
#include <string>

namespace sr::viewer {

/// A turn that a person asks for.
struct TurntableRequest {
    PictureRequest picture; // each of them
    int pictures = 36;
    scene::TurnAxis axis = scene::TurnAxis::y;
    double rate = 24.0; // of a video [pictures a second]
    std::string target; // a folder for PNGs, or a video
};

class TurntableDialog {
public:
    /// Opens it with these values. `window`: the size of the picture in the window.
    void show(const TurntableRequest& proposed, settings::Size window);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }
    bool wants_focus() const { return form_.wants_focus(); }
    /// The label of a field that got the keyboard, once; empty if none did.
    std::string take_focused() { return form_.take_focused(); }
    void refuse(const std::string& problem) { form_.refuse(problem); }

    /// Draws the dialog, if it is open. It stays open until close().
    /// @return the request, once Enter or the button has taken it
    std::optional<TurntableRequest> draw();

private:
    void draw_counts();
    void draw_axes();
    void draw_forms();
    /// The fields as values. @throws Error that says which one is wrong
    TurntableRequest request() const;

    bool is_open_ = false;
    TextForm form_;
    PictureFields picture_;
    TextForm::Text pictures_{}, rate_{}, target_{};
    scene::TurnAxis axis_ = scene::TurnAxis::y;
};

} // namespace sr::viewer
