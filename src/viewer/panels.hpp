#pragma once
// The panels that say what there is and take what a person wants, drawn with Dear ImGui.
#include "viewer/exposure.hpp"
#include "viewer/eye.hpp"
#include "viewer/screen.hpp"

#include <span>
#include <string>

namespace sr::viewer {

/// What the line at the bottom says.
struct Status {
    std::string progress;      // of the picture
    std::string under_pointer; // radiance and luminance
    std::string message;       // the last thing that happened
};
void status_line(const Status& status);

/// All keys and gestures.
void help_panel(bool& is_open);

/// Over the picture, until it is mended: what is wrong.
void error_panel(const std::string& title, const std::string& text);

/// Cameras, lens, roll. @return a key's command, if a button for it was pressed
struct CameraWish {
    std::optional<Command> command;
    std::optional<std::size_t> file_camera;
    std::optional<Viewpoint> moved;
};
CameraWish camera_panel(const Eye& eye, std::span<const scene::Camera> cameras);

/// Exposure, tone curve, false colour.
void picture_panel(Exposure& exposure, Look& look, std::string_view unit);

/// Draws the false colours with labelled decades.
void legend(const image::Decades& decades, std::string_view unit);

} // namespace sr::viewer
