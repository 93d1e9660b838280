#include "cli/render_checks.hpp"

#include "image/whole_file.hpp"
#include "output/write.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string_view>

namespace sr::cli {
namespace {

std::optional<int> whole(std::string_view text) {
    int value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole = failure == std::errc{} && end == text.data() + text.size() && value >= 0;
    return is_whole ? std::optional(value) : std::nullopt;
}

/// Where a name has its number, and how many digits that has at least.
struct NumberPlace {
    std::size_t begin = 0;
    std::size_t end = 0;
    int digits = 1;
};

std::optional<NumberPlace> place_in(const std::string& name) {
    const auto hash = name.find_last_of('#');
    if (hash != std::string::npos) {
        const auto before = name.find_last_not_of('#', hash);
        const std::size_t begin = before == std::string::npos ? 0 : before + 1;
        return NumberPlace{begin, hash + 1, static_cast<int>(hash + 1 - begin)};
    }
    const auto percent = name.find_last_of('%');
    if (percent == std::string::npos) return std::nullopt;
    const auto d = name.find_first_not_of("0123456789", percent + 1);
    if (d == std::string::npos || name[d] != 'd') return std::nullopt;
    const std::string_view digits = std::string_view(name).substr(percent + 1, d - percent - 1);
    return NumberPlace{percent, d + 1, digits.empty() ? 1 : std::min(whole(digits).value_or(1), 32)};
}

[[noreturn]] void refuse(const char* option, const std::string& problem) {
    throw CLI::ValidationError(option, problem);
}

/// Refuses options that only pictures of radiance have, and views that the estimator does not sample.
void check_view(const RenderCommand& command) {
    if (!command.view) return;
    if (command.has_light_layers || command.asks_for_error())
        refuse("--view", fmt::format("'{}' is not radiance, which --layers, --error, --time, --denoise and "
                                     "--aov error need: leave these out",
                                     command.view->name));
    if (command.rendering.estimator != render::Estimator::sampled
        && command.view->finish != output::Finish::luminance)
        refuse("--view", fmt::format("'{}' takes points on the lights: leave --estimator at sampled",
                                     command.view->name));
}

/// Refuses one light a sample where all are needed.
void check_lights(const RenderCommand& command) {
    if (command.rendering.lights != render::LightSampling::one) return;
    if (command.rendering.estimator != render::Estimator::sampled)
        refuse("--lights", "one is for --estimator sampled: choose that estimator, or all lights");
    if (command.visibility == render::Visibility::map)
        refuse("--lights",
               "one needs rays, and --visibility map draws maps of all lights: choose ray or none");
    if (command.view && command.view->finish != output::Finish::luminance)
        refuse("--lights",
               fmt::format("'{}' visits all lights: choose all, or leave it out", command.view->name));
}

/// Refuses to filter noise that shadows do not cause, and numbers that a filtered picture does not have.
void check_denoising(const RenderCommand& command) {
    if (!command.denoises) return;
    if (command.rendering.estimator != render::Estimator::analytic)
        refuse("--denoise", "filters shadows, the only noise of --estimator analytic: choose that estimator");
    if (command.visibility == render::Visibility::none)
        refuse("--denoise", "filters shadows, and --visibility none has none: choose ray or map");
    if (command.has_light_layers || command.view || command.stop.error)
        refuse("--denoise", "a filtered picture has no --layers, --view or --error: leave these out");
    if (command.stop.samples < 2)
        refuse("--denoise", fmt::format("--samples is {}: choose 2 or more", command.stop.samples));
}

/// Refuses outputs that cannot be written, and channels without a file that holds them.
void check_outputs(const RenderCommand& command) {
    for (const std::string& output : command.outputs) {
        image::is_scene_referred(output);
        if (command.frames && !numbered(output, 0))
            refuse("-o", fmt::format("'{}' has no place for the frame's number: name it like frame.####.png",
                                     output));
        image::require_writable(command.frames ? *numbered(output, 0) : output);
    }
    if (output::holds(command.aovs, output::Finish::error) && command.stop.samples < 2)
        refuse("--aov", fmt::format("error needs two samples, and --samples is {}: choose 2 or more",
                                    command.stop.samples));
    if (std::ranges::any_of(command.outputs, output::holds_layers)) return;
    for (const auto& [is_given, option] :
         {std::pair(command.has_light_layers, "--layers"), std::pair(!command.aovs.empty(), "--aov")})
        if (is_given) refuse(option, "only .exr files hold further channels: name one with -o");
}

} // namespace

void check(const RenderCommand& command) {
    check_view(command);
    check_lights(command);
    check_denoising(command);
    check_outputs(command);
}

std::optional<std::string> numbered(const std::string& pattern, int frame) {
    const std::size_t slash = pattern.find_last_of("/\\");
    const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
    const auto place = place_in(pattern.substr(name));
    if (!place) return std::nullopt;
    return fmt::format("{}{:0{}}{}", pattern.substr(0, name + place->begin), frame, place->digits,
                       pattern.substr(name + place->end));
}

} // namespace sr::cli
