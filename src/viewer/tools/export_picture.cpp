// Export tool: renders the view at any size beside the window's render, and writes it.
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "viewer/config.hpp"
#include "viewer/panels/export_dialog.hpp"
#include "viewer/picture_file.hpp"
#include "viewer/tools/tool.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <future>
#include <memory>
#include <optional>
#include <utility>

namespace sr::viewer {

class ExportPicture : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    bool holds_keyboard() const override { return dialog_.is_open() && !ws_.question; }
    Activity activity() const override {
        return render_ ? Activity::active : writing_.valid() ? Activity::waiting : Activity::idle;
    }

private:
    void show();
    void take(const ExportRequest& wanted);
    void begin(const ExportRequest& wanted);
    void end(const std::string& message);
    void fail(const std::string& problem);
    void write();
    void report();

    ExportDialog dialog_;
    ExportRequest request_; // that was taken last
    std::unique_ptr<PictureRender> render_;
    std::string camera_; // of the picture, as `render --camera` takes it
    std::chrono::steady_clock::time_point begin_;
    std::future<void> writing_;
};

std::optional<Changes> ExportPicture::handle(const Event& event) {
    const auto command = command_in(event);
    if (command == Command::export_picture) {
        show();
        return Change::redraw;
    }
    if (command != Command::cancel || !(dialog_.is_open() || render_)) return std::nullopt;
    if (dialog_.is_open())
        dialog_.close();
    else
        end("Export cancelled: no file is written.");
    return Change::redraw;
}

void ExportPicture::show() {
    if (ws_.is_exporting()) return;
    ws_.show_panels();
    ExportRequest proposed = request_;
    if (proposed.file.empty())
        proposed.picture = {{ws_.width, ws_.height}, ws_.options.stop.samples, ws_.options.stop.error};
    proposed.file = free_name(ws_.scene->loaded().file, ".png");
    dialog_.show(proposed, {ws_.width, ws_.height});
}

/// Asks before a file is replaced.
void ExportPicture::take(const ExportRequest& wanted) {
    std::error_code ignored;
    if (!std::filesystem::exists(wanted.file, ignored)) return begin(wanted);
    const std::string free =
        free_name(ws_.scene->loaded().file, std::filesystem::path(wanted.file).extension().string());
    ws_.ask_to_replace(wanted.file, free, [this, wanted](const std::string& file) {
        begin({wanted.picture, file});
    });
}

void ExportPicture::begin(const ExportRequest& wanted) {
    dialog_.close();
    request_ = wanted;
    ws_.playback.is_playing = false;
    camera_ = ws_.camera->argument();
    try {
        render_ = begin_picture(ws_, wanted.picture, camera_for(ws_, wanted.picture.size));
        begin_ = std::chrono::steady_clock::now();
        report();
        ws_.messages.notify(fmt::format("Exporting {} at {}. {} cancels.", wanted.file,
                                        settings::text_of(wanted.picture.size),
                                        ws_.keys.text(Command::cancel)));
    } catch (const Error& error) {
        fail(error.what());
    }
}

/// Says how far it is, where the message area has the progress of the window's render.
void ExportPicture::report() {
    const double done = render_->progress(), share = done / request_.picture.samples;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    ws_.exporting = fmt::format("exporting {}: {} of {} samples", request_.file, render_->samples(),
                                request_.picture.samples);
    if (const auto error = render_->monitor().error())
        ws_.exporting += fmt::format(", error {:.2g} %", 100.0 * *error);
    if (done > 0.0 && spent > 1.0)
        ws_.exporting += fmt::format(", at most {:.0f} s left", spent * (1.0 - share) / share);
}

Changes ExportPicture::update(double /*seconds*/) {
    if (writing_.valid() && is_done(writing_)) {
        try {
            std::exchange(writing_, {}).get();
            end(fmt::format("Wrote {}: {} pixels.", request_.file, settings::text_of(request_.picture.size)));
        } catch (const Error& error) {
            fail(error.what());
        }
        return Change::redraw;
    }
    // A view that moves has all of the time.
    if (!render_ || (ws_.scene->render().is_interactive() && !ws_.scene->render().is_converged())) return {};
    try {
        render_->advance();
        report();
        if (render_->is_done()) write();
    } catch (const Error& error) {
        fail(error.what());
    }
    return Change::redraw;
}

/// Writes on a thread: a large picture takes seconds.
void ExportPicture::write() {
    PictureFile picture = picture_file(ws_, *render_, camera_, request_.file);
    render_.reset();
    ws_.exporting = fmt::format("writing {}", request_.file);
    writing_ = started([picture = std::move(picture)] { picture.write(); });
}

void ExportPicture::end(const std::string& message) {
    render_.reset();
    ws_.exporting.clear();
    ws_.messages.notify(message);
}

void ExportPicture::fail(const std::string& problem) {
    render_.reset();
    ws_.exporting.clear();
    ws_.messages.fail("Cannot export the picture.", problem);
}

/// A picture is of one scene.
void ExportPicture::notice(Changes changes) {
    if (render_ && is_of_scene(changes))
        end("The export has ended, because the scene or the view of it has changed.");
    if (changes == everything) dialog_.close();
}

Changes ExportPicture::draw(const Overlay& /*overlay*/) {
    const auto wanted = dialog_.draw();
    if (const std::string field = dialog_.take_focused(); !field.empty())
        ws_.messages.log("Field of the export: " + field);
    if (wanted) take(*wanted);
    return wanted || dialog_.wants_focus() ? Changes(Change::redraw) : Changes();
}

std::unique_ptr<Tool> make_export_picture(Workspace& workspace) {
    return std::make_unique<ExportPicture>(workspace);
}

} // namespace sr::viewer
