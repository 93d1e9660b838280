#include "golden/process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <mutex>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace sr::golden {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

// A child is a supervisor and the program below it, both in a process group of their own. The supervisor dies
// with the thread that made it, and takes the group along: a run that is killed leaves nothing behind.
// Between fork and exec only functions are called that are safe there: this program has other threads.

void kill_group(int) { kill(0, SIGKILL); }

void reset_signals() {
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
}

/// Ends as the program below it has ended.
[[noreturn]] void end_as(int status) {
    if (WIFEXITED(status)) _exit(WEXITSTATUS(status));
    const struct rlimit no_core { 0, 0 };
    setrlimit(RLIMIT_CORE, &no_core);
    signal(WTERMSIG(status), SIG_DFL);
    raise(WTERMSIG(status));
    _exit(128 + WTERMSIG(status));
}

[[noreturn]] void supervise(pid_t program) {
    signal(SIGUSR1, kill_group);
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) signal(number, SIG_IGN); // they end the program
    int status = 0;
    while (waitpid(program, &status, 0) < 0 && errno == EINTR) {
    }
    end_as(status);
}

/// The data of a child: nothing is allocated after the fork.
struct ChildPlan {
    std::vector<char*> words;
    const char* folder;
    const char* log;
    pid_t parent;
};

/// In the child: opens its streams and starts the program. @param report gets errno if that fails
[[noreturn]] void run_as_child(const ChildPlan& plan, int report) {
    const auto fail = [&] {
        const int cause = errno;
        [[maybe_unused]] const ssize_t written = write(report, &cause, sizeof cause);
        _exit(127);
    };
    reset_signals();
    setpgid(0, 0);
#ifdef __linux__
    signal(SIGUSR1, kill_group);
    prctl(PR_SET_PDEATHSIG, SIGUSR1);
    if (getppid() != plan.parent) _exit(127); // it died before
#endif
    const int input = open("/dev/null", O_RDONLY);
    const int output = open(plan.log, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (input < 0 || output < 0 || chdir(plan.folder) != 0) fail();
    dup2(input, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    const pid_t program = fork();
    if (program < 0) fail();
    if (program == 0) {
        signal(SIGUSR1, SIG_DFL);
        execvp(plan.words[0], plan.words.data());
        fail();
    }
    close(report);
    supervise(program);
}

/// @return errno, 0 for success
int start(pid_t& child, const ProcessOptions& options) {
    // The child supervises the program and never calls exec, so it would keep the pipe of another thread.
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    ChildPlan plan{{}, options.folder.c_str(), options.log.c_str(), getpid()};
    for (const std::string& word : options.words) plan.words.push_back(const_cast<char*>(word.c_str()));
    plan.words.push_back(nullptr);
    std::array<int, 2> report{};
    if (pipe2(report.data(), O_CLOEXEC) != 0) return errno;
    child = fork();
    if (child == 0) run_as_child(plan, report[1]);
    int failure = child < 0 ? errno : 0;
    close(report[1]);
    if (child > 0) {
        setpgid(child, child); // also here, so that it is done before anyone kills the group
        while (read(report[0], &failure, sizeof failure) < 0 && errno == EINTR) {
        } // ends when the program has begun
        if (failure != 0) {
            kill(-child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
    }
    close(report[0]);
    return failure;
}

/// True if the child has ended. It stays a zombie, so that its group's number is not given to others.
bool has_ended(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0
           && info.si_pid == child;
}

/// Waits until the child has ended, `deadline` has passed or it is stopped. @return whether it has ended.
bool wait_for(pid_t child, Clock::time_point deadline, const std::stop_token& stop = {},
              const std::function<void()>& while_running = {}) {
    while (!has_ended(child)) {
        if (while_running) while_running();
        if (Clock::now() >= deadline || stop.stop_requested()) return false;
        std::this_thread::sleep_for(3ms);
    }
    return true;
}

} // namespace

ProcessEnd run_process(const ProcessOptions& options) {
    const auto begin = Clock::now();
    pid_t child = 0;
    if (const int failure = start(child, options)) return {ProcessEnd::Way::not_started, failure, 0.0};
    ProcessEnd end;
    const auto limit =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.time_limit));
    if (!wait_for(child, begin + limit, options.stop, options.while_running)) {
        end.way = options.stop.stop_requested() ? ProcessEnd::Way::stopped : ProcessEnd::Way::timed_out;
        kill(-child, SIGTERM);
        wait_for(child, Clock::now() + 500ms);
    }
    kill(-child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    end.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (end.way != ProcessEnd::Way::exited) return end;
    end.way = WIFSIGNALED(status) ? ProcessEnd::Way::signalled : ProcessEnd::Way::exited;
    end.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return end;
}

std::string ProcessEnd::text() const {
    switch (way) {
    case Way::exited: return fmt::format("ended with exit status {}", status);
    case Way::signalled: return fmt::format("crashed: {} (signal {})", strsignal(status), status);
    case Way::timed_out: return "was killed at its time limit";
    case Way::stopped: return "was interrupted";
    case Way::not_started: return fmt::format("did not start: {}", std::strerror(status));
    }
    return {};
}

} // namespace sr::golden
