#include "cli/progress.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace sr::cli {

Progress::Progress(std::string what) : what_(std::move(what)), is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (is_shown_) std::fputs("\r\033[K", stderr);
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
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
}

} // namespace sr::cli
