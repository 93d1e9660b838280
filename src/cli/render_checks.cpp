#include "cli/render_checks.hpp"

#include "image/video.hpp"
#include "image/whole_file.hpp"
#include "output/write.hpp"
#include "picture/checks.hpp"

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

/// Refuses outputs that cannot be written, and channels without a file that holds them.
void check_outputs(const RenderCommand& command) {
    const bool is_sequence = command.is_sequence();
    for (const std::string& output : command.outputs) {
        if (image::is_video(output)) {
            if (!is_sequence)
                refuse("-o", fmt::format("'{}' is a video of several pictures: add --frames or --turntable",
                                         output));
            image::require_video_encoder(output);
            image::require_writable(output);
            continue;
        }
        image::is_scene_referred(output);
        if (is_sequence && !numbered(output, 0))
            refuse("-o", fmt::format("'{}' has no place for the frame's number: name it like frame.####.png",
                                     output));
        image::require_writable(is_sequence ? *numbered(output, 0) : output);
    }
    if (std::ranges::any_of(command.outputs, output::holds_layers)) return;
    for (const auto& [is_given, option] :
         {std::pair(command.has_light_layers, "--layers"), std::pair(!command.aovs.empty(), "--aov")})
        if (is_given) refuse(option, "only .exr files hold further channels: name one with -o");
}

} // namespace

void check(const RenderCommand& command) {
    if (command.frames && command.at && !command.turntable)
        refuse("--frames", "is a sequence of moments, and --at is one: leave one of them out");
    const bool has_use_of_rate = command.turntable ? std::ranges::any_of(command.outputs, image::is_video)
                                                   : command.frames.has_value();
    if (command.has_rate && !has_use_of_rate)
        refuse("--fps", "is the rate of --frames, and of a video: add --frames, or name a video with -o");
    picture::check(command);
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
