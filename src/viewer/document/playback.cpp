#include "viewer/document/playback.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {

gltf::AnimationTime Playback::moment() const {
    return seconds ? gltf::AnimationTime{animations, *seconds} : gltf::AnimationTime{};
}

void Playback::choose(std::vector<int> chosen, double lasts) {
    animations = std::move(chosen);
    duration = lasts;
    if (seconds) seconds = std::min(*seconds, duration);
}

void Playback::advance(double elapsed) {
    if (!is_playing) return;
    const double at = seconds.value_or(0.0) + elapsed * (is_reversed ? -speed : speed);
    if (at >= 0.0 && at <= duration) {
        seconds = at;
    } else if (loops && duration > 0.0) {
        seconds = at - duration * std::floor(at / duration);
    } else {
        seconds = std::clamp(at, 0.0, duration);
        is_playing = false;
    }
}

void Playback::go_to(double time) {
    seconds = std::clamp(time, 0.0, duration);
    is_playing = false;
}

void Playback::step(int frames) {
    constexpr double rounding = 1e-3; // [frames]
    const double now = seconds.value_or(0.0) * frames_per_second;
    const double whole = frames > 0 ? std::floor(now + rounding) : std::ceil(now - rounding);
    go_to((whole + frames) / frames_per_second);
}

void Playback::toggle() {
    is_playing = !is_playing;
    const double end = is_reversed ? 0.0 : duration;
    if (is_playing && seconds == end) seconds = is_reversed ? duration : 0.0;
}

} // namespace sr::viewer
