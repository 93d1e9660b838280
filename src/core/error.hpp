#pragma once
// Two of the three kinds of failure: the world's fault (Error) and a bug of ours (require).
// The third, normal absence, is std::optional.
#include <source_location>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sr {

/// A place in a file that a person can open. Line and column count from 1; 0 means unknown.
struct Location {
    std::string file;
    int line = 0;
    int column = 0;

    /// "file", "file:line" or "file:line:column".
    std::string text() const;
};

/// The world's fault: a broken file, a missing driver, a full disk. One line, `file[:line:col]: what: what to
/// do`; the command line prints it and exits with status 3.
class Error : public std::runtime_error {
public:
    Error(const Location& where, std::string_view what, std::string_view what_to_do);
    /// For a failure that no file is to blame for (a missing driver).
    Error(std::string_view what, std::string_view what_to_do);
};

/// Aborts with the caller's file:line if a claim about our own code does not hold.
void require(bool claim, const char* what, std::source_location here = std::source_location::current());

} // namespace sr
