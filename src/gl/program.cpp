#include "gl/program.hpp"

#include "glsl/log.hpp"

#include <fmt/format.h>

namespace sr::gl {
namespace {

/// Returns the info log of a shader or a program, read by that kind's pair of functions.
std::string info_log(GLuint id, PFNGLGETSHADERIVPROC value_of, PFNGLGETSHADERINFOLOGPROC log_of) {
    GLint length = 0;
    value_of(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    if (length > 0) log_of(id, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

[[noreturn]] void refuse(const std::string& driver_log, const glsl::Source& source) {
    const std::string log = glsl::rewrite_log(driver_log, source);
    if (const auto error = glsl::first_error(driver_log, source))
        throw ShaderError(error->where, error->text, log);
    throw ShaderError({source.files.front()}, log.substr(0, log.find('\n')), log);
}

/// GLSL 4.10 is ASCII even in comments (section 3.1), where our equations are not; strict drivers mind.
std::string ascii(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) >= 0x80) c = '?';
    return text;
}

/// One stage; deleted when it goes out of scope, which a linked program does not mind.
struct Shader {
    GLuint id;

    Shader(GLenum stage, const glsl::Source& source) : id(glCreateShader(stage)) {
        const std::string text = ascii(source.text);
        const char* pointer = text.c_str();
        glShaderSource(id, 1, &pointer, nullptr);
        glCompileShader(id);
        GLint compiled = GL_FALSE;
        glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
        if (compiled) return;
        const std::string log = info_log(id, glGetShaderiv, glGetShaderInfoLog);
        glDeleteShader(id);
        refuse(log, source);
    }
    ~Shader() { glDeleteShader(id); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
};

} // namespace

Program::Program(const std::string& label, const glsl::Source& vertex, const glsl::Source& fragment) {
    const Shader vertex_shader(GL_VERTEX_SHADER, vertex);
    const Shader fragment_shader(GL_FRAGMENT_SHADER, fragment);
    id_ = glCreateProgram();
    glAttachShader(id_, vertex_shader.id);
    glAttachShader(id_, fragment_shader.id);
    glLinkProgram(id_);
    glDetachShader(id_, vertex_shader.id);
    glDetachShader(id_, fragment_shader.id);
    GLint linked = GL_FALSE;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (!linked) {
        const std::string log = info_log(id_, glGetProgramiv, glGetProgramInfoLog);
        glDeleteProgram(id_);
        refuse(log, fragment);
    }
    if (GLAD_GL_KHR_debug) glObjectLabel(GL_PROGRAM, id_, -1, label.c_str());
}

Program::~Program() {
    if (id_) glDeleteProgram(id_);
}

void Program::bind_block(const char* block, GLuint binding) const {
    const GLuint index = glGetUniformBlockIndex(id_, block);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(id_, index, binding);
}

void Program::bind_texture(const char* sampler, GLint unit) const {
    glProgramUniform1i(id_, uniform(sampler), unit);
}

} // namespace sr::gl
