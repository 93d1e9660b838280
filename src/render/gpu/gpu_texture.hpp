#pragma once
// GL textures: images of a scene with mip levels, and arrays that shaders read by index.
#include "gl/object.hpp"
#include "render/gpu/mip_chain.hpp"
#include "scene/material.hpp"
#include "scene/measured_brdf.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace sr::render {

/// Uploads an image, then its lower_mip_levels(), which another thread may make meanwhile. Of
/// TexelFormat::srgb8 the sampler decodes sRGB, so that filtering is in linear light. Channels that `layout`
/// lacks read as 0, alpha as 1.
/// @throws Error naming the image if the driver's largest texture is smaller.
gl::Texture upload(const TexelSource& source, TexelLayout layout,
                   const std::function<std::vector<MipLevel>()>& lower_levels);

/// Uploads a measured BRDF as a texture of 180 φ_d × 90 θ_d × 90 θ_h (shaders/brdf/merl.glsl), 17.5 MB.
gl::Texture upload(const scene::MeasuredBrdf& measured);

/// Makes a GL sampler with the filters and wrap modes of a scene's sampler.
gl::Sampler sampler_object(const scene::Sampler& sampler);

/// Array that shaders read by index.
class BufferTexture {
public:
    /// `format`: GL_RGBA32F and the like, one texel an element.
    BufferTexture(const char* name, GLenum format);

    /// @throws Error with the remedy `what_to_do` if the driver's buffer textures are too small
    template<class Element>
    void upload(const std::vector<Element>& elements, std::string_view what_to_do) {
        upload_bytes(std::as_bytes(std::span(elements)), what_to_do);
    }
    /// Has `write` fill memory of the driver, so that many elements are never there twice. It may not read
    /// them.
    template<class Element>
    void fill(std::size_t count, const std::function<void(std::span<Element>)>& write,
              std::string_view what_to_do) {
        void* const memory = map(count * sizeof(Element), what_to_do);
        write({static_cast<Element*>(memory), count});
        unmap();
    }
    void bind(GLuint unit) const { texture_.bind(unit); }

    /// Returns the number of texels that this driver reads from one buffer.
    static std::size_t max_texels();

private:
    void upload_bytes(std::span<const std::byte> bytes, std::string_view what_to_do);
    /// Gives the buffer `size` bytes, or those of an element if that is none: a buffer texture cannot be
    /// empty.
    void* map(std::size_t size, std::string_view what_to_do);
    void unmap();

    const char* name_;
    GLenum format_;
    gl::Buffer buffer_;
    gl::Texture texture_;
};

} // namespace sr::render
