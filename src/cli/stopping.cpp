#include "cli/stopping.hpp"

#include "cli/progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace sr::cli {
namespace {

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_ = Clock::now();
};

/// How much of the way is gone, by the condition that has come nearest.
double share(const StopRule& rule, int samples, double seconds, double error, double first_error) {
    double part = static_cast<double>(samples) / rule.samples;
    if (rule.seconds) part = std::max(part, seconds / *rule.seconds);
    if (rule.error && first_error > *rule.error) // errors fall by powers
        part = std::max(part, std::log(first_error / error) / std::log(first_error / *rule.error));
    return std::clamp(part, 0.0, 1.0);
}

std::string percent(double error) { return fmt::format("{:.3g} %", 100.0 * error); }

/// The loop of add_samples.
class Sampling {
public:
    Sampling(render::Renderer& renderer, const StopRule& rule, const std::string& what)
        : renderer_(renderer),
          rule_(rule),
          estimates_error_(renderer.estimates_error()),
          convergence_(rule.error.value_or(0.0)),
          progress_(what) {}

    StoppedBy run(const Interruption& interruption) {
        while (true) {
            const double before = watch_.seconds();
            renderer_.add_sample();
            glFinish(); // so that Ctrl-C, the time and the progress bar mean what they say
            if (estimates_error_ && render::is_time_to_look(renderer_.sample_count())) look();
            const double now = watch_.seconds();
            if (rule_.error && convergence_.is_reached()) return StoppedBy::error;
            if (renderer_.sample_count() >= rule_.samples) return StoppedBy::samples;
            if (rule_.error && renderer_.all_rest()) return StoppedBy::error;
            if (rule_.seconds && now + (now - before) > *rule_.seconds) return StoppedBy::time;
            if (interruption.has_come()) return StoppedBy::interruption;
            show(now);
        }
    }

    Stop stopped(StoppedBy by) {
        if (!estimates_error_ || renderer_.sample_count() < 2) return {by, {}, {}};
        if (looked_at_ != renderer_.sample_count()) look();
        return {by, convergence_.error(), convergence_.seen()};
    }

private:
    void look() {
        convergence_.look(renderer_);
        looked_at_ = renderer_.sample_count();
        if (first_error_ == 0.0) first_error_ = convergence_.error();
    }

    void show(double seconds) {
        const double part =
            share(rule_, renderer_.sample_count(), seconds, convergence_.error(), first_error_);
        std::string text = fmt::format("{} samples", renderer_.sample_count());
        if (first_error_ > 0.0) text += ", error " + percent(convergence_.error());
        if (rule_.error) text += " of " + percent(*rule_.error);
        progress_.update(part, text);
    }

    render::Renderer& renderer_;
    const StopRule& rule_;
    bool estimates_error_;
    render::Convergence convergence_;
    Progress progress_;
    Stopwatch watch_;
    int looked_at_ = 0;
    double first_error_ = 0.0;
};

} // namespace

const char* name_of(StoppedBy reason) {
    switch (reason) {
    case StoppedBy::samples: return "samples";
    case StoppedBy::time: return "time";
    case StoppedBy::error: return "error";
    case StoppedBy::interruption: return "interruption";
    }
    return "";
}

Stop add_samples(render::Renderer& renderer, const StopRule& rule, const Interruption& interruption,
                 const std::string& what) {
    Sampling sampling(renderer, rule, what);
    return sampling.stopped(sampling.run(interruption));
}

bool add_again(render::Renderer& renderer, int count, const Interruption& interruption,
               const std::string& what) {
    Progress progress(what);
    while (renderer.sample_count() < count && !interruption.has_come()) {
        renderer.add_sample();
        glFinish();
        progress.update(static_cast<double>(renderer.sample_count()) / count,
                        fmt::format("{}/{}", renderer.sample_count(), count));
    }
    return renderer.sample_count() == count;
}

} // namespace sr::cli
