#include "gltf/read/animation.hpp"

#include "gltf/read/accessor.hpp"
#include "gltf/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

namespace sr::gltf {
namespace {

glm::dquat quaternion(const double* xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

void slerp(const double* from, const double* to, double t, double* result) {
    const glm::dquat between = glm::slerp(quaternion(from), quaternion(to), t);
    result[0] = between.x, result[1] = between.y, result[2] = between.z, result[3] = between.w;
}

} // namespace

std::vector<double> Track::at(double seconds) const {
    const bool is_cubic = interpolation == Interpolation::cubic_spline;
    // part 0: in-tangent, 1: value, 2: out-tangent
    const auto number = [&](std::size_t key, std::size_t part, std::size_t i) {
        return double{values[(is_cubic ? 3 * key + part : key) * width + i]};
    };
    const auto value = [&](std::size_t key) {
        std::vector<double> numbers(width);
        for (std::size_t i = 0; i < width; ++i) numbers[i] = number(key, 1, i);
        return numbers;
    };
    const auto after = std::upper_bound(times.begin(), times.end(), seconds,
                                        [](double a, float b) { return a < double{b}; });
    const auto next = static_cast<std::size_t>(after - times.begin());
    if (next == 0) return value(0);
    const std::size_t key = next - 1;
    if (next == times.size() || interpolation == Interpolation::step) return value(key);

    const double duration = double{times[next]} - times[key];
    const double t = (seconds - times[key]) / duration;
    std::vector<double> result = value(key);
    if (interpolation == Interpolation::linear) {
        const std::vector<double> end = value(next);
        if (is_rotation)
            slerp(value(key).data(), end.data(), t, result.data());
        else
            for (std::size_t i = 0; i < width; ++i) result[i] = (1.0 - t) * result[i] + t * end[i];
        return result;
    }
    const double t2 = t * t, t3 = t2 * t; // appendix C.5: Hermite's basis
    for (std::size_t i = 0; i < width; ++i)
        result[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * number(key, 1, i)
                    + duration * (t3 - 2.0 * t2 + t) * number(key, 2, i)
                    + (3.0 * t2 - 2.0 * t3) * number(next, 1, i) + duration * (t3 - t2) * number(next, 0, i);
    const double length = is_rotation ? glm::length(quaternion(result.data())) : 1.0;
    if (length > 0.0)
        for (double& n : result) n /= length;
    return result;
}

namespace {

Interpolation parse_interpolation(const std::string& name) {
    if (name == "STEP") return Interpolation::step;
    return name == "CUBICSPLINE" ? Interpolation::cubic_spline : Interpolation::linear;
}

std::vector<float> parse_times(const Document& document, int accessor, const std::string& sampler) {
    std::vector<float> times = numbers(document, accessor);
    if (components_of(document, accessor) != 1 || times.empty())
        document.fail(fmt::format("{}/input has no times", sampler), export_again);
    const bool is_finite = std::ranges::all_of(times, [](float t) { return std::isfinite(t) && t >= 0.0f; });
    if (!is_finite || !std::ranges::is_sorted(times))
        document.fail(fmt::format("{}/input has times that do not increase from zero or later", sampler),
                      export_again);
    return times;
}

/// @param sampler where it stands, for errors
Track parse_track(const Document& document, const AnimationSource::Sampler& source,
                  const AnimatedProperty& property, const std::string& sampler) {
    Track track;
    track.width = property.width();
    track.is_rotation = property.kind() == AnimatedProperty::Kind::rotation;
    track.interpolation = property.kind() == AnimatedProperty::Kind::flag
                              ? Interpolation::step
                              : parse_interpolation(source.interpolation);
    track.times = parse_times(document, source.input, sampler);
    track.values = numbers(document, source.output);
    const std::size_t parts = track.interpolation == Interpolation::cubic_spline ? 3 : 1;
    const std::size_t needed = track.times.size() * parts * track.width;
    if (track.values.size() != needed)
        document.fail(fmt::format("{} has {} numbers in its output, and {} keys of what it moves have {}",
                                  sampler, track.values.size(), track.times.size(), needed),
                      export_again);
    if (!std::ranges::all_of(track.values, [](float v) { return std::isfinite(v); }))
        document.fail(fmt::format("{}/output is not finite", sampler), export_again);
    return track;
}

/// /animations/A/channels/C
struct ChannelPlace {
    std::size_t animation = 0;
    std::size_t channel = 0;
};

/// Appends the channel, if it moves anything, and prolongs the animation to its last key in any case.
void read_channel(Document& document, const ChannelPlace& place, Animation& to, Warnings& warnings) {
    const AnimationSource& source = document.animations[place.animation];
    const AnimationSource::Channel& channel = source.channels[place.channel];
    const std::string pointer = fmt::format("/animations/{}/channels/{}", place.animation, place.channel);
    if (channel.sampler >= source.samplers.size())
        document.fail(fmt::format("{}/sampler is {}, and there are {}", pointer, channel.sampler,
                                  source.samplers.size()),
                      export_again);
    const AnimationSource::Sampler& sampler = source.samplers[channel.sampler];
    if (sampler.input < 0) return; // lost, and warned of
    const std::string sampler_pointer =
        fmt::format("/animations/{}/samplers/{}", place.animation, channel.sampler);
    const double end = parse_times(document, sampler.input, sampler_pointer).back();
    to.duration = std::max(to.duration, end);
    if (channel.pointer.empty())
        return warnings.add(fmt::format("{}/target names no node", pointer), "that channel moves nothing");
    std::optional<AnimatedProperty> property = property_at(document, channel.pointer);
    if (!property)
        return warnings.add(fmt::format("{} moves {}", pointer, in_quotes(channel.pointer)),
                            "that stays as it is: it is not supported, or is not there");
    to.channels.push_back({parse_track(document, sampler, *property, sampler_pointer), *std::move(property)});
}

} // namespace

void Animation::apply(double seconds) {
    for (Channel& channel : channels) channel.property.set(channel.track.at(seconds));
}

void Animation::reset() {
    for (Channel& channel : channels) channel.property.reset();
}

std::vector<Animation> parse_animations(Document& document, Warnings& warnings) {
    std::vector<Animation> animations;
    for (std::size_t a = 0; a < document.animations.size(); ++a) {
        const AnimationSource& source = document.animations[a];
        Animation animation{source.name, 0.0, !document.has_lost(fmt::format("/animations/{}", a)), {}};
        for (std::size_t c = 0; c < source.channels.size(); ++c) {
            const bool is_read = warnings.attempt("what that channel moves stays as it is", [&] {
                read_channel(document, {a, c}, animation, warnings);
            });
            animation.is_whole = animation.is_whole && is_read;
        }
        animations.push_back(std::move(animation));
    }
    return animations;
}

} // namespace sr::gltf
