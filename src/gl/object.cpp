#include "gl/object.hpp"

namespace sr::gl {
namespace {

GLuint one(void (*generate)(GLsizei, GLuint*)) {
    GLuint id = 0;
    generate(1, &id);
    return id;
}

/// A name becomes an object when it is first bound, and only objects can be labelled.
void name_object(GLenum kind, GLuint id, std::string_view text) {
    if (GLAD_GL_KHR_debug) glObjectLabel(kind, id, static_cast<GLsizei>(text.size()), text.data());
}

} // namespace

GLuint BufferKind::create() { return one(glGenBuffers); }
void BufferKind::destroy(GLuint id) { glDeleteBuffers(1, &id); }
void BufferKind::label(GLuint id, std::string_view text) {
    glBindBuffer(GL_COPY_WRITE_BUFFER, id);
    name_object(GL_BUFFER, id, text);
}

GLuint SamplerKind::create() { return one(glGenSamplers); }
void SamplerKind::destroy(GLuint id) { glDeleteSamplers(1, &id); }
void SamplerKind::label(GLuint id, std::string_view text) {
    glBindSampler(0, id);
    name_object(GL_SAMPLER, id, text);
    glBindSampler(0, 0);
}

GLuint FramebufferKind::create() { return one(glGenFramebuffers); }
void FramebufferKind::destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
void FramebufferKind::label(GLuint id, std::string_view text) {
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    name_object(GL_FRAMEBUFFER, id, text);
}

GLuint VertexArrayKind::create() { return one(glGenVertexArrays); }
void VertexArrayKind::destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
void VertexArrayKind::label(GLuint id, std::string_view text) {
    glBindVertexArray(id);
    name_object(GL_VERTEX_ARRAY, id, text);
}

Texture::Texture(GLenum target, std::string_view label) : target_(target), id_(one(glGenTextures)) {
    glBindTexture(target_, id_);
    name_object(GL_TEXTURE, id_, label);
}

Texture::~Texture() {
    if (id_) glDeleteTextures(1, &id_);
}

void Texture::bind(GLuint unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target_, id_);
}

} // namespace sr::gl
