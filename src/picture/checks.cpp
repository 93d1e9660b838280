#include "picture/checks.hpp"

#include "settings/bad_setting.hpp"

#include <fmt/format.h>

namespace sr::picture {
namespace {

using settings::RenderSettings;

[[noreturn]] void refuse(const char* key, const std::string& problem) {
    throw settings::BadSetting(key, problem);
}

/// Refuses options that only pictures of radiance have, and views that the estimator does not sample.
void check_view(const RenderSettings& settings) {
    if (!settings.view) return;
    if (settings.has_light_layers || settings.asks_for_error())
        refuse("view", fmt::format("'{}' is not radiance, which --layers, --error, --time, --denoise and "
                                   "--aov error need: leave these out",
                                   settings.view->name));
    if (settings.rendering.estimator != render::Estimator::sampled
        && settings.view->finish != output::Finish::luminance)
        refuse("view", fmt::format("'{}' takes points on the lights: leave --estimator at sampled",
                                   settings.view->name));
}

/// Refuses one light a sample where all are needed.
void check_lights(const RenderSettings& settings) {
    if (settings.rendering.lights != render::LightSampling::one) return;
    if (settings.rendering.estimator != render::Estimator::sampled)
        refuse("lights", "one is for --estimator sampled: choose that estimator, or all lights");
    if (settings.visibility == render::Visibility::map)
        refuse("lights", "one needs rays, and --visibility map draws maps of all lights: choose ray or none");
    if (settings.view && settings.view->finish != output::Finish::luminance)
        refuse("lights",
               fmt::format("'{}' visits all lights: choose all, or leave it out", settings.view->name));
}

/// Refuses to filter noise that shadows do not cause, and numbers that a filtered picture does not have.
void check_denoising(const RenderSettings& settings) {
    if (!settings.denoises) return;
    if (settings.rendering.estimator != render::Estimator::analytic)
        refuse("denoise", "filters shadows, the only noise of --estimator analytic: choose that estimator");
    if (settings.visibility == render::Visibility::none)
        refuse("denoise", "filters shadows, and --visibility none has none: choose ray or map");
    if (settings.has_light_layers || settings.view || settings.stop.error)
        refuse("denoise", "a filtered picture has no --layers, --view or --error: leave these out");
    if (settings.stop.samples < 2)
        refuse("denoise", fmt::format("--samples is {}: choose 2 or more", settings.stop.samples));
}

/// Refuses an estimate of the error without two halves of samples.
void check_samples(const RenderSettings& settings) {
    if (output::holds(settings.aovs, output::Finish::error) && settings.stop.samples < 2)
        refuse("aov", fmt::format("error needs two samples, and --samples is {}: choose 2 or more",
                                  settings.stop.samples));
}

} // namespace

void check(const RenderSettings& settings) {
    check_view(settings);
    check_lights(settings);
    check_denoising(settings);
    check_samples(settings);
}

} // namespace sr::picture
