#pragma once
// Output of the program: data on stdout, which must arrive, and remarks on stderr, which may be lost.
#include <fmt/format.h>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace sr {

/// Writes to stdout, control characters shown (core/text.hpp). @throws Error if stdout is closed or full
void write_output(std::string_view text);

/// Writes a JSON text and a line break to stdout. @throws Error if stdout is closed or full
void write_json(std::string_view json);

/// Writes one line to stderr, whatever the text holds. Nothing happens if it cannot be written.
void write_remark(std::string_view text);

/// Takes the remarks of all threads instead of stderr for as long as it lives; one at a time. `take` may be
/// called by any thread, by one after the other.
class RemarkSink {
public:
    explicit RemarkSink(std::function<void(std::string)> take);
    ~RemarkSink();
    RemarkSink(const RemarkSink&) = delete;
    RemarkSink& operator=(const RemarkSink&) = delete;
};

/// Sends what is left in stdout's buffer. @throws Error if it cannot be written
void flush_output();

/// Opens /dev/null for each of stdin, stdout and stderr that is closed, in such a way that writing to it
/// fails: otherwise the next file that is opened would take its number, and messages would go there.
void occupy_standard_streams();

/// Formats and writes to stdout. @throws Error if stdout is closed or full
template<typename... Values>
void print_data(fmt::format_string<Values...> format, Values&&... values) {
    write_output(fmt::format(format, std::forward<Values>(values)...));
}

/// Formats and writes one line to stderr.
template<typename... Values>
void print_remark(fmt::format_string<Values...> format, Values&&... values) {
    write_remark(fmt::format(format, std::forward<Values>(values)...));
}

/// Discards what C libraries print to `stderr`, such as libpng's own line before the error that it returns.
/// Our own remarks and sanitizers use the descriptor instead, which stays. Does nothing if
/// STERADIAN_LIBRARY_OUTPUT is set, for those who debug a driver, and with C libraries other than glibc.
void silence_libraries();

} // namespace sr
