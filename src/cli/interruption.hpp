#pragma once
// Ctrl-C and SIGTERM as a std::stop_token.
#include <stop_token>
#include <thread>

namespace sr::cli {

/// While one lives, the first signal requests the stop, and the second ends the program.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    std::stop_token token() const { return source_.get_token(); }
    bool has_come() const { return source_.stop_requested(); }
    /// Returns whether it was SIGTERM, which ends the program without a file; after Ctrl-C the picture so far
    /// is written.
    bool asks_to_leave() const;

private:
    std::stop_source source_;
    std::thread thread_; // waits for the signal
    void (*previous_int_)(int);
    void (*previous_term_)(int);
};

} // namespace sr::cli
