// The process that a TrialCompiler starts.
#include "core/error.hpp"
#include "core/memory_watch.hpp"
#include "gl/object.hpp"
#include "gl/program.hpp"
#include "gl/trial_compiler.hpp"
#include "gl/trial_pipe.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace sr::gl {
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
          static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + TrialCompiler::most_seconds));
    alarm(TrialCompiler::most_wall_seconds);
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
    const auto source = [](std::string text) { return glsl::Source{std::move(text), {"trial"}, {}, {}}; };
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
    const MemoryWatch watch(std::uint64_t{TrialCompiler::most_gigabytes} << 30);
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
