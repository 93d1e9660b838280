// Light mixer tool: changes of intensities and colours show at once, as a sum of a picture for each light.
#include "core/error.hpp"
#include "viewer/panels/mixer.hpp"
#include "viewer/tools/tool.hpp"
#include "viewer/view/layer_render.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

namespace sr::viewer {
namespace {

constexpr double max_memory = 1024.0 * 1024.0 * 1024.0; // [bytes] of the pictures

/// Lights whose pictures of this size fit into the memory; one picture more is the one without lights.
std::size_t most_lights(int width, int height) {
    const double bytes = 3.0 * sizeof(float) * width * height;
    return static_cast<std::size_t>(std::max(2.0, max_memory / bytes)) - 1;
}

/// True for a command that needs the scene with its own lights, or another picture than the mix.
bool ends_mixing(Command command) {
    switch (command) {
    case Command::probe_pixel:
    case Command::explain:
    case Command::compare:
    case Command::keep_picture:
    case Command::next_picture:
    case Command::next_reference:
    case Command::measure_pictures:
    case Command::screenshot_png:
    case Command::screenshot_exr:
    case Command::export_picture:
    case Command::turntable:
    case Command::next_background:
    case Command::play: return true;
    default: return false;
    }
}

} // namespace

class MixLights : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    void notice(Changes changes) override;
    Changes draw(const Overlay& overlay) override;
    FilmSum film() const override { return mix_ ? mix_->sum() : FilmSum{}; }
    Activity activity() const override {
        if (!is_open_) return Activity::idle;
        if (!render_) return Activity::active;
        return render_->is_done() ? Activity::idle : Activity::exclusive;
    }

private:
    Changes begin();
    Changes end();
    bool is_ready() const;
    void start();
    void drop();
    void wait_again();
    void mix();
    std::string progress() const;

    MixerPanel panel_;
    bool is_open_ = false;
    std::optional<LayerRender> render_; // once the picture has a sample
    std::optional<Reference> mix_;      // once all lights have a picture
    std::pair<int, int> size_{};        // of the pictures
};

std::optional<Changes> MixLights::handle(const Event& event) {
    const auto command = command_in(event);
    if (command == Command::mix_lights) {
        const bool was_hidden = ws_.show_panel(side::mixer);
        if (!is_open_) return begin();
        return was_hidden ? Changes(Change::redraw) : end();
    }
    if (!is_open_) return std::nullopt;
    if (command == Command::cancel) return end();
    const auto* click = std::get_if<ClickEvent>(&event);
    if ((click && click->modifiers == no_modifier) || (command && ends_mixing(*command)))
        end(); // the event is for another tool
    return std::nullopt;
}

Changes MixLights::begin() {
    const std::size_t count = ws_.scene->lights().entries().size();
    const std::size_t most = most_lights(ws_.width, ws_.height);
    if (count == 0 || count > most) {
        ws_.messages.notify(
            count == 0 ? "The scene has no lights to mix."
                       : fmt::format("The mixer takes up to {} lights in a window of this size (1 GiB of "
                                     "pictures). This scene has {}. A smaller window takes more.",
                                     most, count));
        return Change::redraw;
    }
    const std::string radiance = render::RenderOptions().shader;
    if (ws_.options.rendering.shader != radiance) {
        ws_.messages.notify(fmt::format("Another view than radiance is shown. {} goes on to the next.",
                                        ws_.keys.text(Command::next_view)));
        return Change::redraw;
    }
    panel_.begin(ws_.scene->lights());
    is_open_ = true;
    ws_.playback.is_playing = false;
    ws_.messages.notify(
        fmt::format("Rendering a picture of each light. Changes then show at once. {} ends it.",
                    ws_.keys.text(Command::mix_lights)));
    return Change::redraw;
}

/// Lights the scene as it was edited, and renders it.
Changes MixLights::end() {
    wait_again();
    is_open_ = false;
    ws_.messages.notify("Mixing has ended. The picture is rendered with these lights.");
    return Change::display;
}

/// Gives the scene back to the render of the picture. The lights are rendered again once that has a sample.
void MixLights::wait_again() {
    const bool was_mixing = ws_.is_mixing;
    drop();
    if (was_mixing) ws_.relight(false);
}

void MixLights::drop() {
    render_.reset();
    mix_.reset();
    ws_.is_mixing = false;
}

/// True if the picture has a sample at its full size, so that something is seen while the lights are
/// rendered.
bool MixLights::is_ready() const {
    const ProgressiveRender& render = ws_.scene->render();
    return !render.is_interactive() && render.complete_samples() > 0;
}

void MixLights::start() {
    size_ = {ws_.width, ws_.height};
    render_.emplace(*ws_.scene, render_options(ws_.options, ws_.width, ws_.height), ws_.camera->camera());
    ws_.is_mixing = true;
}

Changes MixLights::update(double /*seconds*/) {
    if (!is_open_) return {};
    ws_.mixing = "mixing: " + progress();
    if (render_ && size_ != std::pair(ws_.width, ws_.height)) wait_again();
    try {
        if (!render_ && is_ready()) start();
        if (!render_ || render_->is_done() || !render_->advance()) return {};
    } catch (const Error& error) {
        ws_.messages.fail("The lights cannot be mixed.", error.what());
        return end();
    }
    mix();
    ws_.messages.notify(fmt::format("Mixing {} lights, {} samples each.", render_->layers().lights(),
                                    render_->layers().samples()));
    return Change::display;
}

void MixLights::mix() {
    if (render_->layers().samples() == 0) return;
    mix_.emplace("mix", render_->layers().mix(render_->weights_of(ws_.scene->lights())));
}

/// Quantities change the mix. Another view, or a light in another place, needs other pictures.
void MixLights::notice(Changes changes) {
    if (!is_open_) return;
    if (changes == everything) { // another scene
        drop();
        is_open_ = false;
        return;
    }
    if (changes.has(Change::camera) || changes.has(Change::shadows) || changes.has(Change::materials)) {
        wait_again();
        if (changes.has(Change::shadows)) panel_.begin(ws_.scene->lights()); // one may have come or gone
    } else if (render_ && changes.has(Change::lights)) {
        mix();
    }
}

std::string MixLights::progress() const {
    if (!render_) return "waiting for the picture";
    if (render_->is_done()) return fmt::format("{} samples of each light", render_->layers().samples());
    const auto [done, all] = render_->progress();
    return fmt::format("rendering each light alone: {} of {} pictures{}", done, all,
                       mix_ ? fmt::format(", {} samples so far", render_->layers().samples())
                            : std::string());
}

Changes MixLights::draw(const Overlay& /*overlay*/) {
    if (!is_open_) return {};
    const PanelPlace place = ws_.layout.take_side(side::mixer);
    if (!place.is_shown) return {};
    bool closes = false;
    const Changes changes = panel_.draw(ws_.scene->lights(), ws_.scene->loaded(), ws_.selected, progress(),
                                        place.area, ws_.ui, closes);
    return closes ? changes | end() : changes;
}

std::unique_ptr<Tool> make_mix_lights(Workspace& workspace) { return std::make_unique<MixLights>(workspace); }

} // namespace sr::viewer
