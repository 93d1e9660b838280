#include "cli/interruption.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace sr::cli {
namespace {

// A signal handler can reach nothing but what is static. It must not request a stop, which takes a lock: it
// writes to a pipe, and a thread that reads there requests it.
std::atomic<int> signal_count{0};
std::atomic<int> last_signal{0};
std::array<int, 2> pipe_ends{-1, -1};
static_assert(std::atomic<int>::is_always_lock_free);

void wake() { [[maybe_unused]] const ssize_t written = ::write(pipe_ends[1], "", 1); }

void on_signal(int number) {
    last_signal = number;
    if (++signal_count > 1) {
        std::signal(number, SIG_DFL);
        std::raise(number);
    }
    const int error = errno;
    wake();
    errno = error;
}

} // namespace

Interruption::Interruption() {
    signal_count = 0;
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return; // then a signal ends the program
    thread_ = std::thread([source = source_]() mutable {
        char byte = 0;
        while (::read(pipe_ends[0], &byte, 1) < 0 && errno == EINTR) {
        }
        if (signal_count > 0) source.request_stop();
    });
    previous_int_ = std::signal(SIGINT, on_signal);
    previous_term_ = std::signal(SIGTERM, on_signal);
}

Interruption::~Interruption() {
    if (!thread_.joinable()) return;
    std::signal(SIGINT, previous_int_);
    std::signal(SIGTERM, previous_term_);
    wake();
    thread_.join();
    for (const int end : pipe_ends) ::close(end);
}

bool Interruption::asks_to_leave() const { return has_come() && last_signal == SIGTERM; }

} // namespace sr::cli
