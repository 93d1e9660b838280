#include "picture/draw.hpp"

#include "core/error.hpp"
#include "output/denoise.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>

namespace sr::picture {
namespace {

using render::StoppedBy;
using render::StopRule;

/// Returns the completed share of the work, from 0 to 1, by the condition nearest to being met.
double share(const StopRule& rule, int samples, double seconds, double error, double first_error) {
    double part = static_cast<double>(samples) / rule.samples;
    if (rule.seconds) part = std::max(part, seconds / *rule.seconds);
    if (rule.error && first_error > *rule.error) // errors fall by powers
        part = std::max(part, std::log(first_error / error) / std::log(first_error / *rule.error));
    return std::clamp(part, 0.0, 1.0);
}

std::string percent(double error) { return fmt::format("{:.3g} %", 100.0 * error); }

std::string state_of(const render::StopMonitor& monitor, int samples) {
    std::string text = fmt::format("{} samples", samples);
    if (const auto error = monitor.error()) text += ", error " + percent(*error);
    if (monitor.rule().error) text += " of " + percent(*monitor.rule().error);
    return text;
}

void tell(const Work& work, const std::string& what, double share, const std::string& state) {
    if (work.progress) work.progress(what, share, state);
}

/// Adds samples, at least one, until the rule or a stop ends it. The renderer estimates its error if
/// the rule needs it.
SamplingEnd add_samples(const Work& work, render::Renderer& renderer, const StopRule& rule,
                        const std::string& what) {
    using Clock = std::chrono::steady_clock;
    render::StopMonitor monitor(rule);
    std::optional<double> first_error;
    do {
        const Clock::time_point begin = Clock::now();
        renderer.add_sample();
        glFinish(); // an interruption, the time and the progress bar count complete samples
        monitor.took_sample(renderer, std::chrono::duration<double>(Clock::now() - begin).count());
        if (!first_error) first_error = monitor.error();
        const int samples = renderer.sample_count();
        const double part = share(rule, samples, monitor.seconds(), monitor.error().value_or(INFINITY),
                                  first_error.value_or(0.0));
        tell(work, what, part, state_of(monitor, samples));
    } while (!monitor.stopped_by() && !work.stop.stop_requested());
    monitor.update_error(renderer);
    return {monitor.stopped_by().value_or(StoppedBy::interruption), monitor.error(), monitor.estimate()};
}

/// Repeats the `count` samples that the renderer had before repeat(). @return false if it was stopped
bool add_again(const Work& work, int count, const std::string& what) {
    render::Renderer& renderer = work.renderer;
    while (renderer.sample_count() < count && !work.stop.stop_requested()) {
        renderer.add_sample();
        glFinish();
        tell(work, what, static_cast<double>(renderer.sample_count()) / count,
             fmt::format("{}/{}", renderer.sample_count(), count));
    }
    return renderer.sample_count() == count;
}

/// Estimates the error of the picture for --aov error. A picture that does not stop by its error is of one
/// sequence of samples; a second rendering of as many samples in two halves tells the error and leaves it as
/// it is.
void estimate_error(const Work& work, Picture& picture) {
    if (picture.stop.estimate || !output::holds(work.settings.aovs, output::Finish::error)) return;
    render::RenderOptions options = work.options;
    options.estimates_error = true;
    render::Renderer renderer(work.scene, work.stage.camera, options);
    StopRule rule = work.settings.stop;
    rule.samples = picture.samples.max;
    const SamplingEnd stop = add_samples(work, renderer, rule, "estimating the error of " + work.what);
    picture.stop.error = stop.error;
    picture.stop.estimate = stop.estimate;
    work.times.end("error");
}

/// Renders the channels of --layers and --aov. After an interruption it leaves out those of the step at hand.
std::vector<output::ImageChannel> render_further_channels(const Work& work, const Picture& picture,
                                                          const std::vector<int>& samples) {
    std::vector<output::ImageChannel> channels;
    if (work.settings.has_light_layers && !work.stop.stop_requested()) {
        channels = output::render_layers(
            output::layer_names(work.stage.lights, output::aov_names()), work.renderer,
            [&](const std::string& layer) { return add_again(work, picture.samples.max, layer); });
        work.times.end("layers");
    }
    if (!work.settings.aovs.empty() && !work.stop.stop_requested()) {
        const output::AovSource source{work.scene, work.stage.camera, work.options, samples,
                                       picture.stop.estimate};
        std::ranges::move(output::render_aovs(work.settings.aovs, source, work.stop),
                          std::back_inserter(channels));
        work.times.end("aovs");
    }
    return channels;
}

} // namespace

Picture draw(const Work& work) {
    Picture picture;
    picture.stop = add_samples(work, work.renderer, work.settings.stop, work.what);
    const std::vector<int> samples = work.renderer.pixel_samples();
    picture.samples = settings::count_samples(samples);
    picture.light_choices = work.renderer.light_choices();
    work.times.end("draw");
    picture.film = work.renderer.read_film();
    if (work.settings.view) picture.film = output::numbers_of(*work.settings.view, picture.film);
    work.times.end("read");
    if (work.settings.denoises && !work.stop.stop_requested()) {
        const output::AovSource source{work.scene, work.stage.camera, work.options, samples, {}};
        picture.film = output::denoise(work.renderer, source, work.stop);
        work.times.end("denoise");
    }
    if (!work.stop.stop_requested()) estimate_error(work, picture);
    const std::vector<output::ImageChannel> channels = render_further_channels(work, picture, samples);
    if (!channels.empty()) picture.layers = output::with_channels(picture.film, channels);
    if (work.stop.stop_requested()) picture.stop.by = StoppedBy::interruption;
    return picture;
}

void describe(Picture& picture, const RenderSettings& settings, const scene::RenderScene& stage,
              const gl::ContextInfo& gl) {
    std::vector<image::Attribute> attributes =
        settings::attributes_of(settings,
                                {.unit = output::unit_of(settings.view, stage.scene.units),
                                 .camera = stage.camera.name,
                                 .samples = picture.samples,
                                 .error = picture.stop.error,
                                 .stopped_by = picture.stop.by,
                                 .light_choices = picture.light_choices},
                                gl);
    std::ranges::move(output::name_tables(settings.aovs, stage.scene), std::back_inserter(attributes));
    picture.film.channel_names = {"R", "G", "B", "A"};
    picture.film.attributes = attributes;
    if (picture.layers) picture.layers->attributes = std::move(attributes);
}

} // namespace sr::picture
