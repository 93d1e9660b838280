#pragma once
// Times and counts of a rendering, for --json.
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace sr::cli {

/// Seconds by phase, in the order in which they were measured.
class PhaseTimes {
public:
    /// Ends the phase that began when the last one ended (or when this object was made).
    void end(std::string phase);
    /// A phase that ran beside others and was measured elsewhere.
    void add(std::string phase, double seconds) { phases_.emplace_back(std::move(phase), seconds); }

    const std::vector<std::pair<std::string, double>>& phases() const { return phases_; }
    double total() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = begin_;
    std::vector<std::pair<std::string, double>> phases_;
};

} // namespace sr::cli
