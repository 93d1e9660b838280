// Turntable tool: writes a PNG of the converged render at each step of a turn around the pivot.
#include "core/error.hpp"
#include "image/file.hpp"
#include "viewer/config.hpp"
#include "viewer/tools/tool.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr int turntable_steps = 36;

} // namespace

class Turntable : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Activity activity() const override { return folder_.empty() ? Activity::idle : Activity::active; }

private:
    Changes begin();

    std::string folder_; // that is written to; empty: none
    int step_ = 0;
};

std::optional<Changes> Turntable::handle(const Event& event) {
    const auto command = command_in(event);
    if (command == Command::turntable) return begin();
    if (command != Command::cancel || folder_.empty()) return std::nullopt;
    folder_.clear();
    ws_.messages.notify("Turntable cancelled.");
    return Change::redraw;
}

Changes Turntable::begin() {
    ws_.playback.is_playing = false;
    const std::string folder = free_name(ws_.scene->loaded().file, "-turntable");
    std::error_code failure;
    std::filesystem::create_directory(folder, failure);
    if (failure) {
        ws_.messages.fail("Cannot write a turntable.", folder + ": " + failure.message());
        return Change::redraw;
    }
    folder_ = folder;
    step_ = 0;
    if (ws_.exposure.is_automatic()) ws_.exposure.fix(ws_.exposure.ev100()); // the same for all steps
    ws_.messages.notify("Writing a turntable. Esc cancels.");
    return Change::redraw;
}

Changes Turntable::update(double /*seconds*/) {
    if (folder_.empty() || !ws_.scene->render().is_converged()) return {};
    const image::Image picture =
        image::displayed(ws_.scene->render().read_film(), ws_.exposure.ev100(), *ws_.display.curve);
    try {
        image::write(picture, fmt::format("{}/{:03}.png", folder_, step_), image::SampleType::integer8);
    } catch (const Error& error) {
        folder_.clear();
        ws_.messages.fail("The turntable is incomplete.", error.what());
        return Change::redraw;
    }
    Viewpoint view = ws_.camera->view();
    orbit(view, {2.0f * pi / turntable_steps, 0.0f});
    ws_.camera->move_to(view);
    const bool is_last = ++step_ == turntable_steps;
    ws_.messages.notify(is_last ? fmt::format("Wrote {}.", std::exchange(folder_, {}))
                                : fmt::format("Turntable: {} of {}. Esc cancels.", step_, turntable_steps));
    return Change::camera;
}

std::unique_ptr<Tool> make_turntable(Workspace& workspace) { return std::make_unique<Turntable>(workspace); }

} // namespace sr::viewer
