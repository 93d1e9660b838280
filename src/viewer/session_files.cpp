// What the session reads and writes: scenes, shaders, pictures.
#include "viewer/session.hpp"

#include "core/error.hpp"
#include "core/output.hpp"
#include "render/provenance.hpp"
#include "viewer/document/light_edits.hpp"
#include "viewer/screenshot.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace sr::viewer {

void Session::open(const std::string& file) {
    if (loading_) {
        say("still loading; drop the file again when that is done");
        return;
    }
    const float aspect = static_cast<float>(width_) / static_cast<float>(height_);
    options_.is_reloading = show_ && file == show_->scene().file;
    if (show_ && !options_.is_reloading) { // these were the other file's
        options_.camera.clear();
        options_.animation.clear();
        options_.variant.clear();
        options_.at.reset();
        options_.plays = keeps_edits_ = false;
    }
    options_.scene = file;
    loading_ = std::async(std::launch::async, load_scene, file, options_, aspect);
}

/// Scenes are opened, pictures are compared with.
void Session::take_dropped(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        const std::string ending = std::filesystem::path(file).extension().string();
        if (ending == ".gltf" || ending == ".glb")
            open(file);
        else if (is_picture(file) && show_)
            load_reference(file);
        else
            fail("This cannot be shown.",
                 Error({file}, "is neither a scene nor a picture",
                       "drop a .gltf or .glb to open it, an .exr, .hdr, .png or .jpg to compare with")
                     .what());
    }
    frames_to_draw_ = frames_to_draw_ > 3 ? frames_to_draw_ : 3;
}

void Session::reload() {
    if (!show_) return;
    ++statistics_.reloads;
    keeps_edits_ = false;
    read_again();
}

void Session::read_again() {
    if (!scene::is_look_at(eye_->argument())) options_.camera = eye_->argument(); // as the file has it now
    open(show_->scene().file);
}

void Session::write_png() {
    const std::string name = free_name(show_->scene().file, ".png");
    try {
        image::write(image::displayed(show_->picture().film(), look_.ev100, look_.curve), name,
                     image::SampleType::integer8);
        say("wrote " + name);
    } catch (const Error& error) {
        fail("No picture was written.", error.what());
    }
}

void Session::write_exr() {
    const std::string name = free_name(show_->scene().file, ".exr");
    const Picture& picture = show_->picture();
    image::Image film = picture.film();
    film.channel_names = {"R", "G", "B", "A"};
    const render::RenderOptions& rendering = options_.rendering;
    film.attributes =
        render::attributes_of({.unit = std::string(scene::radiance_unit(show_->scene().stage.scene.units)),
                               .camera = eye_->argument(),
                               .estimator = rendering.estimator,
                               .analytic_points = rendering.analytic_points,
                               .visibility = options_.visibility,
                               .samples = picture.sample_count(),
                               .seed = rendering.seed,
                               .error = picture.error(),
                               .seconds = playback_.seconds},
                              window_.info());
    try {
        image::write(film, name, image::SampleType::floating);
        say("wrote " + name);
    } catch (const Error& error) {
        fail("No picture was written.", error.what());
    }
}

/// A whole turn around the pivot, a PNG for each of its steps, each converged.
void Session::begin_turntable() {
    playback_.is_playing = false;
    turntable_.emplace();
    turntable_->folder = free_name(show_->scene().file, "-turntable");
    std::error_code failure;
    std::filesystem::create_directory(turntable_->folder, failure);
    if (failure) {
        fail("There is no turntable.", turntable_->folder + ": " + failure.message());
        turntable_.reset();
        return;
    }
    if (exposure_.is_automatic()) exposure_.fix(exposure_.ev100()); // the same for all of them
    say("turntable: Esc stops it");
}

void Session::advance_turntable() {
    if (!turntable_ || !show_->picture().is_done()) return;
    const std::string name = fmt::format("{}/{:03}.png", turntable_->folder, turntable_->step);
    try {
        image::write(image::displayed(show_->picture().film(), exposure_.ev100(), look_.curve), name,
                     image::SampleType::integer8);
    } catch (const Error& error) {
        turntable_.reset();
        return fail("The turntable ends.", error.what());
    }
    Viewpoint view = eye_->view();
    orbit(view, {2.0f * pi / Turntable::steps, 0.0f});
    eye_->move_to(view);
    move_camera();
    say(fmt::format("turntable: {} of {}, Esc stops it", ++turntable_->step, Turntable::steps));
    if (turntable_->step < Turntable::steps) return;
    say("wrote " + turntable_->folder);
    turntable_.reset();
}

void Session::draw_dialog() {
    const auto purpose = dialog_.purpose();
    const auto file = dialog_.draw();
    if (!file) return;
    if (purpose == FileDialog::Purpose::open) open(*file);
    if (purpose == FileDialog::Purpose::compare) load_reference(*file);
    if (purpose == FileDialog::Purpose::save) save_scene(*file);
}

void Session::save_scene(const std::string& file) {
    const bool is_free = scene::is_look_at(eye_->argument());
    try {
        show_->lighting().save(show_->scene(), is_free ? &eye_->camera() : nullptr, file);
        say("saved " + file);
    } catch (const Error& error) {
        fail("Nothing was saved.", error.what());
    }
}

/// A saved scene or shader shows at once.
void Session::watch_files() {
    if (!show_) return;
    if (shader_watch_.has_changed()) {
        if (marks_)
            marks_->begin(); // take_marks() reloads
        else
            reload_shaders();
    }
    if (!loading_ && scene_watch_.has_changed()) reload();
}

void Session::reload_shaders() {
    ++statistics_.reloads;
    frames_to_draw_ = 1;
    try {
        show_->make_picture(options_, eye_->camera(), width_, height_);
        measured_samples_ = 0;
        error_text_.clear();
        say("shaders read anew");
    } catch (const gl::ShaderError& error) {
        fail("A shader does not compile. The picture is by the last ones that did.",
             error.what() + ("\n" + error.log()));
    } catch (const Error& error) {
        fail("The shaders cannot be read. The picture is by the last ones that could.", error.what());
    }
}

void Session::fail(const std::string& title, const std::string& text) {
    error_title_ = title;
    error_text_ = text;
    frames_to_draw_ = std::max(frames_to_draw_, 3); // a panel learns its size by being drawn
    if (options_.is_verbose) write_remark(text);
}

} // namespace sr::viewer
