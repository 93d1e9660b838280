#include "render/gpu/gpu_texture.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace sr::render {
namespace {

/// GL's names for how texels are stored.
struct GlFormat {
    GLenum internal;
    GLenum type;
};

GlFormat gl_format(TexelFormat format) {
    switch (format) {
    case TexelFormat::unorm8: return {GL_RGBA8, GL_UNSIGNED_BYTE};
    case TexelFormat::srgb8: return {GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE};
    case TexelFormat::unorm16: return {GL_RGBA16, GL_UNSIGNED_SHORT};
    case TexelFormat::float16: return {GL_RGBA16F, GL_HALF_FLOAT};
    case TexelFormat::float32: return {GL_RGBA32F, GL_FLOAT};
    }
    return {GL_RGBA32F, GL_FLOAT};
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

gl::Texture upload(const std::string& name, TexelFormat format, const std::vector<MipLevel>& levels) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const int width = levels.front().width, height = levels.front().height;
    if (width > largest || height > largest)
        throw Error({name}, fmt::format("{}×{} texels, the driver takes {} at most", width, height, largest),
                    "scale the image down");
    const GlFormat stored = gl_format(format);
    gl::Texture texture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t i = 0; i < levels.size(); ++i)
        glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), static_cast<GLint>(stored.internal),
                     levels[i].width, levels[i].height, 0, GL_RGBA, stored.type, levels[i].texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
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

} // namespace sr::render
