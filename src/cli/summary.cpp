#include "cli/summary.hpp"

namespace sr::cli {

void PhaseTimes::end(std::string phase) {
    const auto now = Clock::now();
    phases_.emplace_back(std::move(phase), std::chrono::duration<double>(now - last_).count());
    last_ = now;
}

} // namespace sr::cli
