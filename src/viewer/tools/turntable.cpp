// Turntable tool: pictures of a full turn around the pivot, as PNGs or a video, beside the window's render.
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "image/video.hpp"
#include "picture/open_scene.hpp"
#include "viewer/config.hpp"
#include "viewer/panels/turntable_dialog.hpp"
#include "viewer/picture_file.hpp"
#include "viewer/tools/tool.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace sr::viewer {
namespace {

/// ".mp4" or ".webm"; empty for a folder.
std::string extension_of(const std::string& target) {
    const std::filesystem::path file(target);
    return image::is_video(file) ? file.extension().string() : "";
}

} // namespace

class Turntable : public Tool {
public:
    using Tool::Tool;
    ~Turntable() override { stop(); }

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    bool holds_keyboard() const override { return dialog_.is_open() && !ws_.question; }
    Activity activity() const override {
        if (!turning_) return Activity::idle;
        return turning_->writing.valid() ? Activity::waiting : Activity::active;
    }

private:
    /// A turn that is being written.
    struct Turning {
        TurntableRequest request;
        picture::Turn turn;
        std::unique_ptr<PictureRender> render;     // of the picture at hand
        std::shared_ptr<image::VideoFile> video{}; // null: PNGs
        int step = 0;                              // pictures that were taken
        bool is_ending = false;                    // the video is
        std::future<void> writing{};               // of the last picture, or of the end of the video
        std::stop_source stop{};
        std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();

        std::string file_of_step() const { return fmt::format("{}/{:04}.png", request.target, step); }
    };

    void show();
    void take(const TurntableRequest& wanted);
    void begin(const TurntableRequest& wanted);
    Turning turning_for(const TurntableRequest& wanted) const;
    void advance();
    void take_picture();
    void report();
    void stop();
    void end(const std::string& message);

    TurntableDialog dialog_;
    TurntableRequest request_; // that was taken last
    std::optional<Turning> turning_;
};

std::optional<Changes> Turntable::handle(const Event& event) {
    const auto command = command_in(event);
    if (command == Command::turntable) {
        show();
        return Change::redraw;
    }
    if (command != Command::cancel || !(dialog_.is_open() || turning_)) return std::nullopt;
    if (dialog_.is_open())
        dialog_.close();
    else
        end(turning_->video ? "Turntable cancelled: no video is written."
                            : fmt::format("Turntable cancelled after {} pictures.", turning_->step));
    return Change::redraw;
}

void Turntable::show() {
    if (ws_.is_exporting()) return;
    ws_.show_panels();
    TurntableRequest proposed = request_;
    if (proposed.target.empty())
        proposed.picture = {{ws_.width, ws_.height}, ws_.options.stop.samples, ws_.options.stop.error};
    proposed.target = free_name(ws_.scene->loaded().file, "-turntable" + extension_of(request_.target));
    dialog_.show(proposed, {ws_.width, ws_.height});
}

/// Asks before a video is replaced.
void Turntable::take(const TurntableRequest& wanted) {
    std::error_code ignored;
    if (!std::filesystem::exists(wanted.target, ignored)) return begin(wanted);
    const std::string free = free_name(ws_.scene->loaded().file, "-turntable" + extension_of(wanted.target));
    ws_.ask_to_replace(wanted.target, free, [this, wanted](const std::string& target) {
        TurntableRequest request = wanted;
        request.target = target;
        begin(request);
    });
}

Turntable::Turning Turntable::turning_for(const TurntableRequest& wanted) const {
    const std::string& argument = ws_.camera->argument();
    const bool is_free = argument == "auto" || scene::is_look_at(argument);
    const scene::Camera camera = camera_for(ws_, wanted.picture.size);
    // A camera that frames the scene goes around its middle, as that of `render --turntable` does.
    const vec3 around = argument == "auto" ? ws_.camera->bounds().center() : ws_.camera->view().pivot;
    Turning turning{.request = wanted,
                    .turn = {camera, ws_.camera->bounds(), around, wanted.pictures, wanted.axis, is_free},
                    .render = begin_picture(ws_, wanted.picture, camera)};
    if (image::is_video(wanted.target)) {
        turning.video = std::make_shared<image::VideoFile>(wanted.target, wanted.rate);
        return turning;
    }
    std::error_code failure;
    std::filesystem::create_directory(wanted.target, failure);
    if (failure)
        throw Error({wanted.target}, fmt::format("cannot be made ({})", failure.message()),
                    "choose a folder of yours");
    return turning;
}

