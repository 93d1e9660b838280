#pragma once
// An array that shaders read by index.
#include "gl/object.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace sr::render {

class BufferTexture {
public:
    /// `format`: GL_RGBA32F and the like, one texel an element.
    BufferTexture(const char* name, GLenum format);

    /// @throws Error if the driver's buffer textures are too small; `what_to_do` is what the user hears then.
    template<class Element>
    void upload(const std::vector<Element>& elements, std::string_view what_to_do) {
        upload_bytes(std::as_bytes(std::span(elements)), what_to_do);
    }
    void bind(GLuint unit) const { texture_.bind(unit); }

    /// Returns the number of texels that this driver reads from one buffer.
    static std::size_t max_texels();

private:
    void upload_bytes(std::span<const std::byte> bytes, std::string_view what_to_do);

    const char* name_;
    GLenum format_;
    gl::Buffer buffer_;
    gl::Texture texture_;
};

} // namespace sr::render
