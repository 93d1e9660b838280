#include "core/output.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <unistd.h>

namespace sr {
namespace {

[[noreturn]] void fail(int cause) {
    throw Error("stdout", fmt::format("cannot be written ({}): send it to a place that takes it",
                                      std::strerror(cause)));
}

void write_all(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail(errno);
}

/// The sink that takes remarks; empty: stderr does.
struct Sink {
    std::mutex mutex;
    std::function<void(std::string)> take;
};

Sink& sink() {
    static Sink only;
    return only;
}

/// @return false if there is no sink
bool give_to_sink(const std::string& text) {
    const std::lock_guard lock(sink().mutex);
    if (!sink().take) return false;
    sink().take(text);
    return true;
}

} // namespace

RemarkSink::RemarkSink(std::function<void(std::string)> take) {
    const std::lock_guard lock(sink().mutex);
    require(!sink().take, "one sink takes the remarks");
    sink().take = std::move(take);
}

RemarkSink::~RemarkSink() {
    const std::lock_guard lock(sink().mutex);
    sink().take = nullptr;
}

void write_output(std::string_view text) { write_all(shown_lines(text)); }

void write_json(std::string_view json) {
    write_all(shown_json(json));
    write_all("\n");
}

void write_remark(std::string_view text) {
    while (text.ends_with('\n')) text.remove_suffix(1);
    constexpr std::size_t max_bytes = 4000; // [bytes]
    std::string line = shown(shorten(text, max_bytes));
    if (give_to_sink(line)) return;
    line += '\n';
    std::string_view rest = line; // in one piece, so that lines of several processes do not mix
    while (!rest.empty()) {
        const ssize_t written = ::write(STDERR_FILENO, rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return;
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
}

void flush_output() {
    errno = 0;
    const bool had_failed = std::ferror(stdout) != 0;
    if (std::fflush(stdout) != 0 || had_failed) fail(errno);
}

void occupy_standard_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
        // The lowest number that is free is this one.
        [[maybe_unused]] const int opened =
            open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

void silence_libraries() {
#ifdef __GLIBC__
    if (std::getenv("STERADIAN_LIBRARY_OUTPUT")) return;
    // glibc's manual, section "Standard Streams": these are variables, to be set as any other.
    if (std::FILE* nowhere = std::fopen("/dev/null", "we")) stderr = nowhere;
#endif
}

} // namespace sr
