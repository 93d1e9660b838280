#include "gl/trial_pipe.hpp"

#include <cerrno>
#include <cstdint>
#include <unistd.h>

namespace sr::gl {
namespace {

/// Calls read() or write() until all of it is done.
template<typename Byte, typename Call>
bool all_of(Call call, int descriptor, Byte* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t done = call(descriptor, bytes, count);
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) return false;
        bytes += done;
        count -= static_cast<std::size_t>(done);
    }
    return true;
}

} // namespace

bool write_text(int descriptor, const std::string& text) {
    const std::uint64_t size = text.size();
    return all_of(::write, descriptor, reinterpret_cast<const char*>(&size), sizeof size)
           && all_of(::write, descriptor, text.data(), text.size());
}

bool read_text(int descriptor, std::string& text) {
    std::uint64_t size = 0;
    if (!all_of(::read, descriptor, reinterpret_cast<char*>(&size), sizeof size)) return false;
    text.resize(size);
    return all_of(::read, descriptor, text.data(), text.size());
}

bool write_answer(int descriptor) { return all_of(::write, descriptor, "k", 1); }

bool read_answer(int descriptor) {
    char answer = 0;
    return all_of(::read, descriptor, &answer, 1);
}

} // namespace sr::gl
