#include "gltf/animation.hpp"

#include "gltf/accessor.hpp"
#include "gltf/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

Interpolation interpolation_of(const std::string& name) {
    if (name == "STEP") return Interpolation::step;
    return name == "CUBICSPLINE" ? Interpolation::cubic_spline : Interpolation::linear;
}

std::vector<float> times_of(const Document& document, int accessor, const std::string& sampler) {
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
Track track_of(const Document& document, const AnimationSource::Sampler& source, const PropertyForm& form,
               const std::string& sampler) {
    Track track;
    track.width = form.width;
    track.is_rotation = form.kind == PropertyForm::Kind::rotation;
    track.interpolation =
        form.kind == PropertyForm::Kind::flag ? Interpolation::step : interpolation_of(source.interpolation);
    track.times = times_of(document, source.input, sampler);
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

} // namespace

void Animation::apply(double seconds) {
    for (Channel& channel : channels) channel.property.set(channel.track.at(seconds));
}

void Animation::reset() {
    for (Channel& channel : channels) channel.property.reset();
}

std::vector<Animation> animations_of(Document& document, Warnings& warnings) {
    std::vector<Animation> animations;
    for (std::size_t a = 0; a < document.animations.size(); ++a) {
        const AnimationSource& source = document.animations[a];
        Animation animation{source.name, 0.0, {}};
        for (std::size_t c = 0; c < source.channels.size(); ++c) {
            const AnimationSource::Channel& channel = source.channels[c];
            if (channel.sampler >= source.samplers.size())
                document.fail(fmt::format("/animations/{}/channels/{}/sampler is {}, and there are {}", a, c,
                                          channel.sampler, source.samplers.size()),
                              export_again);
            if (channel.pointer.empty()) continue;
            std::optional<Property> property = property_at(document, channel.pointer);
            if (!property) {
                warnings.add(fmt::format("an animation moves {}", in_quotes(channel.pointer)),
                             "that stays as it is: it is not supported, or is not there");
                continue;
            }
            Track track = track_of(document, source.samplers[channel.sampler], property->form(),
                                   fmt::format("/animations/{}/samplers/{}", a, channel.sampler));
            animation.duration = std::max(animation.duration, double{track.times.back()});
            animation.channels.push_back({std::move(track), *std::move(property)});
        }
        animations.push_back(std::move(animation));
    }
    return animations;
}

} // namespace sr::gltf
