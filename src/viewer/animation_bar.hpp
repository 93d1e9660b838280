#pragma once
// The bar at the bottom: play, scrub, speed, which animations; and the list of material variants.
#include "viewer/bindings.hpp"
#include "viewer/playback.hpp"

#include <span>
#include <string>

namespace sr::viewer {

/// What a person wants of the bar. It changes speed, direction and looping itself.
struct AnimationWish {
    std::optional<Command> command;
    std::optional<double> time;           // [s]
    bool rests = false;                   // the pose without animations
    std::optional<std::string> animation; // as `--animation` takes it
    bool has_pointer = false;             // ← → Home End are meant for it
};
/// `scale`: of a HiDPI screen.
AnimationWish animation_bar(Playback& playback, std::span<const gltf::Contents::Animation> all, float scale);

/// @return the variant that was chosen: a name, or none for the file's own materials
std::optional<std::string> variants_panel(std::span<const std::string> variants, const std::string& shown);

/// What `--animation` calls these: a name where that is unmistakable, a number, or "all".
std::string animation_argument(std::span<const gltf::Contents::Animation> all, std::span<const int> chosen);

} // namespace sr::viewer
