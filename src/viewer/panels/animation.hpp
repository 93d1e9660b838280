#pragma once
// Animation bar (play, scrub, speed, choice of animations) and the list of material variants.
#include "viewer/app/layout.hpp"
#include "viewer/document/playback.hpp"
#include "viewer/keymap.hpp"

#include <span>
#include <string>

namespace sr::viewer {

/// Requests of a person. The bar itself changes speed, direction and looping.
struct AnimationRequest {
    std::optional<Command> command;
    std::optional<double> time;           // [s]
    bool rests = false;                   // to the rest pose
    std::optional<std::string> animation; // as `--animation` takes it
    bool has_pointer = false;             // arrows, Home and End belong to the bar
};
/// Draws the bar above the message area. `scale`: of a HiDPI screen.
AnimationRequest animation_bar(Playback& playback, std::span<const gltf::Contents::AnimationInfo> all,
                               Layout& layout, const Keymap& keys, float scale);

/// Draws the list. @return the variant that was chosen; empty for the file's own materials
std::optional<std::string> variants_section(std::span<const std::string> variants, const std::string& shown);

/// The argument of `--animation` for these animations: a name if it is unique, an index, or "all".
std::string animation_argument(std::span<const gltf::Contents::AnimationInfo> all,
                               std::span<const int> chosen);

} // namespace sr::viewer
