#include "core/piped_program.hpp"

#include "core/error.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <poll.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ; // NOLINT(readability-redundant-declaration): POSIX has programs declare it

namespace sr {
namespace {

namespace fs = std::filesystem;

constexpr int patience = 50; // [ms] between two looks at a stop token

/// Starts a program whose stdin is `input`. @return errno, 0 for success
int start(pid_t& pid, const std::vector<std::string>& words, int input, const fs::path& log) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    constexpr mode_t for_its_owner = 0600;
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     for_its_owner);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    // Ctrl-C is for this program.
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    const int failure =
        posix_spawn(&pid, words.front().c_str(), &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return failure;
}

} // namespace

fs::path program_in_path(std::string_view name) {
    const char* const path = std::getenv("PATH");
    if (name.empty() || !path) return {};
    std::istringstream folders(path);
    std::error_code ignored;
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path file = fs::path(folder) / name;
        if (fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

PipedProgram::PipedProgram(std::vector<std::string> words) {
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error(fmt::format("no pipe can be opened ({})", std::strerror(errno)), "close other programs");
    const int failure = start(pid_, words, ends[0], scratch_.path() / "stderr");
    close(ends[0]);
    input_ = ends[1];
    // A program that does not read must not hold this one for ever.
    fcntl(input_, F_SETFL, fcntl(input_, F_GETFL) | O_NONBLOCK);
    if (failure == 0) return;
    pid_ = 0;
    close_input();
    throw Error({words.front()}, fmt::format("does not start ({})", std::strerror(failure)),
                "install the program again");
}

PipedProgram::~PipedProgram() {
    close_input();
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
}

void PipedProgram::close_input() {
    if (input_ >= 0) close(std::exchange(input_, -1));
}

bool PipedProgram::write(std::span<const std::uint8_t> bytes, const std::stop_token& stop) {
    while (!bytes.empty() && !stop.stop_requested()) {
        pollfd ready{input_, POLLOUT, 0};
        if (poll(&ready, 1, patience) <= 0) continue;
        const ssize_t written = ::write(input_, bytes.data(), bytes.size());
        if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
        if (written < 0 && errno != EINTR && errno != EAGAIN) return false;
    }
    return bytes.empty();
}

bool PipedProgram::finish(const std::stop_token& stop) {
    close_input();
    while (pid_ > 0 && !stop.stop_requested()) {
        const pid_t ended = waitpid(pid_, &status_, WNOHANG);
        if (ended == pid_ || (ended < 0 && errno != EINTR)) pid_ = 0;
        if (pid_ > 0) poll(nullptr, 0, 5);
    }
    return pid_ == 0 && WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

std::string PipedProgram::complaint() const {
    std::ifstream log(scratch_.path() / "stderr");
    for (std::string line; std::getline(log, line);)
        if (!line.empty()) return line;
    if (pid_ > 0) return "it still runs";
    if (WIFSIGNALED(status_)) return strsignal(WTERMSIG(status_));
    return fmt::format("exit status {}", WEXITSTATUS(status_));
}

} // namespace sr
