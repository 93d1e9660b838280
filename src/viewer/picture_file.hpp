#pragma once
// Files of pictures, with attributes that say how each was made.
#include "output/write.hpp"
#include "viewer/panels/picture_fields.hpp"
#include "viewer/view/picture_render.hpp"
#include "viewer/workspace.hpp"

#include <memory>
#include <optional>
#include <string>

namespace sr::viewer {

/// How a film was rendered.
struct FilmFacts {
    render::StopRule rule;
    int samples = 0; // of a pixel that was not frozen
    std::optional<double> error;
    std::optional<render::StoppedBy> stopped_by; // absent: the rendering went on
    int light_choices = 0;
    std::string camera; // as `render --camera` takes it
};

/// A film that is ready to be written, without the workspace, so that another thread can write it.
struct PictureFile {
    image::Image film;
    std::string file; // its extension is the format
    output::FileSettings settings;

    /// @throws Error
    void write() const { output::write(film, nullptr, {file}, settings); }
};

/// `film`: of the view that is shown. It gets the exposure and the tone curve of the window.
PictureFile picture_file(const Workspace& workspace, image::Image film, const FilmFacts& facts,
                         std::string file);

/// The camera of the window, for a picture of another size.
scene::Camera camera_for(const Workspace& workspace, settings::Size size);

/// Begins to render a picture beside the window's render. @throws Error if the driver refuses the size
std::unique_ptr<PictureRender> begin_picture(const Workspace& workspace, const PictureRequest& wanted,
                                             const scene::Camera& camera);

/// The film of a picture that is done. `camera`: its own, as `render --camera` takes it.
PictureFile picture_file(const Workspace& workspace, const PictureRender& render, const std::string& camera,
                         std::string file);

} // namespace sr::viewer
