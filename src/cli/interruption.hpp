#pragma once
// Ctrl-C and SIGTERM, noticed instead of obeyed at once.

namespace sr::cli {

/// While one lives, the first signal is only remembered; the second ends the program.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Any thread may ask.
    bool has_come() const;
    /// Returns whether it was SIGTERM, which ends the program without a file; after Ctrl-C the picture so far
    /// is written.
    bool asks_to_leave() const;

private:
    void (*previous_int_)(int);
    void (*previous_term_)(int);
};

} // namespace sr::cli
