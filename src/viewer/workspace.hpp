#pragma once
// Workspace that tools and panels share: the window, the file, its view and how it is shown.
#include "gl/window.hpp"
#include "viewer/app/layout.hpp"
#include "viewer/changes.hpp"
#include "viewer/document/kept_pictures.hpp"
#include "viewer/document/light_selection.hpp"
#include "viewer/document/playback.hpp"
#include "viewer/input.hpp"
#include "viewer/keymap.hpp"
#include "viewer/messages.hpp"
#include "viewer/panels/probe.hpp"
#include "viewer/panels/question.hpp"
#include "viewer/statistics.hpp"
#include "viewer/ui.hpp"
#include "viewer/view/camera_controller.hpp"
#include "viewer/view/exposure.hpp"
#include "viewer/view/projection.hpp"
#include "viewer/view/scene_depth.hpp"
#include "viewer/view/scene_view.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <future>

namespace sr::viewer {

/// Reason why the scene that is shown, and its edits, end.
enum class Departure { quit, open, reload };

/// A file that this run has saved, and the time of its last change then: another program may have changed it
/// since.
struct WrittenFile {
    std::string file;
    std::filesystem::file_time_type time;
};

struct Workspace {
    Options options;
    gl::Window& window;
    WindowInput& input;
    const Ui& ui;
    Keymap keys;
    Messages messages;
    Statistics statistics{};

    std::unique_ptr<SceneView> scene{};       // null until the first file has loaded
    std::optional<CameraController> camera{}; // present once `scene` is
    LightSelection selected{};                // of scene->lights()
    std::optional<ObjectId> object{};         // selected in the scene tree
    Playback playback{};
    Exposure exposure;
    DisplaySettings display{};
    KeptPictures kept{};                 // to be compared
    std::optional<vec2> wanted_probe{};  // a place in the window that the probe tool shall take
    std::optional<ProbeResult> probed{}; // of the probe tool
    bool is_explained = false;           // `probed`, term by term, instead of the table of all numbers
    SceneDepth depth{};                  // of the picture, for marks over it
    bool is_term_left_out = false;       // the picture beside is the one without a term
    bool is_mixing = false;              // the GPU has the light mixer's lights, and the render waits
    std::string mixing{};                // how far the light mixer is
    std::string exporting{};             // how far an export or a turntable is; empty: there is none
    bool is_time_held = false;           // while a light is dragged
    Layout layout{};
    bool wants_panels = false; // hidden panels shall be shown
    int width = 0;             // of the film [pixels]
    int height = 0;

    bool has_first_page = false; // no scene was named: a file that cannot be shown does not end the viewer
    std::optional<std::future<LoadedScene>> loading{};
    bool keeps_edits = false;   // of lights, once `loading` is done
    bool has_new_files = false; // a file has loaded, and is not watched yet
    bool is_outdated = false;   // the file changed while it loaded

    std::optional<Question> question{}; // takes all keys until it is answered
    Changes answered{};                 // by the answer to a question
    bool is_closing = false;
    /// Takes the next frame, as it is seen without panels, and may throw Error; empty: nobody does.
    std::function<void(const image::Image& picture)> takes_seen{};
    std::vector<WrittenFile> written{}; // scene files that this run has saved, the last one last

    /// Size of the window, in the unit of the pointer.
    vec2 window_size() const { return input.window_size(); }
    float aspect_ratio() const { return static_cast<float>(width) / static_cast<float>(height); }
    /// Area of the window that shows the film, or a part of it.
    Area shown_area() const { return fitted_into(layout.picture(), aspect_ratio()); }
    /// Area that the whole film has: larger than what is shown where pixels are enlarged.
    Area picture() const {
        const Area shown = shown_area();
        const auto factor = static_cast<float>(display.zoom.factor);
        return {shown.from - factor * shown.size * vec2(display.zoom.from) / vec2(width, height),
                factor * shown.size};
    }
    /// Place of a point of the window in the picture, from 0 at its upper left to 1.
    vec2 place_in_picture(vec2 at) const { return (at - picture().from) / picture().size; }
    /// The kept picture that stands in place of the render; null: the render is shown.
    const KeptPicture* shown_picture() const { return is_term_left_out ? nullptr : kept.shown(); }
    /// True if a surface in the picture lies before this point.
    bool hides(vec3 point) {
        const int step = scene->render().is_interactive() ? 4 : 2; // pixels of the film
        depth.update(scene->gpu(), camera->camera(), std::max(1, width / step), std::max(1, height / step));
        return depth.hides(point);
    }
    Projection projection() const { return {camera->camera(), camera->aspect_ratio(), picture()}; }
    render::RenderOptions render_options() const { return viewer::render_options(options, width, height); }

    /// Shows the panels if they are hidden. @return true if they were
    bool show_panels() { return wants_panels = !layout.has_panels(); }
    /// Shows a panel beside the picture: all panels if they are hidden, its tab if another one is in front.
    /// @return true if it was not seen
    bool show_panel(const char* name) {
        const bool was_behind = layout.bring_forward(name);
        return show_panels() || was_behind;
    }

    /// Says that an export or a turntable is under way, if one is.
    bool is_exporting();
    /// Refuses a command that would end what is being exported, with a message. @return whether it did
    bool refuses(Command command);

    void ask(Question asked);
    /// Asks before a file is replaced, or written under the name `free` instead. @param write gets the name
    void ask_to_replace(const std::string& file, const std::string& free,
                        const std::function<void(const std::string&)>& write);
    void answer(const Answer& given);
    /// Quits, opens a file or reloads the current one. Asks first if there are unsaved edits.
    void leave(Departure departure, const std::string& file = {});
    /// Saves lights and, if the camera is free, the view. Reports errors. Asks before it replaces a file that
    /// this run has not written. @return true if the file is written
    bool save(const std::string& file);
    /// Shows the edits of lights and what is hidden, as SceneView::relight() does. Those that cannot be shown
    /// are taken back, with a message.
    void relight(bool shadows_change);
    /// The file that was saved last, if it is of the current scene, or else a new name beside it.
    std::string name_to_save() const;

    /// Begins to load a file. Another file drops the options that belong to the current one.
    void open(const std::string& file);
    /// Begins to load the current file again, without edits.
    void reload();
    /// Begins to show another material variant of the file as it was read, with all edits. No file is
    /// loading.
    void show_variant(const std::string& name);
    /// Shows a file that has loaded. @return what changed
    /// @throws Error if it is the file of the command line and cannot be shown
    Changes take_loaded();
    /// Restarts the render with the shaders on disk. Reports errors; then the old render stays.
    Changes reload_shaders();
    /// The settings by which `render` makes the picture that is seen, of the scene file without edits.
    settings::RenderSettings seen_settings() const;
    /// The arguments of `steradian render` for the current time and variant, each after a space.
    std::string time_arguments() const;

private:
    void fail_to_open(const std::string& problem);
    void depart(Departure departure, const std::string& file);
    bool write(const std::string& file);
    void show(LoadedScene loaded);
    void restart_playback(bool is_same_file);
};

} // namespace sr::viewer
