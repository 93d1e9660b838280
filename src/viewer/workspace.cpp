#include "viewer/workspace.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "settings/options.hpp"
#include "viewer/config.hpp"
#include "viewer/panels/animation.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace sr::viewer {
namespace {

std::string file_name(const std::string& file) { return std::filesystem::path(file).filename().string(); }

} // namespace

void Workspace::ask(Question asked) {
    question = std::move(asked);
    // A question that nobody sees is no question. A maximised window stays so.
    if (glfwGetWindowAttrib(window.handle(), GLFW_ICONIFIED)) glfwRestoreWindow(window.handle());
    glfwShowWindow(window.handle());
}

void Workspace::ask_to_replace(const std::string& file, const std::string& free,
                               const std::function<void(const std::string&)>& write) {
    ask({fmt::format("{} exists already. Replace it?", file),
         {{GLFW_KEY_S, fmt::format("Save as {}", file_name(free)), [write, free] { write(free); }},
          {GLFW_KEY_R, "Replace it", [write, file] { write(file); }},
          {0, "Cancel"}}});
}

bool Workspace::is_exporting() {
    if (exporting.empty()) return false;
    messages.notify(fmt::format("Now: {}. {} cancels it.", exporting, keys.text(Command::cancel)));
    return true;
}

bool Workspace::refuses(Command command) {
    if (exporting.empty() || !changes_scene(command)) return false;
    messages.notify(fmt::format("{} would change what is exported. Now: {}. {} cancels it.",
                                info_of(command).name, exporting, keys.text(Command::cancel)));
    return true;
}

void Workspace::answer(const Answer& given) {
    const auto act = given.act; // the answer belongs to the question
    question.reset();
    if (act) act();
}

void Workspace::leave(Departure departure, const std::string& file) {
    try {
        if (departure == Departure::open) require_regular_file(file);
    } catch (const Error& error) {
        return fail_to_open(error.what()); // no reason for a question about edits
    }
    if (!scene || !scene->lights().is_unsaved()) return depart(departure, file);
    const std::string copy = name_to_save();
    const auto save_first = [this, copy, departure, file] {
        if (write(copy)) depart(departure, file);
    };
    const auto discard = [this, departure, file] {
        if (departure == Departure::quit) scene->lights().mark_saved();
        depart(departure, file);
    };
    ask({fmt::format("{} has unsaved edits. {}", file_name(scene->loaded().file),
                     departure == Departure::quit     ? "Quit?"
                     : departure == Departure::reload ? "Reload it?"
                                                      : fmt::format("Open {}?", file_name(file))),
         {{GLFW_KEY_S, fmt::format("Save as {}", file_name(copy)), save_first},
          {GLFW_KEY_D, "Discard the edits", discard},
          {0, "Cancel"}}});
}

void Workspace::depart(Departure departure, const std::string& file) {
    switch (departure) {
    case Departure::quit: is_closing = true; break;
    case Departure::open: open(file); break;
    case Departure::reload: reload(); break;
    }
}

void Workspace::relight(bool shadows_change) {
    const std::size_t before = scene->lights().entries().size();
    try {
        scene->relight(shadows_change);
    } catch (const Error& error) {
        messages.fail("This edit cannot be shown, and is taken back.", error.what());
        if (scene->lights().entries().size() != before) selected.reset();
    }
}

std::string Workspace::name_to_save() const {
    return written.empty() ? edited_name(scene->loaded().file) : written.back().file;
}

bool Workspace::save(const std::string& file) {
    std::error_code ignored;
    const std::string& open_file = scene->loaded().file;
    if (std::filesystem::equivalent(file, open_file, ignored)) {
        messages.fail(
            "Cannot save the scene.",
            Error({file}, "is the open file, which stays as it is", "save under another name").what());
        return false;
    }
    const bool is_own = std::ranges::any_of(written, [&](const WrittenFile& own) {
        return own.file == file && own.time == std::filesystem::last_write_time(file, ignored);
    });
    const bool is_refused = !has_extension(file, scene_extensions); // by write(), with the reason
    if (is_own || is_refused || !std::filesystem::exists(file, ignored)) return write(file);
    ask_to_replace(file, edited_name(open_file), [this](const std::string& chosen) { write(chosen); });
    return false;
}

bool Workspace::write(const std::string& file) {
    const bool is_free = scene::is_look_at(camera->argument());
    std::vector<std::string> remarks;
    try {
        remarks = scene->lights().save(scene->loaded(), is_free ? &camera->camera() : nullptr, file);
    } catch (const Error& error) {
        messages.fail("Cannot save the scene.", error.what());
        return false;
    }
    scene->lights().mark_saved();
    std::erase_if(written, [&](const WrittenFile& own) { return own.file == file; });
    std::error_code ignored;
    written.push_back({file, std::filesystem::last_write_time(file, ignored)});
    answered |= Change::lights; // the journal is out of date
    const std::string& open_file = scene->loaded().file;
    if (!scene->loaded().source.is_unchanged())
        remarks.insert(
            remarks.begin(),
            fmt::format("{} has changed or gone since it was opened: the copy has it as it was, with "
                        "the edits.",
                        file_name(open_file)));
    messages.notify(fmt::format("Saved {}.{}{}", file, remarks.empty() ? "" : " ", fmt::join(remarks, " ")));
    return true;
}

/// Says why a file cannot be shown. The options are those of the scene that stays.
void Workspace::fail_to_open(const std::string& problem) {
    messages.fail(scene ? "Cannot open the file. The previous scene stays." : "Cannot open the file.",
                  problem);
    keeps_edits = false;
    if (!scene) return;
    options.scene = scene->loaded().file;
    options.variant = scene->loaded().variant;
}

