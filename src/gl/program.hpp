#pragma once
// A linked vertex and fragment shader.
#include "core/error.hpp"
#include "glsl/source.hpp"

#include <glad/gl.h>
#include <string>
#include <utility>

namespace sr::gl {

/// A shader that does not compile or link. what() is the first complaint on one line; log() is all of them.
class ShaderError : public Error {
public:
    ShaderError(const Location& where, std::string_view what, std::string log)
        : Error(where, what, "correct the shader"), log_(std::move(log)) {}

    const std::string& log() const { return log_; }

private:
    std::string log_;
};

class Program {
public:
    /// Compiles and links. @throws ShaderError with the place in the original file.
    Program(const std::string& label, const glsl::Source& vertex, const glsl::Source& fragment);
    ~Program();
    Program(Program&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Program& operator=(Program&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }

    GLuint id() const { return id_; }
    void use() const { glUseProgram(id_); }

    /// Connects a uniform block with a binding point; does nothing if the program has no such block.
    void bind_block(const char* block, GLuint binding) const;

    /// Connects a sampler with a texture unit; does nothing if the program has no such sampler.
    void bind_texture(const char* sampler, GLint unit) const;

    /// -1, which GL ignores, if the program has no such uniform.
    GLint uniform(const char* name) const { return glGetUniformLocation(id_, name); }

private:
    GLuint id_ = 0;
};

} // namespace sr::gl