void Turntable::begin(const TurntableRequest& wanted) {
    request_ = wanted;
    try {
        turning_.emplace(turning_for(wanted));
    } catch (const Error& error) {
        return dialog_.refuse(error.what());
    }
    dialog_.close();
    ws_.playback.is_playing = false;
    report();
    ws_.messages.notify(
        fmt::format("Writing {}. {} cancels.", wanted.target, ws_.keys.text(Command::cancel)));
}

/// Says how far it is, where the message area has the progress of the window's render.
void Turntable::report() {
    const int count = turning_->request.pictures;
    const double spent =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - turning_->begin).count();
    ws_.exporting = fmt::format("turntable: {} of {} pictures", turning_->step, count);
    if (turning_->step > 0)
        ws_.exporting += fmt::format(", {:.0f} s left", spent * (count - turning_->step) / turning_->step);
}

/// The next picture is rendered while this one is written on a thread.
void Turntable::take_picture() {
    Turning& turning = *turning_;
    const std::string file = turning.video ? turning.request.target : turning.file_of_step();
    const auto picture =
        std::make_shared<PictureFile>(picture_file(ws_, *turning.render, ws_.camera->argument(), file));
    turning.writing = started([picture, video = turning.video, stop = turning.stop.get_token()] {
        if (video)
            video->add(output::shown(picture->film, picture->settings).picture, stop);
        else
            picture->write();
    });
    if (++turning.step < turning.request.pictures)
        turning.render->look_from(turning.turn.camera(turning.step));
    report();
}

void Turntable::advance() {
    Turning& turning = *turning_;
    const bool is_whole = turning.step == turning.request.pictures;
    const bool is_writing = turning.writing.valid() && !is_done(turning.writing);
    if (!is_writing && turning.writing.valid()) std::exchange(turning.writing, {}).get();
    if (!is_whole && !turning.render->is_done()) return turning.render->advance();
    if (is_writing) return;
    if (!is_whole) return take_picture();
    if (turning.is_ending || !turning.video)
        return end(fmt::format("Wrote {}: {} pictures.", turning.request.target, turning.step));
    turning.is_ending = true;
    ws_.exporting = fmt::format("encoding {}", turning.request.target);
    turning.writing =
        started([video = turning.video, stop = turning.stop.get_token()] { video->put_in_place(stop); });
}

Changes Turntable::update(double /*seconds*/) {
    // A view that moves has all of the time.
    if (!turning_ || (ws_.scene->render().is_interactive() && !ws_.scene->render().is_converged())) return {};
    try {
        advance();
    } catch (const Error& error) {
        const std::string problem = error.what();
        end("The turntable has ended.");
        ws_.messages.fail("The turntable is incomplete.", problem);
    }
    return Change::redraw;
}

/// Ends the encoder, and waits for its thread.
void Turntable::stop() {
    if (!turning_) return;
    turning_->stop.request_stop();
    if (turning_->writing.valid()) turning_->writing.wait();
}

void Turntable::end(const std::string& message) {
    stop();
    turning_.reset();
    ws_.exporting.clear();
    ws_.messages.notify(message);
}

/// A turn is of one scene.
void Turntable::notice(Changes changes) {
    if (changes == everything) dialog_.close();
    if (turning_ && is_of_scene(changes))
        end("The turntable has ended, because the scene or the view of it has changed.");
}

Changes Turntable::draw(const Overlay& /*overlay*/) {
    const auto wanted = dialog_.draw();
    if (const std::string field = dialog_.take_focused(); !field.empty())
        ws_.messages.log("Field of the turntable: " + field);
    if (wanted) take(*wanted);
    return wanted || dialog_.wants_focus() ? Changes(Change::redraw) : Changes();
}

std::unique_ptr<Tool> make_turntable(Workspace& workspace) { return std::make_unique<Turntable>(workspace); }

} // namespace sr::viewer
