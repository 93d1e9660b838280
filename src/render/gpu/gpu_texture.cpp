#include "render/gpu/gpu_texture.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <fmt/format.h>

namespace sr::render {
namespace {

/// GL's names for how texels are stored.
struct GlFormat {
    GLenum internal;
    GLenum channels;
    GLenum type;
};

GlFormat gl_format(TexelLayout layout) {
    switch (layout.format) {
    case TexelFormat::unorm8: return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TexelFormat::srgb8: return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TexelFormat::unorm16:
        switch (std::popcount(layout.channels)) {
        case 1: return {GL_R16, GL_RED, GL_UNSIGNED_SHORT};
        case 2: return {GL_RG16, GL_RG, GL_UNSIGNED_SHORT};
        default: return {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT};
        }
    case TexelFormat::float16:
    case TexelFormat::float16_exact_alpha: return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    case TexelFormat::float32: break;
    }
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
}

/// Has shaders find each stored channel of the bound 2D texture where the image has it. The others are 0, and
/// alpha is 1.
void place_channels(unsigned channels) {
    constexpr std::array<GLint, 4> nothing{GL_ZERO, GL_ZERO, GL_ZERO, GL_ONE};
    constexpr std::array<GLint, 4> stored{GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
    std::array<GLint, 4> sources = nothing;
    std::size_t count = 0;
    for (std::size_t c = 0; c < 4; ++c)
        if (channels >> c & 1u) sources[c] = stored[count++];
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, sources.data());
}

GLint wrap_mode(scene::Wrap wrap) {
    switch (wrap) {
    case scene::Wrap::repeat: return GL_REPEAT;
    case scene::Wrap::mirrored_repeat: return GL_MIRRORED_REPEAT;
    case scene::Wrap::clamp_to_edge: return GL_CLAMP_TO_EDGE;
    }
    return GL_REPEAT;
}

GLint minification(const scene::Sampler& sampler) {
    const bool is_linear = sampler.minification == scene::Filter::linear;
    switch (sampler.mipmap) {
    case scene::Mipmap::none: return is_linear ? GL_LINEAR : GL_NEAREST;
    case scene::Mipmap::nearest: return is_linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
    case scene::Mipmap::linear: return is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    }
    return GL_LINEAR_MIPMAP_LINEAR;
}

std::size_t bytes_per_texel(GLenum format) {
    switch (format) {
    case GL_RGBA32F:
    case GL_RGBA32I: return 16;
    case GL_RGB32F: return 12;
    case GL_RGBA16F: return 8;
    case GL_R32F:
    case GL_R32I:
    case GL_R32UI: return 4;
    case GL_R16: return 2;
    default: require(false, "the format is one of ours"); return 0;
    }
}

/// Gives the bound 2D texture its memory. Of textures that say their levels one by one, Mesa's software
/// renderers keep level 0 twice.
void define_levels(GlFormat stored, int width, int height, int levels) {
    if (GLAD_GL_ARB_texture_storage) {
        glTexStorage2D(GL_TEXTURE_2D, levels, stored.internal, width, height);
    } else {
        for (int level = 0; level < levels; ++level)
            glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(stored.internal),
                         std::max(1, width >> level), std::max(1, height >> level), 0, stored.channels,
                         stored.type, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

} // namespace

gl::Texture upload(const TexelSource& source, TexelLayout layout,
                   const std::function<std::vector<MipLevel>()>& lower_levels) {
    const scene::TextureImage& image = source.image;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (image.width > largest || image.height > largest)
        throw Error(
            {image.name},
            fmt::format("{}×{} texels, the driver takes {} at most", image.width, image.height, largest),
            "scale the image down");
    const GlFormat stored = gl_format(layout);
    gl::Texture texture(GL_TEXTURE_2D, image.name);
    define_levels(stored, image.width, image.height,
                  static_cast<int>(mip_level_count(image.width, image.height)));
    if (layout.channels != all_channels) place_channels(layout.channels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto fill = [&](std::size_t level, int first_row, int width, int rows, const std::byte* texels) {
        glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), 0, first_row, width, rows, stored.channels,
                        stored.type, texels);
    };
    for_each_band(source, layout, [&](int first_row, int rows, std::span<const std::byte> texels) {
        fill(0, first_row, image.width, rows, texels.data());
    });
    std::size_t level = 0;
    for (const MipLevel& lower : lower_levels())
        fill(++level, 0, lower.width, lower.height, lower.storage.get());
    return texture;
}

gl::Texture upload(const scene::MeasuredBrdf& measured) {
    gl::Texture texture(GL_TEXTURE_3D, measured.name);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB32F, scene::merl_azimuths, scene::merl_difference_angles,
                 scene::merl_half_angles, 0, GL_RGB, GL_FLOAT, measured.values.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

gl::Sampler sampler_object(const scene::Sampler& sampler) {
    gl::Sampler object("sampler");
    glSamplerParameteri(object.id(), GL_TEXTURE_WRAP_S, wrap_mode(sampler.wrap_u));
    glSamplerParameteri(object.id(), GL_TEXTURE_WRAP_T, wrap_mode(sampler.wrap_v));
    glSamplerParameteri(object.id(), GL_TEXTURE_MAG_FILTER,
                        sampler.magnification == scene::Filter::linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(object.id(), GL_TEXTURE_MIN_FILTER, minification(sampler));
    return object;
}

BufferTexture::BufferTexture(const char* name, GLenum format)
    : name_(name), format_(format), buffer_(name), texture_(GL_TEXTURE_BUFFER, name) {}

std::size_t BufferTexture::max_texels() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return static_cast<std::size_t>(most);
}

void BufferTexture::upload_bytes(std::span<const std::byte> bytes, std::string_view what_to_do) {
    void* const memory = map(bytes.size(), what_to_do);
    std::ranges::copy(bytes, static_cast<std::byte*>(memory));
    unmap();
}

void* BufferTexture::map(std::size_t size, std::string_view what_to_do) {
    const std::size_t texels = size / bytes_per_texel(format_);
    if (texels > max_texels())
        throw Error(fmt::format("{} take {} texels, this driver has {}", name_, texels, max_texels()),
                    what_to_do);
    const auto bytes = static_cast<GLsizeiptr>(std::max(size, bytes_per_texel(format_)));
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    glBufferData(GL_TEXTURE_BUFFER, bytes, nullptr, GL_STATIC_DRAW);
    void* const memory =
        glMapBufferRange(GL_TEXTURE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (!memory)
        throw Error(fmt::format("{} take {} bytes, which the driver does not give", name_, size), what_to_do);
    return memory;
}

void BufferTexture::unmap() {
    glUnmapBuffer(GL_TEXTURE_BUFFER);
    texture_.bind(0);
    glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_.id());
}

} // namespace sr::render
