#include "render/gpu_texture.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace sr::render {
namespace {

struct Format {
    GLenum internal;
    GLenum type;
    const void* texels;
};

/// GL has no 16-bit sRGB format: such an image is stored as 16-bit linear values would be only if it is
/// linear data; 16-bit sRGB pictures are rounded to 8 bits, which is finer than their transfer function needs
/// for display-referred colours.
Format format_of(const scene::TextureImage& image, scene::ColorSpace color_space,
                 std::vector<std::uint8_t>& rounded) {
    const bool is_srgb = color_space == scene::ColorSpace::srgb;
    if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&image.texels))
        return {static_cast<GLenum>(is_srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8), GL_UNSIGNED_BYTE, bytes->data()};
    const auto& words = std::get<std::vector<std::uint16_t>>(image.texels);
    if (!is_srgb) return {GL_RGBA16, GL_UNSIGNED_SHORT, words.data()};
    rounded.reserve(words.size());
    for (const std::uint16_t word : words)
        rounded.push_back(static_cast<std::uint8_t>((word * 255u + 32767u) / 65535u));
    return {GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE, rounded.data()};
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

} // namespace

gl::Texture upload(const scene::TextureImage& image, scene::ColorSpace color_space) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (image.width > largest || image.height > largest)
        throw Error(
            {image.name},
            fmt::format("{}×{} texels, the driver takes {} at most", image.width, image.height, largest),
            "scale the image down");
    std::vector<std::uint8_t> rounded;
    const Format format = format_of(image, color_space, rounded);
    gl::Texture texture(GL_TEXTURE_2D, image.name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), image.width, image.height, 0, GL_RGBA,
                 format.type, format.texels);
    glGenerateMipmap(GL_TEXTURE_2D);
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

} // namespace sr::render
