#pragma once
// Another program that reads what is written to it: an encoder, a clipboard.
#include "core/file.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace sr {

/// Returns the program of this name in PATH; empty if there is none.
std::filesystem::path program_in_path(std::string_view name);

/// A running program with a pipe to its stdin. Its stdout is dropped. SIGPIPE is ignored in this process.
class PipedProgram {
public:
    /// Starts words[0], a path, with the other words as arguments, without a shell. @throws Error if that
    /// fails
    explicit PipedProgram(std::vector<std::string> words);
    /// Kills it if it still runs.
    ~PipedProgram();
    PipedProgram(const PipedProgram&) = delete;
    PipedProgram& operator=(const PipedProgram&) = delete;

    /// Writes all of the bytes, for as long as that takes. @return false if the program has ended before, or
    /// the stop has come
    bool write(std::span<const std::uint8_t> bytes, const std::stop_token& stop = {});
    /// Ends its input and waits for its end. @return true if it exits with 0; false also if the stop has come
    bool finish(const std::stop_token& stop = {});
    /// The first line that it has written to stderr, or else how it has ended.
    std::string complaint() const;

private:
    void close_input();

    ScratchFolder scratch_{"pipe"};
    pid_t pid_ = 0;   // 0: it has ended, and is waited for
    int input_ = -1;  // its stdin
    int status_ = -1; // as waitpid() has it, once it has ended
};

} // namespace sr
