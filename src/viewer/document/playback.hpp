#pragma once
// Playback of a file's animations. Plain data: no GL, no clock.
#include "gltf/asset.hpp"

namespace sr::viewer {

struct Playback {
    static constexpr double frames_per_second = 24.0; // of the steps of a key; the default of `render --fps`
    static constexpr double min_speed = 0.1, max_speed = 4.0;

    std::vector<int> animations;   // that play together; empty if the file has none
    double duration = 0.0;         // until the last one ends [s]
    std::optional<double> seconds; // absent for the rest pose
    double speed = 1.0;            // 1: real time
    bool is_reversed = false;
    bool loops = true;
    bool is_playing = false;

    bool has_any() const { return !animations.empty(); }
    gltf::AnimationTime moment() const;

    /// Chooses other animations. The time stays, up to their end.
    void choose(std::vector<int> chosen, double lasts);

    /// Advances by `elapsed` seconds, if it plays. At the end it restarts or, if it does not loop, stops.
    void advance(double elapsed);
    /// Goes to a time [s], clamped to the animation, and stops.
    void go_to(double time);
    /// Steps by so many frames, to a whole frame, and stops.
    void step(int frames);
    /// Starts, from the beginning if it is at the end, or stops.
    void toggle();
};

} // namespace sr::viewer
