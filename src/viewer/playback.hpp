#pragma once
// Which moment of its animations a file shows, and where it goes from there. Plain data: no GL, no clock.
#include "gltf/asset.hpp"

namespace sr::viewer {

struct Playback {
    static constexpr double frames_per_second = 24.0; // of what a key steps; as `render --fps` has it
    static constexpr double slowest = 0.1, fastest = 4.0;

    std::vector<int> animations;   // that play at once; empty: nothing in the file moves
    double duration = 0.0;         // until the last of them ends [s]
    std::optional<double> seconds; // absent: the rest pose, without any animation
    double speed = 1.0;            // of the file's clock
    bool is_reversed = false;
    bool loops = true;
    bool is_playing = false;

    bool has_any() const { return !animations.empty(); }
    gltf::Moment moment() const;

    /// Other animations; the time stays, as far as they last.
    void choose(std::vector<int> chosen, double lasts);

    /// What `elapsed` seconds do to one that plays: beyond the end it begins anew or, if it does not loop,
    /// stops.
    void advance(double elapsed);
    /// Goes to a time within the animation and stays there [s].
    void go_to(double time);
    /// Goes from one whole frame to another, so many further, and stays there.
    void step(int frames);
    /// Plays on, from the beginning if it stands at the end; or stays where it is.
    void toggle();
};

} // namespace sr::viewer
