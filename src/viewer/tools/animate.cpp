// Animation tool: plays and scrubs animations, switches material variants.
#include "core/error.hpp"
#include "viewer/panels/animation.hpp"
#include "viewer/tools/tool.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <imgui.h>

namespace sr::viewer {
class Animate : public Tool {
public:
    using Tool::Tool;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    Changes draw_section() override;
    Activity activity() const override { return ws_.playback.is_playing ? Activity::active : Activity::idle; }

private:
    std::optional<Command> command_of_key(const KeyEvent& event) const;
    std::optional<Changes> execute(Command command);
    Changes step(Command command);
    Changes show_time();
    Changes choose_variant(const std::string& name);
    Changes next_variant();

    bool bar_has_pointer_ = false;
};

std::optional<Changes> Animate::handle(const Event& event) {
    if (const auto command = command_in(event)) return execute(*command);
    const auto* key = std::get_if<KeyEvent>(&event);
    const auto command = key ? command_of_key(*key) : std::nullopt;
    return command ? execute(*command) : std::nullopt;
}

/// Keys that have another command elsewhere: Space plays while no light is selected; arrows, Home and End
/// belong to the bar while the pointer is on it.
std::optional<Command> Animate::command_of_key(const KeyEvent& event) const {
    if (!ws_.playback.has_any() || event.modifiers != no_modifier || ws_.ui.has_keyboard())
        return std::nullopt;
    if (event.key == GLFW_KEY_SPACE && !ws_.selected) return Command::play;
    return bar_has_pointer_ ? ws_.keys.command_of(event.key, alt) : std::nullopt;
}

std::optional<Changes> Animate::execute(Command command) {
    switch (command) {
    case Command::play:
    case Command::frame_back:
    case Command::frame_forward:
    case Command::first_frame:
    case Command::last_frame: return step(command);
    case Command::next_variant: return next_variant();
    default: return std::nullopt;
    }
}

Changes Animate::step(Command command) {
    Playback& playback = ws_.playback;
    if (!playback.has_any()) {
        ws_.messages.notify("This file has no animations.");
        return Change::redraw;
    }
    if (command == Command::play) {
        playback.toggle();
        ws_.messages.notify(playback.is_playing ? "Playing." : "Paused.");
    }
    if (command == Command::frame_back) playback.step(-1);
    if (command == Command::frame_forward) playback.step(1);
    if (command == Command::first_frame) playback.go_to(0.0);
    if (command == Command::last_frame) playback.go_to(playback.duration);
    return show_time();
}

Changes Animate::update(double seconds) {
    if (!ws_.playback.is_playing || ws_.is_time_held) return {};
    constexpr double max_step = 0.5; // [s] playback does not skip over a longer stall
    ws_.playback.advance(std::min(seconds, max_step));
    return show_time();
}

/// Shows the time of the playback. Cameras of the file are followed.
Changes Animate::show_time() {
    const std::vector<LightEntry> before = ws_.scene->lights().entries();
    try {
        ws_.scene->pose(ws_.playback.moment());
    } catch (const Error& error) {
        ws_.messages.fail("Cannot show the animation at this time.", error.what());
        ws_.playback.is_playing = false;
        const gltf::AnimationTime& shown = ws_.scene->loaded().moment;
        ws_.playback.seconds = shown.animations.empty() ? std::nullopt : std::optional(shown.seconds);
    }
    ws_.selected.follow(before, ws_.scene->lights());
    ws_.options.at = ws_.playback.seconds;
    ws_.camera->set_bounds(ws_.scene->loaded().bounds);
    ws_.camera->follow(ws_.scene->stage().scene.cameras);
    return Change::camera | Change::materials;
}

Changes Animate::draw(const Overlay& overlay) {
    bar_has_pointer_ = false;
    Playback& playback = ws_.playback;
    if (!playback.has_any()) return {};
    const LoadedScene& loaded = ws_.scene->loaded();
    const AnimationRequest request =
        animation_bar(playback, loaded.contents.animations, ws_.layout, ws_.keys, overlay.scale);
    bar_has_pointer_ = request.has_pointer;
    Changes changes;
    if (request.command) changes |= step(*request.command);
    if (request.animation) {
        ws_.options.animation = *request.animation;
        auto chosen = loaded.asset->animations_named(*request.animation);
        const double duration = loaded.asset->duration(chosen);
        playback.choose(std::move(chosen), duration);
    }
    if (request.time) playback.go_to(*request.time);
    if (request.rests) {
        playback.seconds.reset();
        playback.is_playing = false;
    }
    if (request.animation || request.time || request.rests) changes |= show_time();
    return changes;
}

Changes Animate::draw_section() {
    const LoadedScene& loaded = ws_.scene->loaded();
    const auto variant = variants_section(loaded.contents.variants, loaded.variant);
    return variant ? choose_variant(*variant) : Changes();
}

/// Loads the file again, with the edits.
Changes Animate::choose_variant(const std::string& name) {
    if (name == ws_.scene->loaded().variant || ws_.loading) return {};
    ws_.show_variant(name);
    return Change::redraw;
}

Changes Animate::next_variant() {
    const std::vector<std::string>& all = ws_.scene->loaded().contents.variants;
    if (all.empty()) {
        ws_.messages.notify("This file has no material variants.");
        return Change::redraw;
    }
    const auto now = std::ranges::find(all, ws_.scene->loaded().variant);
    if (now == all.end()) return choose_variant(all.front());
    return choose_variant(now + 1 == all.end() ? std::string() : *(now + 1));
}

std::unique_ptr<Tool> make_animate(Workspace& workspace) { return std::make_unique<Animate>(workspace); }

} // namespace sr::viewer
