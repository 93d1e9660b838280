#include "core/parallel.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace sr {

void require_threads() {
    constexpr unsigned others = 4, max_threads = 36;
    std::vector<std::jthread> threads; // each waits for its stop request, at the latest here
    for (unsigned i = 0; i < std::min(std::thread::hardware_concurrency() + others, max_threads); ++i)
        threads.emplace_back([](const std::stop_token& stop) {
            std::mutex mutex;
            std::unique_lock lock(mutex);
            std::condition_variable_any().wait(lock, stop, [] { return false; });
        });
}

} // namespace sr
