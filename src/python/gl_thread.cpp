#include "python/gl_thread.hpp"

#include "core/error.hpp"
#include "core/output.hpp"
#include "settings/bad_setting.hpp"

#include <chrono>
#include <fmt/format.h>
#include <optional>
#include <unistd.h>
#include <utility>

namespace sr::python {
namespace {

namespace nb = nanobind;

/// Leaked: a module's objects may outlive the interpreter.
nb::object& remark_handler() {
    static auto* handler = new nb::object();
    return *handler;
}

} // namespace

void set_remark_handler(nb::object handler) { remark_handler() = std::move(handler); }

void Call::tell(const std::string& what, double share, const std::string& state) {
    const std::lock_guard lock(mutex_);
    state_ = {what, share, state};
    has_news_ = true;
}

void Call::work() {
    try {
        work_(*this);
    } catch (...) {
        failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    is_done_ = true;
    ended_.notify_all();
}

bool Call::is_done_after_a_moment() {
    using namespace std::chrono_literals;
    const nb::gil_scoped_release others_may_run;
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, 50ms, [&] { return is_done_; });
}

void Call::tell_python(const nb::object& progress) {
    if (progress.is_none()) return;
    std::optional<State> news;
    {
        const std::lock_guard lock(mutex_);
        if (std::exchange(has_news_, false)) news = state_;
    }
    if (news) progress(news->what, news->share, news->text);
}

void Call::wait(const nb::object& progress) {
    try {
        while (!is_done_after_a_moment()) {
            if (PyErr_CheckSignals() != 0) throw nb::python_error();
            tell_python(progress);
        }
    } catch (...) {
        stop_.request_stop();
        while (!is_done_after_a_moment()) {
        }
        throw;
    }
    tell_python(progress);
    conclude();
}

void Call::wait_or_leave() {
    while (!is_done_after_a_moment())
        if (PyErr_CheckSignals() != 0) throw nb::python_error();
    conclude();
}

void Call::conclude() {
    if (failure_) std::rethrow_exception(failure_);
}

GlThread& GlThread::only() {
    static auto* thread = new GlThread(); // ended by end(); its mutex is needed after that
    return *thread;
}

void GlThread::start() {
    if (is_ending_) throw Error("Python is ending", "render before its end");
    if (process_ != 0 && process_ != getpid())
        throw Error("OpenGL does not survive a fork",
                    "start processes by multiprocessing's method 'spawn', or render in them alone");
    if (process_ != 0) return;
    process_ = getpid();
    thread_ = std::thread([this] { loop(); });
}

void GlThread::loop() {
    for (;;) {
        std::unique_lock lock(mutex_);
        wakes_.wait(lock, [&] { return is_ending_ || !queue_.empty(); });
        if (queue_.empty()) break;
        const std::function<void()> next = std::move(queue_.front());
        queue_.pop_front();
        lock.unlock();
        next();
    }
    context_.reset();
}

void GlThread::run(const std::function<void(Call&)>& work, const nb::object& progress) {
    std::vector<std::string> remarks;
    Call call([&](Call& self) {
        const RemarkSink sink([&](std::string line) { remarks.push_back(std::move(line)); });
        work(self);
    });
    {
        const nb::gil_scoped_release others_may_run;
        const std::lock_guard lock(mutex_);
        start();
        queue_.emplace_back([&] { call.work(); });
        wakes_.notify_all();
    }
    call.wait(progress);
    for (const std::string& remark : remarks) remark_handler()(remark);
}

void GlThread::discard(std::function<void()> release) {
    const std::lock_guard lock(mutex_);
    if (is_ending_ || process_ != getpid()) return; // the process's end releases all
    queue_.push_back(std::move(release));
    wakes_.notify_all();
}

void GlThread::end() {
    const nb::gil_scoped_release others_may_run;
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
        wakes_.notify_all();
    }
    if (thread_.joinable() && process_ == getpid()) thread_.join();
}

gl::Context& GlThread::context(gl::Backend backend, bool has_debug) {
    if (!context_) {
        context_ = gl::open_context({backend, has_debug});
        options_ = {backend, has_debug};
    }
    if (backend != options_.backend && backend != gl::Backend::automatic)
        throw settings::BadSetting("backend",
                                   fmt::format("the process has opened '{}': choose before its first "
                                               "rendering, or start another process",
                                               gl::name_of(options_.backend)));
    if (has_debug && !options_.debug)
        throw settings::BadSetting("gl_debug",
                                   "the process has a context without it: ask for it at its first "
                                   "rendering");
    return *context_;
}

void run_aside(std::function<void(Call&)> work) {
    const auto call = std::make_shared<Call>(std::move(work));
    std::thread([call] { call->work(); }).detach();
    call->wait_or_leave();
}

} // namespace sr::python
