#include "render/adaptive/convergence.hpp"

#include "render/adaptive/allocation.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

namespace sr::render {
namespace {

constexpr int first_estimate = 8;

/// No pixel is frozen before that: light that one sample in fifty finds would be taken for darkness.
constexpr int first_freeze = 64;

} // namespace

bool is_estimate_due(int samples) {
    if (samples < first_estimate) return false;
    const auto n = static_cast<unsigned>(samples);
    return std::has_single_bit(n) || (n % 3 == 0 && std::has_single_bit(n / 3));
}

void Convergence::update(Renderer& renderer) {
    estimate_ = renderer.estimate_error();
    const std::vector<int> samples = renderer.pixel_samples();
    is_confirmed_ = !samples_.empty();
    if (is_confirmed_) remember(samples);
    squares_ = estimate_->squares;
    samples_ = samples;
    if (target_ == 0.0 || is_reached() || renderer.sample_count() < first_freeze) return;
    const PixelMask frozen = with_enough_samples(*estimate_, samples, renderer.sample_count(), target_);
    if (std::ranges::find(frozen, 0) == frozen.end()) return; // someone has to go on
    renderer.freeze(frozen);
}

void Convergence::remember(const std::vector<int>& samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i] == samples_[i])
            estimate_->squares[i] = squares_[i]; // it is frozen
        else {
            const float ratio = static_cast<float>(samples_[i]) / static_cast<float>(samples[i]);
            estimate_->squares[i] = 0.5f * (estimate_->squares[i] + ratio * squares_[i]);
        }
    }
    sum_up(*estimate_);
}

const char* name_of(StoppedBy reason) {
    switch (reason) {
    case StoppedBy::samples: return "samples";
    case StoppedBy::time: return "time";
    case StoppedBy::error: return "error";
    case StoppedBy::interruption: return "interruption";
    }
    return "";
}

void StopMonitor::restart() { *this = StopMonitor(StopRule(rule_)); }

bool StopMonitor::took_sample(Renderer& renderer, double seconds) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    if (is_estimate_due(renderer.sample_count())) update_error(renderer);
    seconds += std::chrono::duration<double>(Clock::now() - begin).count();
    seconds_ += seconds;
    stopped_by_ = condition_met(renderer, seconds);
    if (stopped_by_) update_error(renderer);
    return estimated_at_ == renderer.sample_count()
           && renderer.converged_pixels().any(renderer.sample_count());
}

void StopMonitor::update_error(Renderer& renderer) {
    const int samples = renderer.sample_count();
    if (!renderer.estimates_error() || samples < 2 || estimated_at_ == samples) return;
    convergence_.update(renderer);
    estimated_at_ = samples;
}

std::optional<double> StopMonitor::error() const {
    return estimate() ? std::optional(estimate()->error) : std::nullopt;
}

std::optional<StoppedBy> StopMonitor::condition_met(const Renderer& renderer, double last_seconds) const {
    if (rule_.error && convergence_.is_reached()) return StoppedBy::error;
    if (renderer.sample_count() >= rule_.samples) return StoppedBy::samples;
    if (rule_.error && renderer.is_frozen()) return StoppedBy::error;
    if (rule_.seconds && seconds_ + last_seconds > *rule_.seconds) return StoppedBy::time;
    return std::nullopt;
}

} // namespace sr::render
