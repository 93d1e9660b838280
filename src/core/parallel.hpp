#pragma once
// Work on several threads, or on fewer where the system gives no more.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace sr {

/// Calls `work` on up to `count` threads at once, of which the caller's is one, and waits for all of them.
/// Each call takes its share from a counter that they have in common, so that fewer threads do the same work.
template<typename Work>
void on_threads(int count, const Work& work) {
    std::vector<std::jthread> threads;
    try {
        for (int i = 1; i < count; ++i) threads.emplace_back([&work] { work(); });
    } catch (const std::system_error&) { // a limit on threads or on memory: those that run are enough
    }
    work();
}

/// Calls `work(row)` for each of 0..rows once, on at most `max_threads` cores.
template<typename Work>
void for_each_row(int rows, const Work& work, int max_threads = 256) {
    std::atomic<int> next = 0;
    const int cores = std::min(max_threads, static_cast<int>(std::thread::hardware_concurrency()));
    on_threads(std::min(rows, cores), [&] {
        for (int row = next++; row < rows; row = next++) work(row);
    });
}

/// Runs `work` on its own thread, or in the caller of get() if no thread can be started.
template<typename Work>
auto started(Work work) -> std::future<decltype(work())> {
    const auto kept = std::make_shared<Work>(std::move(work));
    const auto run = [kept] { return (*kept)(); };
    try {
        return std::async(std::launch::async, run);
    } catch (const std::system_error&) {
        return std::async(std::launch::deferred, run);
    }
}

/// True if get() of what started() returned waits for no other thread: the work is done, or no thread was to
/// be had and get() does it.
template<typename Value>
bool is_done(const std::future<Value>& work) {
    return work.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
}

/// Starts as many threads as a library may want, one for each core and a few more, and ends them. Software
/// OpenGL and what OpenImageIO loads wait for ever for a thread that the system refuses, so this comes
/// before.
/// @throws std::system_error if the system refuses one
void require_threads();

} // namespace sr
