#include "gl/trial_compiler.hpp"

#include "core/error.hpp"
#include "core/limits.hpp"
#include "core/program.hpp"
#include "gl/object.hpp"
#include "gl/program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace sr::gl {
namespace {

/// How the process ended, as a clause whose subject is the driver's compiler.
std::string end_of(int status) {
    if (!WIFSIGNALED(status)) return fmt::format("ends the program (exit status {})", WEXITSTATUS(status));
    switch (WTERMSIG(status)) {
    case SIGXCPU:
    case SIGALRM: return fmt::format("takes more than {} s", TrialCompiler::max_seconds);
    case SIGKILL: return fmt::format("takes more than {} GiB of memory", TrialCompiler::max_gigabytes);
    default: return fmt::format("crashes ({})", strsignal(WTERMSIG(status)));
    }
}

// The protocol: texts, and one byte for each pair of them.

/// Calls read() or write() until all of it is done.
template<typename Byte, typename Call>
bool all_of(Call call, int descriptor, Byte* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t done = call(descriptor, bytes, count);
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) return false;
        bytes += done;
        count -= static_cast<std::size_t>(done);
    }
    return true;
}

/// Writes the length and the text. @return whether all of it was written
bool write_text(int descriptor, const std::string& text) {
    const std::uint64_t size = text.size();
    return all_of(::write, descriptor, reinterpret_cast<const char*>(&size), sizeof size)
           && all_of(::write, descriptor, text.data(), text.size());
}

/// Reads what write_text() wrote. @return whether there was a whole text
bool read_text(int descriptor, std::string& text) {
    std::uint64_t size = 0;
    if (!all_of(::read, descriptor, reinterpret_cast<char*>(&size), sizeof size)) return false;
    text.resize(size);
    return all_of(::read, descriptor, text.data(), text.size());
}

bool write_answer(int descriptor) { return all_of(::write, descriptor, "k", 1); }

bool read_answer(int descriptor) {
    char answer = 0;
    return all_of(::read, descriptor, &answer, 1);
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
    const int failure =
        posix_spawn(&pid_, program_to_start().c_str(), &files, &attributes, arguments.data(), environ);
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

namespace {

/// Sets a soft limit, as far as the hard one allows.
void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
    struct rlimit bounds {};
    if (getrlimit(what, &bounds) != 0) return;
    bounds.rlim_cur = std::min(most, bounds.rlim_max);
    setrlimit(what, &bounds);
}

/// Sets the limits that hold for the whole life of the process.
void limit_process() {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    limit(RLIMIT_CORE, 0);
    // A little less than the program has that compiles afterwards, which is deeper in its calls.
    struct rlimit stack {};
    if (getrlimit(RLIMIT_STACK, &stack) == 0)
        limit(RLIMIT_STACK, stack.rlim_cur == RLIM_INFINITY ? rlim_t{64} << 20 : stack.rlim_cur / 8 * 7);
}

/// Ends the process by a signal if the next trial takes longer.
void allow_time() {
    struct rusage used {};
    getrusage(RUSAGE_SELF, &used);
    limit(RLIMIT_CPU,
          static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + TrialCompiler::max_seconds));
    alarm(TrialCompiler::max_wall_seconds);
}

/// Something for every uniform block to read.
void fill_blocks(GLuint program, std::vector<Buffer>& zeros) {
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto block = static_cast<GLuint>(i);
        GLint size = 0;
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
        zeros.emplace_back("zeros");
        glBindBuffer(GL_UNIFORM_BUFFER, zeros.back().id());
        glBufferData(GL_UNIFORM_BUFFER, size, std::vector<char>(static_cast<std::size_t>(size)).data(),
                     GL_STATIC_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, block, zeros.back().id());
        glUniformBlockBinding(program, block, block);
    }
}

bool is_sampler(GLenum type) {
    const auto is_within = [type](GLenum first, GLenum last) { return type >= first && type <= last; };
    return is_within(GL_SAMPLER_1D, GL_SAMPLER_2D_RECT_SHADOW)
           || is_within(GL_SAMPLER_1D_ARRAY, GL_SAMPLER_CUBE_SHADOW)
           || is_within(GL_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_BUFFER)
           || is_within(GL_SAMPLER_CUBE_MAP_ARRAY, GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY)
           || is_within(GL_SAMPLER_2D_MULTISAMPLE, GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY);
}

/// Samplers of different kinds must not share a unit (OpenGL 4.1, section 2.11.8), and all begin at 0.
void spread_samplers(GLuint program) {
    GLint count = 0, unit = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
        if (!is_sampler(type)) continue;
        std::vector<GLint> units;
        for (GLint element = 0; element < size; ++element) units.push_back(unit++);
        glUniform1iv(glGetUniformLocation(program, name.data()), size, units.data());
    }
}

/// Draws a point into one pixel: software drivers translate a shader for the processor then.
void draw_with(const Program& program) {
    std::vector<Buffer> zeros;
    program.use();
    fill_blocks(program.id(), zeros);
    spread_samplers(program.id());
    const VertexArray no_vertices("no vertices");
    glBindVertexArray(no_vertices.id());
    const Texture color(GL_TEXTURE_2D, "trial");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, nullptr);
    const Framebuffer target("trial");
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color.id(), 0);
    glViewport(0, 0, 1, 1);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::array<float, 4> pixel{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel.data()); // waits for the driver
    glUseProgram(0);
}

void try_program(std::string vertex, std::string fragment) {
    const auto source = [](std::string text) { return glsl::Source{std::move(text), {"trial"}, {}, {}, {}}; };
    try {
        draw_with(Program("trial", source(std::move(vertex)), source(std::move(fragment))));
    } catch (const ShaderError&) {
        // The caller will hear of it from its own driver.
    }
}

} // namespace

void answer_trials(Backend backend) {
    limit_process();
    const int answers = dup(STDOUT_FILENO); // where a driver cannot write by accident
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    const auto context = open_context({backend, false});
    const MemoryWatch watch(std::uint64_t{TrialCompiler::max_gigabytes} << 30);
    write_answer(answers);
    std::string vertex, fragment;
    while (read_text(STDIN_FILENO, vertex) && read_text(STDIN_FILENO, fragment)) {
        allow_time();
        try_program(std::move(vertex), std::move(fragment));
        alarm(0);
        write_answer(answers);
    }
}

} // namespace sr::gl
