#include "render/gpu/buffer_texture.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace sr::render {
namespace {

std::size_t bytes_per_texel(GLenum format) {
    switch (format) {
    case GL_RGBA32F:
    case GL_RGBA32I: return 16;
    case GL_RGB32F: return 12;
    case GL_RGBA16F: return 8;
    case GL_R32F:
    case GL_R32I: return 4;
    case GL_R16: return 2;
    default: require(false, "the format is one of ours"); return 0;
    }
}

} // namespace

BufferTexture::BufferTexture(const char* name, GLenum format)
    : name_(name), format_(format), buffer_(name), texture_(GL_TEXTURE_BUFFER, name) {}

std::size_t BufferTexture::max_texels() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return static_cast<std::size_t>(most);
}

void BufferTexture::upload_bytes(std::span<const std::byte> bytes, std::string_view what_to_do) {
    const std::size_t texels = bytes.size() / bytes_per_texel(format_);
    if (texels > max_texels())
        throw Error(fmt::format("{} take {} texels, this driver has {}", name_, texels, max_texels()),
                    what_to_do);
    constexpr std::byte nothing[16]{}; // a buffer texture cannot be empty
    if (bytes.empty()) bytes = nothing;
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    texture_.bind(0);
    glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_.id());
}

} // namespace sr::render
