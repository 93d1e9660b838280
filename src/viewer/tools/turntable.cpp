// Turntable tool: writes a PNG of the converged render at each step of a turn around the pivot.
#include "core/error.hpp"
#include "image/file.hpp"
#include "viewer/config.hpp"
#include "viewer/tools/tool.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <filesystem>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {

class Turntable : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Activity activity() const override { return folder_.empty() ? Activity::idle : Activity::active; }

private:
    void ask();
    void begin(int steps);

    std::string folder_; // that is written to; empty: none
    int step_ = 0;
    int steps_ = 0; // of the full turn
};

std::optional<Changes> Turntable::handle(const Event& event) {
    const auto command = command_in(event);
    if (command == Command::turntable) {
        ask();
        return Change::redraw;
    }
    if (command != Command::cancel || folder_.empty()) return std::nullopt;
    folder_.clear();
    ws_.messages.notify("Turntable cancelled.");
    return Change::redraw;
}

void Turntable::ask() {
    if (!folder_.empty()) return ws_.messages.notify("A turntable is being written. Esc cancels it.");
    const auto begin_with = [this](int steps) { return [this, steps] { begin(steps); }; };
    ws_.ask({"A turntable is a full turn around the pivot. How many pictures?",
             {{GLFW_KEY_3, "36, every 10°", begin_with(36)},
              {GLFW_KEY_1, "12, every 30°", begin_with(12)},
              {GLFW_KEY_7, "72, every 5°", begin_with(72)},
              {GLFW_KEY_9, "360, every 1°", begin_with(360)},
              {0, "Cancel"}}});
}

void Turntable::begin(int steps) {
    ws_.playback.is_playing = false;
    const std::string folder = free_name(ws_.scene->loaded().file, "-turntable");
    std::error_code failure;
    std::filesystem::create_directory(folder, failure);
    if (failure) return ws_.messages.fail("Cannot write a turntable.", folder + ": " + failure.message());
    folder_ = folder;
    step_ = 0;
    steps_ = steps;
    if (ws_.exposure.is_automatic()) ws_.exposure.fix(ws_.exposure.ev100()); // the same for all steps
    ws_.messages.notify("Writing a turntable. Esc cancels.");
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
    orbit(view, {2.0f * pi / static_cast<float>(steps_), 0.0f});
    ws_.camera->move_to(view);
    const bool is_last = ++step_ == steps_;
    ws_.messages.notify(is_last ? fmt::format("Wrote {}: {} pictures.", std::exchange(folder_, {}), steps_)
                                : fmt::format("Turntable: {} of {}. Esc cancels.", step_, steps_));
    return Change::camera;
}

std::unique_ptr<Tool> make_turntable(Workspace& workspace) { return std::make_unique<Turntable>(workspace); }

} // namespace sr::viewer
