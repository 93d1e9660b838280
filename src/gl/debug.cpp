#include "gl/debug.hpp"

#include <glad/gl.h>

namespace sr::gl {
namespace {

constexpr std::size_t most_messages = 100; // a failing call in a loop must not eat the memory

void GLAD_API_PTR collect(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length,
                          const GLchar* text, const void* log) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE) return;
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER)
        return; // Program tells that better, with the file and line
    auto& messages = *static_cast<std::vector<std::string>*>(const_cast<void*>(log));
    if (messages.size() < most_messages) messages.emplace_back(text, static_cast<std::size_t>(length));
}

} // namespace

DebugLog::DebugLog() {
    if (!GLAD_GL_KHR_debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(collect, &messages_);
}

DebugLog::~DebugLog() {
    if (GLAD_GL_KHR_debug) glDebugMessageCallback(nullptr, nullptr);
}

} // namespace sr::gl
