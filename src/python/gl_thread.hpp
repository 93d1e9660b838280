#pragma once
// The thread that owns the OpenGL context, and calls that wait for work without the GIL.
//
// A context is current on one thread, and Python calls from many. Work runs on the GL thread, which never
// takes the GIL. The caller waits without the GIL, looks for signals every 50 ms and tells the progress.
#include "gl/context.hpp"

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <nanobind/nanobind.h>
#include <stop_token>
#include <string>
#include <sys/types.h>
#include <thread>
#include <vector>

namespace sr::python {

/// A piece of work that another thread does for a caller in Python.
class Call {
public:
    explicit Call(std::function<void(Call&)> work) : work_(std::move(work)) {}

    std::stop_token stop() const { return stop_.get_token(); }
    /// The state of the work. Any thread may tell it.
    void tell(const std::string& what, double share, const std::string& state);

    /// Does the work on this thread.
    void work();

    /// Waits until the work is done; the caller has the GIL.
    /// @param progress called as progress(what, share, state), or None. If it raises, or Ctrl-C comes, the
    /// work is stopped. @throws what the work throws, python_error
    void wait(const nanobind::object& progress);
    /// The same, but leaves work alone that does not end at once when it is stopped. It owns all its data.
    void wait_or_leave();

private:
    struct State {
        std::string what;
        double share = 0.0;
        std::string text;
    };

    bool is_done_after_a_moment();
    void tell_python(const nanobind::object& progress);
    void conclude();

    std::function<void(Call&)> work_;
    std::stop_source stop_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool is_done_ = false;
    bool has_news_ = false;
    State state_;
    std::exception_ptr failure_;
};

class GlThread {
public:
    /// The only one. The thread starts with the first work.
    static GlThread& only();

    /// Runs `work` there, where context() may be called, and waits. Its remarks become warnings of Python.
    /// @throws as Call::wait()
    void run(const std::function<void(Call&)>& work, const nanobind::object& progress = nanobind::none());
    /// Runs `release` there some time; nobody waits.
    void discard(std::function<void()> release);
    /// Ends the thread and closes the context. Nothing runs afterwards.
    void end();

    /// The process's context, which is opened at the first call. Only on the thread.
    /// @throws Error if none opens; BadSetting if it is open by another backend
    gl::Context& context(gl::Backend backend, bool has_debug);

private:
    GlThread() = default;
    void start();
    void loop();

    std::mutex mutex_;
    std::condition_variable wakes_;
    std::deque<std::function<void()>> queue_;
    std::thread thread_;
    pid_t process_ = 0; // that started the thread
    bool is_ending_ = false;
    std::unique_ptr<gl::Context> context_;
    gl::ContextOptions options_;
};

/// Runs `work` on a thread of its own and waits. At Ctrl-C it is left to its end: it owns all its data.
void run_aside(std::function<void(Call&)> work);

/// The function of Python that takes remarks.
void set_remark_handler(nanobind::object handler);

} // namespace sr::python
