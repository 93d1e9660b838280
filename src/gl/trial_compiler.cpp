#include "gl/trial_compiler.hpp"

#include "core/error.hpp"
#include "gl/trial_pipe.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace sr::gl {
namespace {

constexpr const char* own_program = "/proc/self/exe";

/// How the process ended, as a clause whose subject is the driver's compiler.
std::string end_of(int status) {
    if (!WIFSIGNALED(status)) return fmt::format("ends the program (exit status {})", WEXITSTATUS(status));
    switch (WTERMSIG(status)) {
    case SIGXCPU:
    case SIGALRM: return fmt::format("takes more than {} s", TrialCompiler::most_seconds);
    case SIGKILL: return fmt::format("takes more than {} GiB of memory", TrialCompiler::most_gigabytes);
    default: return fmt::format("crashes ({})", strsignal(WTERMSIG(status)));
    }
}

} // namespace

/// The other process, and the two pipes to it.
class TrialCompiler::Process {
public:
    explicit Process(Backend backend) {
        start(backend);
        to_.close_end(0);
        from_.close_end(1);
    }
    ~Process() {
        to_.close_end(1); // it ends by that
        if (pid_ > 0) wait();
    }

    bool send(const std::string& text) { return write_text(to_.ends[1], text); }
    bool is_answered() { return read_answer(from_.ends[0]); }

    /// Waits for its end. @return the status that waitpid() gives
    int wait() {
        int status = 0;
        while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = 0;
        return status;
    }

private:
    /// A pipe whose ends close by themselves.
    struct Pipe {
        std::array<int, 2> ends{-1, -1};

        Pipe() {
            if (pipe2(ends.data(), O_CLOEXEC) != 0)
                throw Error(fmt::format("no pipe can be opened ({})", std::strerror(errno)),
                            "close other programs");
        }
        ~Pipe() {
            for (const int end : ends)
                if (end >= 0) close(end);
        }
        Pipe(const Pipe&) = delete;
        Pipe& operator=(const Pipe&) = delete;

        void close_end(int which) { close(std::exchange(ends[static_cast<std::size_t>(which)], -1)); }
    };

    void start(Backend backend);

    Pipe to_, from_;
    pid_t pid_ = 0;
};

void TrialCompiler::Process::start(Backend backend) {
    std::array<std::string, 4> words{"steradian", "compile-trial", "--backend",
                                     std::string(name_of(backend))};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, to_.ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, from_.ends[1], STDOUT_FILENO);
    // A crashing driver's own output would come before our line.
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP); // Ctrl-C is for us
    const int failure = posix_spawn(&pid_, own_program, &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (failure != 0)
        throw Error(fmt::format("the process in which foreign shaders are tried does not start ({})",
                                std::strerror(failure)),
                    "raise the system's limits on processes and memory");
}

TrialCompiler::TrialCompiler(Backend backend) : backend_(backend) {}

TrialCompiler::~TrialCompiler() = default;

void TrialCompiler::try_out(const glsl::Source& vertex, const glsl::Source& fragment) {
    std::vector<std::string> theirs = fragment.foreign;
    theirs.insert(theirs.end(), vertex.foreign.begin(), vertex.foreign.end());
    if (theirs.empty()) return;
    if (!process_) {
        auto started = std::make_unique<Process>(backend_);
        if (!started->is_answered())
            throw Error("the process in which foreign shaders are tried opens no OpenGL context",
                        "see what `steradian info` says; raise the system's limits on processes and memory");
        process_ = std::move(started);
    }
    if (process_->send(vertex.text) && process_->send(fragment.text) && process_->is_answered()) return;
    const int status = process_->wait();
    process_.reset();
    const std::string others =
        theirs.size() == 1 ? "" : fmt::format(" and {} more that are not built in", theirs.size() - 1);
    throw Error({theirs.front()},
                fmt::format("with this file{} the driver's compiler {}", others, end_of(status)),
                "shorten its expressions, macros, arrays and loops");
}

} // namespace sr::gl
