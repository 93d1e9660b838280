#include "cli/render_checks.hpp"

#include "cli/frame_names.hpp"
#include "image/whole_file.hpp"
#include "output/write.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

namespace sr::cli {
namespace {

/// Refuses what a view is no picture of.
void check_view(const RenderCommand& command) {
    if (!command.view) return;
    if (command.has_light_layers || command.asks_for_error())
        throw CLI::ValidationError(
            "--view", "only pictures of radiance have --layers, --error, --time and --aov error");
    if (command.rendering.estimator != render::Estimator::sampled
        && command.view->finish != output::Finish::luminance)
        throw CLI::ValidationError("--view",
                                   "this one takes points on the lights: leave --estimator at sampled");
}

/// Refuses to filter what has more noise than shadows, or numbers that would no longer belong together.
void check_denoising(const RenderCommand& command) {
    if (!command.denoises) return;
    if (command.rendering.estimator != render::Estimator::analytic
        || command.visibility == render::Visibility::none)
        throw CLI::ValidationError("--denoise", "only shadows are filtered, of --estimator analytic");
    if (command.has_light_layers || command.view || command.stop.error)
        throw CLI::ValidationError("--denoise", "a filtered picture has no --layers, --view or --error");
    if (command.stop.samples < 2) throw CLI::ValidationError("--denoise", "takes --samples 2 at least");
}

/// Refuses what cannot be written.
void check_outputs(const RenderCommand& command) {
    for (const std::string& output : command.outputs) {
        image::is_scene_referred(output);
        if (command.frames && !numbered(output, 0))
            throw CLI::ValidationError("-o", fmt::format("'{}' has no place for the frame's number: name it "
                                                         "like frame.####.png",
                                                         output));
        image::require_writable(command.frames ? *numbered(output, 0) : output);
    }
    if (output::holds(command.aovs, output::Finish::error) && command.stop.samples < 2)
        throw CLI::ValidationError("--aov", "error takes --samples 2 at least");
    if (std::ranges::any_of(command.outputs, output::holds_layers)) return;
    for (const auto& [is_asked, option] :
         {std::pair(command.has_light_layers, "--layers"), std::pair(!command.aovs.empty(), "--aov")})
        if (is_asked) throw CLI::ValidationError(option, "only .exr files hold layers: name one with -o");
}

} // namespace

void check(const RenderCommand& command) {
    check_view(command);
    check_denoising(command);
    check_outputs(command);
}

} // namespace sr::cli
