#include "render/adaptive/convergence.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

namespace sr::render {
namespace {

constexpr int first_estimate = 8;

/// No pixel is frozen before that: light that one sample in fifty finds would be taken for darkness.
constexpr int first_freeze = 64;

/// The part of a target's square that a pixel's surroundings must be under to be frozen. Those frozen early
/// are not the ones that matter; without it, too many would end just under the target.
constexpr float freeze_share = 0.5f;

/// The side of the blocks of pixels that are frozen together: enough to tell an error by, few enough to
/// follow a penumbra.
constexpr int block_side = 4;

/// A picture of blocks.
struct Blocks {
    int columns = 0;
    int rows = 0;
    std::vector<float> values;

    Blocks(int width, int height)
        : columns((width + block_side - 1) / block_side),
          rows((height + block_side - 1) / block_side),
          values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0.0f) {}

    float& at(int column, int row) {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns)
                      + static_cast<std::size_t>(column)];
    }
};

/// The mean square of each block.
Blocks block_squares(const ErrorEstimate& estimate) {
    Blocks sums(estimate.width, estimate.height);
    std::size_t i = 0;
    for (int y = 0; y < estimate.height; ++y)
        for (int x = 0; x < estimate.width; ++x)
            sums.at(x / block_side, y / block_side) += estimate.squares[i++];
    for (int row = 0; row < sums.rows; ++row) {
        for (int column = 0; column < sums.columns; ++column) {
            const int width = std::min(block_side, estimate.width - column * block_side);
            const int height = std::min(block_side, estimate.height - row * block_side);
            sums.at(column, row) /= static_cast<float>(width * height);
        }
    }
    return sums;
}

/// The largest value of each block and the eight around it: an edge that has just entered one block is in the
/// next.
Blocks with_surroundings(Blocks blocks) {
    Blocks largest = blocks;
    for (int row = 0; row < blocks.rows; ++row) {
        for (int column = 0; column < blocks.columns; ++column) {
            for (int y = std::max(0, row - 1); y <= std::min(blocks.rows - 1, row + 1); ++y)
                for (int x = std::max(0, column - 1); x <= std::min(blocks.columns - 1, column + 1); ++x)
                    largest.at(column, row) = std::max(largest.at(column, row), blocks.at(x, y));
        }
    }
    return largest;
}

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
    const PixelMask frozen = converged();
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

PixelMask Convergence::converged() const {
    const float most = freeze_share * static_cast<float>(target_ * target_);
    Blocks largest = with_surroundings(block_squares(*estimate_));
    PixelMask mask;
    mask.reserve(estimate_->squares.size());
    for (int y = 0; y < estimate_->height; ++y)
        for (int x = 0; x < estimate_->width; ++x)
            mask.push_back(largest.at(x / block_side, y / block_side) <= most ? 1 : 0);
    return mask;
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
