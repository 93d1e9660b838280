#pragma once
// Move-only owners of OpenGL names, each with a label that debug messages and tools show.
#include <glad/gl.h>
#include <string_view>
#include <utility>

namespace sr::gl {

/// Owns one GL name. `Kind` supplies create(), destroy(id) and label(id, text).
template<class Kind>
class Object {
public:
    explicit Object(std::string_view label) : id_(Kind::create()) { Kind::label(id_, label); }
    ~Object() {
        if (id_) Kind::destroy(id_);
    }
    Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }

    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

struct BufferKind {
    static GLuint create();
    static void destroy(GLuint id);
    static void label(GLuint id, std::string_view text);
};
struct SamplerKind {
    static GLuint create();
    static void destroy(GLuint id);
    static void label(GLuint id, std::string_view text);
};
struct FramebufferKind {
    static GLuint create();
    static void destroy(GLuint id);
    static void label(GLuint id, std::string_view text);
};
struct VertexArrayKind {
    static GLuint create();
    static void destroy(GLuint id);
    static void label(GLuint id, std::string_view text);
};

using Buffer = Object<BufferKind>;
using Sampler = Object<SamplerKind>;
using Framebuffer = Object<FramebufferKind>;
using VertexArray = Object<VertexArrayKind>;

/// A texture of one target (GL_TEXTURE_2D, …), which its first binding fixes for good.
class Texture {
public:
    /// Leaves the texture bound to the current unit.
    Texture(GLenum target, std::string_view label);
    ~Texture();
    Texture(Texture&& other) noexcept : target_(other.target_), id_(std::exchange(other.id_, 0)) {}
    Texture& operator=(Texture&& other) noexcept {
        std::swap(target_, other.target_);
        std::swap(id_, other.id_);
        return *this;
    }

    GLuint id() const { return id_; }
    void bind(GLuint unit) const;

private:
    GLenum target_;
    GLuint id_ = 0;
};

} // namespace sr::gl