void Workspace::open(const std::string& file) {
    if (loading) return messages.notify("A file is loading. Try again when it is done.");
    options.is_reloading = scene && file == scene->loaded().file;
    if (scene && !options.is_reloading) {
        options.camera.clear();
        options.animation.clear();
        options.variant.clear();
        options.at.reset();
        options.plays = keeps_edits = false;
    }
    options.scene = file;
    loading = started(
        [file, options = options, aspect = aspect_ratio()] { return load_scene(file, options, aspect); });
}

void Workspace::reload() {
    keeps_edits = false;
    if (!scene::is_look_at(camera->argument()))
        options.camera = camera->argument(); // the file may have changed it
    open(scene->loaded().file);
}

void Workspace::show_variant(const std::string& name) {
    options.variant = name;
    options.is_reloading = keeps_edits = true;
    if (!scene::is_look_at(camera->argument())) options.camera = camera->argument();
    loading = started([source = scene->loaded().source, options = options, aspect = aspect_ratio()] {
        return load_scene(source, options, aspect);
    });
}

Changes Workspace::take_loaded() {
    if (!loading || !is_done(*loading)) return {};
    try {
        auto loaded = std::exchange(loading, std::nullopt);
        show(loaded->get());
        messages.clear_error();
        return everything;
    } catch (const Error& error) {
        if (!scene && !has_first_page) throw;
        fail_to_open(error.what());
        return Change::redraw;
    }
}

void Workspace::show(LoadedScene loaded) {
    const bool is_same_file = scene && scene->loaded().file == loaded.file;
    CameraController controller(named_camera(loaded.stage, options.camera), loaded.bounds, aspect_ratio(),
                                loaded.stage.scene.origin);
    if (is_same_file && scene::is_look_at(camera->argument())) { // a free camera stays
        controller = *camera;
        controller.set_origin(loaded.stage.scene.origin);
        controller.set_bounds(loaded.bounds);
    }
    const bool is_first = !scene;
    if (is_first) statistics.loaded(loaded.seconds);
    auto shown = std::make_unique<SceneView>(std::move(loaded), options, controller.camera(), width, height);
    const bool has_edits = std::exchange(keeps_edits, false) && is_same_file;
    if (has_edits) shown->take_edits(scene->lights());
    if (is_same_file && !scene->loaded().hidden.empty()) {
        shown->hide(scene->loaded().hidden);
        shown->relight(true);
    }
    scene = std::move(shown);
    camera = std::move(controller);
    selected.reset();
    if (!is_same_file) object.reset();
    restart_playback(is_same_file);
    if (is_first) statistics.uploaded(scene->upload_seconds(), scene->compile_seconds());
    if (!is_same_file) written.clear();
    if (!is_same_file)
        exposure.restart();
    else if (!has_edits)
        messages.notify("Scene reloaded.");
    else
        messages.notify(options.variant.empty() ? "No variant."
                                                : fmt::format("Variant {}.", options.variant));
    for (const std::string& remark : scene->loaded().remarks) {
        messages.notify(remark);
        write_remark(remark);
    }
    has_new_files = true;
    is_outdated = !has_edits && !scene->loaded().source.is_unchanged();
    remember_file(scene->loaded().file);
}

/// A new file starts as its options say; a file that was loaded again continues.
void Workspace::restart_playback(bool is_same_file) {
    const LoadedScene& loaded = scene->loaded();
    if (!is_same_file) {
        playback = {};
        playback.is_playing = std::exchange(options.plays, false);
    }
    playback.animations = loaded.animations;
    playback.duration = loaded.asset ? loaded.asset->duration(loaded.animations) : 0.0;
    playback.seconds.reset();
    if (!loaded.moment.animations.empty()) playback.seconds = loaded.moment.seconds;
    if (!playback.has_any()) playback.is_playing = false;
    options.variant = loaded.variant;
}

Changes Workspace::reload_shaders() {
    ++statistics.reloads;
    try {
        scene->restart(options, camera->camera(), width, height);
        messages.clear_error();
        messages.notify("Shaders reloaded.");
        return Change::materials;
    } catch (const gl::ShaderError& error) {
        messages.fail("A shader does not compile. The render uses the previous shaders.",
                      error.what() + ("\n" + error.log()));
    } catch (const Error& error) {
        messages.fail("Cannot read the shaders. The render uses the previous ones.", error.what());
    }
    return Change::redraw;
}

settings::RenderSettings Workspace::seen_settings() const {
    const LoadedScene& loaded = scene->loaded();
    const auto& animations = loaded.contents.animations;
    settings::RenderSettings seen = options;
    seen.scene = loaded.file;
    seen.camera = camera->argument();
    seen.variant = loaded.variant;
    seen.at = playback.seconds;
    seen.animation.clear();
    if (seen.at && animations.size() > 1)
        seen.animation = animation_argument(animations, playback.animations);
    seen.size = settings::Size{width, height};
    seen.stop = scene->render().rule();
    seen.view = display.view;
    seen.ev100 = display.ev100;
    seen.tone_curve = display.curve;
    return seen;
}

std::string Workspace::time_arguments() const {
    const settings::RenderSettings seen = seen_settings();
    settings::RenderSettings time, variant;
    time.at = seen.at;
    time.animation = seen.animation;
    variant.variant = seen.variant;
    return settings::render_arguments(time) + settings::render_arguments(variant);
}

} // namespace sr::viewer
