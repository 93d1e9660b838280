#include "cli/interruption.hpp"

#include <atomic>
#include <csignal>

namespace sr::cli {
namespace {

// A signal handler can reach nothing but what is static.
std::atomic<int> signal_count{0};
std::atomic<int> last_signal{0};
static_assert(std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
    last_signal = number;
    if (++signal_count > 1) {
        std::signal(number, SIG_DFL);
        std::raise(number);
    }
}

} // namespace

Interruption::Interruption() {
    signal_count = 0;
    previous_int_ = std::signal(SIGINT, on_signal);
    previous_term_ = std::signal(SIGTERM, on_signal);
}

Interruption::~Interruption() {
    std::signal(SIGINT, previous_int_);
    std::signal(SIGTERM, previous_term_);
}

bool Interruption::has_come() const { return signal_count > 0; }

bool Interruption::asks_to_leave() const { return has_come() && last_signal == SIGTERM; }

} // namespace sr::cli
