#include "cli/sampling.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <unistd.h>

namespace sr::cli {
namespace {

/// Writes control characters as they are; what cannot be written is lost.
void write_status(std::string_view text) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// A bar that shows itself when the work has taken a second, and only on a terminal.
class Progress {
public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `share` of the work is done, 0 to 1; `state` says it in the work's own terms.
    void update(double share, const std::string& state);

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool is_terminal_;
    bool is_shown_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = begin_;
};

Progress::Progress(std::string what) : what_(std::move(what)), is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (is_shown_) write_status("\r\033[K");
}

void Progress::update(double share, const std::string& state) {
    using namespace std::chrono_literals;
    const auto now = Clock::now();
    if (!is_terminal_ || now - begin_ < 1s || now - last_ < 100ms) return;
    last_ = now;
    is_shown_ = true;
    constexpr int bar = 30;
    const int filled = std::clamp(static_cast<int>(bar * share), 0, bar);
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    const double left = share > 0.0 ? elapsed * (1.0 - share) / share : 0.0;
    const std::string line = fmt::format("\r{} [{:#<{}}{:.<{}}] {}, {:.0f} s left\033[K", shown(what_), "",
                                         filled, "", bar - filled, state, left);
    write_status(line);
}

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
