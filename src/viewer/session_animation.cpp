// What moves in a file by itself, and its material variants.
#include "viewer/session.hpp"

#include "core/error.hpp"
#include "viewer/animation_bar.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>

namespace sr::viewer {

/// A file was read: a new one begins as it was asked for, one that was read anew goes on.
void Session::begin_playback(bool is_same_file) {
    const LoadedScene& scene = show_->scene();
    if (!is_same_file) {
        playback_ = {};
        playback_.is_playing = std::exchange(options_.plays, false);
    }
    playback_.animations = scene.animations;
    playback_.duration = scene.asset ? scene.asset->duration(scene.animations) : 0.0;
    playback_.seconds.reset();
    if (!scene.moment.animations.empty()) playback_.seconds = scene.moment.seconds;
    if (!playback_.has_any()) playback_.is_playing = false;
    options_.variant = scene.variant;
}

/// How far the file's clock went on since the last frame.
void Session::play(double elapsed) {
    if (!playback_.is_playing || grip_) return; // time stands while a light is in the hand
    constexpr double longest = 0.5;             // [s] a stall, after which it goes on from where it was
    playback_.advance(std::min(elapsed, longest));
    show_moment();
}

/// Brings the playback's moment to the picture; cameras of the file that move are followed.
void Session::show_moment() {
    const std::optional<LightEntry> selected =
        lights_.selected ? std::optional(show_->lighting().entries()[*lights_.selected]) : std::nullopt;
    try {
        show_->pose(playback_.moment());
    } catch (const Error& error) {
        fail("The animation cannot be shown at this moment.", error.what());
        playback_.is_playing = false;
        const gltf::Moment& shown = show_->scene().moment;
        playback_.seconds = shown.animations.empty() ? std::nullopt : std::optional(shown.seconds);
    }
    if (selected) lights_.selected = show_->lighting().entry_like(*selected);
    options_.at = playback_.seconds;
    eye_->set_bounds(show_->scene().bounds);
    eye_->follow(show_->scene().stage.scene.cameras);
    move_camera();
    probe_.answer.reset();
    frames_to_draw_ = std::max(frames_to_draw_, 1);
}

/// Keys that mean something else elsewhere: Space plays unless it switches a light, ← → Home End are the
/// bar's while the pointer is on it.
std::optional<Command> Session::key_of_the_bar(const KeyEvent& event) const {
    if (!playback_.has_any() || event.modifiers != no_modifier) return std::nullopt;
    if (event.key == GLFW_KEY_SPACE && !lights_.selected) return Command::play;
    if (!bar_has_pointer_) return std::nullopt;
    return command_of(event.key, alt);
}

bool Session::obey_animation(Command command) {
    switch (command) {
    case Command::play:
    case Command::frame_back:
    case Command::frame_forward:
    case Command::first_frame:
    case Command::last_frame: break;
    case Command::next_variant: next_variant(); return true;
    default: return false;
    }
    if (!playback_.has_any()) {
        say("nothing in this file moves");
        return true;
    }
    if (command == Command::play) {
        playback_.toggle();
        say(playback_.is_playing ? "playing" : "paused");
    }
    if (command == Command::frame_back) playback_.step(-1);
    if (command == Command::frame_forward) playback_.step(1);
    if (command == Command::first_frame) playback_.go_to(0.0);
    if (command == Command::last_frame) playback_.go_to(playback_.duration);
    show_moment();
    return true;
}

void Session::draw_animation() {
    bar_has_pointer_ = false;
    const LoadedScene& scene = show_->scene();
    if (!playback_.has_any()) return;
    const AnimationWish wish = animation_bar(playback_, scene.contents.animations, ui_.scale());
    bar_has_pointer_ = wish.has_pointer;
    if (wish.command) obey(*wish.command);
    if (wish.animation) {
        options_.animation = *wish.animation;
        auto chosen = scene.asset->animations_named(*wish.animation);
        const double duration = scene.asset->duration(chosen);
        playback_.choose(std::move(chosen), duration);
    }
    if (wish.time) playback_.go_to(*wish.time);
    if (wish.rests) {
        playback_.seconds.reset();
        playback_.is_playing = false;
    }
    if (wish.animation || wish.time || wish.rests) show_moment();
}

/// The file is read again, with what was edited in it.
void Session::choose_variant(const std::string& name) {
    if (name == show_->scene().variant || loading_) return;
    options_.variant = name;
    keeps_edits_ = true;
    read_again();
}

void Session::next_variant() {
    const std::vector<std::string>& all = show_->scene().contents.variants;
    if (all.empty()) return say("this file has no material variants");
    const auto now = std::ranges::find(all, show_->scene().variant);
    if (now == all.end()) return choose_variant(all.front());
    choose_variant(now + 1 == all.end() ? std::string() : *(now + 1));
}

/// The moment and the variant as `render` takes them, each with a space before it.
std::string Session::moment_argument() const {
    const LoadedScene& scene = show_->scene();
    std::string text;
    if (playback_.seconds) {
        text += fmt::format(" --at {:.9g}", *playback_.seconds);
        if (scene.contents.animations.size() > 1)
            text += fmt::format(" --animation '{}'",
                                animation_argument(scene.contents.animations, playback_.animations));
    }
    if (!scene.variant.empty()) text += fmt::format(" --variant '{}'", scene.variant);
    return text;
}

} // namespace sr::viewer
