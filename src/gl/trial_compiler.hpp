#pragma once
// Shaders that somebody else wrote are compiled in a process of their own first: deep expressions, macros
// that grow without end and the like crash drivers' compilers, or use up the memory.
#include "gl/context.hpp"
#include "glsl/source.hpp"

#include <memory>
#include <string>

namespace sr::gl {

class TrialCompiler {
public:
    /// Limits of the driver for one program.
    static constexpr int max_seconds = 30; // of CPU time
    static constexpr int max_wall_seconds = 120;
    static constexpr int max_gigabytes = 2;

    /// `backend`: what the process opens a context by. It starts with the first program that is tried.
    explicit TrialCompiler(Backend backend);
    ~TrialCompiler();
    TrialCompiler(const TrialCompiler&) = delete;
    TrialCompiler& operator=(const TrialCompiler&) = delete;

    /// Compiles, links and draws a point, unless every file is one of ours. Says nothing about mistakes in
    /// the shader: Program does, and is safe afterwards.
    /// @throws Error at the file of somebody else if the driver crashes or takes too much, or if the process
    /// does not start
    void try_out(const glsl::Source& vertex, const glsl::Source& fragment);

private:
    class Process;

    Backend backend_;
    std::unique_ptr<Process> process_;
};

/// Runs in the other process, as the command `compile-trial`: answers requests from stdin on stdout, until
/// stdin ends. @throws Error if no context opens
void answer_trials(Backend backend);

} // namespace sr::gl
