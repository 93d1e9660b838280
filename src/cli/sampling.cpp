#include "cli/sampling.hpp"

#include "cli/progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace sr::cli {
namespace {

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

} // namespace

Stop add_samples(render::Renderer& renderer, const StopRule& rule, const std::stop_token& stop,
                 const std::string& what) {
    using Clock = std::chrono::steady_clock;
    render::StopMonitor monitor(rule);
    Progress progress(what);
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
        progress.update(part, state_of(monitor, samples));
    } while (!monitor.stopped_by() && !stop.stop_requested());
    monitor.update_error(renderer);
    return {monitor.stopped_by().value_or(StoppedBy::interruption), monitor.error(), monitor.estimate()};
}

bool add_again(render::Renderer& renderer, int count, const std::stop_token& stop, const std::string& what) {
    Progress progress(what);
    while (renderer.sample_count() < count && !stop.stop_requested()) {
        renderer.add_sample();
        glFinish();
        progress.update(static_cast<double>(renderer.sample_count()) / count,
                        fmt::format("{}/{}", renderer.sample_count(), count));
    }
    return renderer.sample_count() == count;
}

} // namespace sr::cli
