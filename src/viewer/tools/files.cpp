// File tool: opens, reloads and saves scenes, writes screenshots, watches files for changes.
#include "core/error.hpp"
#include "viewer/config.hpp"
#include "viewer/document/watch.hpp"
#include "viewer/panels/file_dialog.hpp"
#include "viewer/picture_file.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace sr::viewer {
class Files : public Tool {
public:
    explicit Files(Workspace& workspace);

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    bool holds_keyboard() const override { return dialog_.is_open(); }
    Activity activity() const override { return ws_.loading ? Activity::waiting : Activity::idle; }

private:
    Changes reload();
    Changes open_neighbour(int step);
    Changes shoot(const std::string& extension);
    Changes write(std::string extension);

    FileDialog dialog_;
    Watch scene_watch_;
    Watch shader_watch_;
    std::string watched_; // the scene that scene_watch_ watches
    std::string awaited_; // extension of a screenshot that waits for the render; empty: none
};

Files::Files(Workspace& workspace) : Tool(workspace) {
    shader_watch_.set({ws_.options.shaders.begin(), ws_.options.shaders.end()});
}

std::optional<Changes> Files::handle(const Event& event) {
    if (const auto* dropped = std::get_if<FileEvent>(&event)) {
        if (!has_extension(dropped->file, scene_extensions)) return std::nullopt;
        ws_.leave(Departure::open, dropped->file);
        return Change::redraw;
    }
    const auto command = command_in(event);
    if (!command) return std::nullopt;
    switch (*command) {
    case Command::open_file:
        dialog_.show(FileDialog::Purpose::open, ws_.options.scene);
        return Change::redraw;
    case Command::save_as: dialog_.show(FileDialog::Purpose::save, ws_.name_to_save()); return Change::redraw;
    case Command::reload: return reload();
    case Command::next_file: return open_neighbour(1);
    case Command::previous_file: return open_neighbour(-1);
    case Command::screenshot_png: return shoot(".png");
    case Command::screenshot_exr: return shoot(".exr");
    case Command::screenshot_seen:
        ws_.takes_seen = [this,
                          file = free_name(ws_.scene->loaded().file, ".png")](const image::Image& picture) {
            image::write(picture, file, image::SampleType::integer8);
            ws_.messages.notify(fmt::format("Wrote {}.", file));
        };
        return Change::redraw;
    case Command::cancel:
        if (!dialog_.is_open() && awaited_.empty()) return std::nullopt;
        if (!dialog_.is_open()) ws_.messages.notify("Screenshot cancelled.");
        if (!dialog_.is_open()) awaited_.clear();
        dialog_.close();
        return Change::redraw;
    default: return std::nullopt;
    }
}

Changes Files::reload() {
    ++ws_.statistics.reloads;
    ws_.leave(Departure::reload);
    return Change::redraw;
}

/// Opens another glTF file of the folder, by name; after the last one the first.
Changes Files::open_neighbour(int step) {
    const std::string& open_file = ws_.scene->loaded().file;
    const std::vector<std::string> files = scenes_beside(open_file);
    const auto at =
        std::ranges::find(files, std::filesystem::path(open_file).filename(),
                          [](const std::string& f) { return std::filesystem::path(f).filename(); });
    if (files.size() < 2 || at == files.end()) {
        ws_.messages.notify("The folder has no other .gltf or .glb file.");
        return Change::redraw;
    }
    const std::ptrdiff_t count = std::ssize(files);
    const std::string& file = files[static_cast<std::size_t>((at - files.begin() + count + step) % count)];
    ws_.messages.notify(fmt::format("Opening {}.", file));
    ws_.leave(Departure::open, file);
    return Change::redraw;
}

/// Reloads what was saved. Shaders of an assignment are checked first, by its tool.
Changes Files::update(double /*seconds*/) {
    const std::string& file = ws_.scene->loaded().file;
    if (watched_ != file || ws_.has_new_files) {
        std::vector<std::filesystem::path> files{file};
        for (const auto& [named, as_read] : ws_.scene->loaded().source.named) files.push_back(named);
        scene_watch_.set(std::move(files));
        watched_ = file;
        ws_.has_new_files = false;
    }
    Changes changes;
    if (!awaited_.empty() && ws_.scene->render().is_converged()) changes |= write(awaited_);
    if (ws_.options.submission.empty() && shader_watch_.has_changed()) changes |= ws_.reload_shaders();
    if (!ws_.loading && (std::exchange(ws_.is_outdated, false) || scene_watch_.has_changed()))
        changes |= reload();
    const bool is_refused = dialog_.is_waiting() && !ws_.loading && !ws_.question;
    if (!is_refused) return changes;
    dialog_.retry();
    return changes | Change::redraw;
}

/// Writes the render once it has converged; at once if this is requested twice, and it has the window's size.
Changes Files::shoot(const std::string& extension) {
    const ProgressiveRender& render = ws_.scene->render();
    ws_.playback.is_playing = false;
    const bool is_enough = awaited_ == extension && !render.is_interactive() && render.complete_samples() > 0;
    if (render.is_converged() || is_enough) return write(extension);
    awaited_ = extension;
    const Command again = extension == ".exr" ? Command::screenshot_exr : Command::screenshot_png;
    ws_.messages.notify(
        fmt::format("The screenshot waits for the render to converge. {} again: as it is. {}: cancel.",
                    ws_.keys.text(again), ws_.keys.text(Command::cancel)));
    return Change::redraw;
}

/// Writes the render with its provenance.
Changes Files::write(std::string extension) { // by value: it may be awaited_
    awaited_.clear();
    const ProgressiveRender& render = ws_.scene->render();
    const std::string file = free_name(ws_.scene->loaded().file, extension);
    const FilmFacts facts{.rule = render.rule(),
                          .samples = render.sample_count(),
                          .error = render.error(),
                          .stopped_by = render.stopped_by(),
                          .light_choices = render.light_choices(),
                          .camera = ws_.camera->argument()};
    try {
        picture_file(ws_, render.read_film(), facts, file).write();
        ws_.messages.notify(fmt::format("Wrote {}.", file));
    } catch (const Error& error) {
        ws_.messages.fail("Cannot write the picture.", error.what());
    }
    return Change::redraw;
}

Changes Files::draw(const Overlay& /*overlay*/) {
    const auto purpose = dialog_.purpose();
    const auto file = dialog_.draw();
    if (file && purpose == FileDialog::Purpose::open) ws_.leave(Departure::open, *file);
    if (file && purpose == FileDialog::Purpose::save && (ws_.save(*file) || ws_.question)) dialog_.close();
    return file || dialog_.wants_focus() ? Changes(Change::redraw) : Changes();
}

/// A scene that has loaded closes the dialog that asked for it.
void Files::notice(Changes changes) {
    if (changes == everything) dialog_.close();
}

std::unique_ptr<Tool> make_files(Workspace& workspace) { return std::make_unique<Files>(workspace); }

} // namespace sr::viewer
