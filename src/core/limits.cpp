#include "core/limits.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

namespace sr {
namespace {

static_assert(all_limits.size() == static_cast<std::size_t>(Limit::pixels) + 1);

/// 0 where the value is the default. Set once at the start, read by any thread.
std::array<std::atomic<std::uint64_t>, all_limits.size()> set_values{};

} // namespace

std::uint64_t limit(Limit limit) {
    const auto index = static_cast<std::size_t>(limit);
    const std::uint64_t value = set_values[index];
    return value > 0 ? value : all_limits[index].value;
}

std::string set_limit(std::string_view text) {
    const auto equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    std::string names;
    for (std::size_t i = 0; i < all_limits.size(); ++i) {
        names += fmt::format("{}{}", i > 0 ? ", " : "", all_limits[i].name);
        if (name != all_limits[i].name) continue;
        const std::string_view digits = equals == text.npos ? "" : text.substr(equals + 1);
        std::uint64_t value = 0;
        const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (failure != std::errc{} || end != digits.data() + digits.size() || value == 0)
            return fmt::format("'{}' is not a limit: write {}=N with a whole number from 1", text, name);
        set_values[i] = value;
        return {};
    }
    return fmt::format("'{}' is not a limit: write NAME=N with one of {}", text, names);
}

void set_limits_from_environment() {
    const char* variable = std::getenv("STERADIAN_LIMITS");
    std::string_view rest = variable ? variable : "";
    while (!rest.empty()) {
        const auto comma = std::min(rest.find(','), rest.size());
        if (const std::string problem = set_limit(rest.substr(0, comma)); !problem.empty())
            throw Error("STERADIAN_LIMITS", problem);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
}

void check_limit(Limit which, std::uint64_t count, const std::string& file) {
    const auto& [name, usual, what] = all_limits[static_cast<std::size_t>(which)];
    if (count <= limit(which)) return;
    throw Error({file}, fmt::format("asks for {} {}, more than {}", count, what, limit(which)),
                fmt::format("simplify it, or allow that much with --limit {}={}", name, count));
}

void Tally::add(std::uint64_t count) {
    sum_ += count;
    check_limit(limit_, sum_, file_);
}

namespace {

/// 0 if it is not known.
std::uint64_t resident_bytes() {
    std::ifstream stream("/proc/self/statm");
    std::uint64_t all = 0, resident = 0;
    stream >> all >> resident;
    return stream ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

} // namespace

MemoryWatch::MemoryWatch(std::uint64_t bytes)
    : thread_([most = resident_bytes() + bytes](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
              if (resident_bytes() > most) raise(SIGKILL);
              std::this_thread::sleep_for(std::chrono::milliseconds(2));
          }
      }) {}

} // namespace sr
