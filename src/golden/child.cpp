#include "golden/child.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace sr::golden {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// posix_spawn's two descriptions of a child, freed at the end.
class SpawnPlan {
public:
    explicit SpawnPlan(const ChildOptions& options) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, options.log.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0666);
        posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
        posix_spawn_file_actions_addchdir_np(&actions_, options.folder.c_str());
        posix_spawnattr_init(&attributes_);
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setflags(&attributes_,
                                 POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    /// @return errno, 0 for success.
    int spawn(pid_t& child, const std::vector<std::string>& words) const {
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        return posix_spawnp(&child, arguments[0], &actions_, &attributes_, arguments.data(), environ);
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// Whether the child has ended. It stays a zombie, so that its group's number is not given to others.
bool has_ended(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0
           && info.si_pid == child;
}

/// Waits until the child has ended, `deadline` has passed or it is stopped. @return whether it has ended.
bool wait_for(pid_t child, Clock::time_point deadline, const std::function<bool()>& is_stopped) {
    while (!has_ended(child)) {
        if (Clock::now() >= deadline || (is_stopped && is_stopped())) return false;
        std::this_thread::sleep_for(3ms);
    }
    return true;
}

} // namespace

ChildEnd run_child(const ChildOptions& options) {
    const auto begin = Clock::now();
    pid_t child = 0;
    if (const int failure = SpawnPlan(options).spawn(child, options.words))
        return {ChildEnd::Way::not_started, failure, 0.0};
    ChildEnd end;
    const auto limit =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.time_limit));
    if (!wait_for(child, begin + limit, options.is_stopped)) {
        end.way =
            options.is_stopped && options.is_stopped() ? ChildEnd::Way::stopped : ChildEnd::Way::timed_out;
        kill(-child, SIGTERM);
        wait_for(child, Clock::now() + 500ms, {});
    }
    kill(-child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    end.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (end.way != ChildEnd::Way::exited) return end;
    end.way = WIFSIGNALED(status) ? ChildEnd::Way::signalled : ChildEnd::Way::exited;
    end.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return end;
}

std::string ChildEnd::text() const {
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
