#include "core/memory_watch.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <unistd.h>

namespace sr {
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
