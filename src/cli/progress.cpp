#include "cli/progress.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>
#include <unistd.h>

namespace sr::cli {
namespace {

/// Writes control characters as they are; what cannot be written is lost.
void write_status(std::string_view text) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

} // namespace

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

} // namespace sr::cli
