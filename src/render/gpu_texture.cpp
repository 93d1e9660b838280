#include "render/gpu_texture.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace sr::render {
namespace {

/// GL's name for how texels of this type are stored.
struct Format {
    GLenum internal;
    GLenum type;
};

Format format_of(const scene::TextureImage& image, scene::ColorSpace color_space) {
    if (std::holds_alternative<std::vector<std::uint16_t>>(image.texels))
        return {GL_RGBA16, GL_UNSIGNED_SHORT};
    const bool is_srgb = color_space == scene::ColorSpace::srgb;
    return {static_cast<GLenum>(is_srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8), GL_UNSIGNED_BYTE};
}

const void* data_of(const auto& texels) {
    return std::visit([](const auto& values) -> const void* { return values.data(); }, texels);
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

scene::TextureImage displayable(const scene::TextureImage& image) {
    scene::TextureImage rounded{image.name, image.width, image.height, {}};
    auto& bytes = rounded.texels.emplace<std::vector<std::uint8_t>>();
    const auto& words = std::get<std::vector<std::uint16_t>>(image.texels);
    bytes.reserve(words.size());
    for (const std::uint16_t word : words)
        bytes.push_back(static_cast<std::uint8_t>((word * 255u + 32767u) / 65535u));
    return rounded;
}

gl::Texture upload(const scene::TextureImage& image, scene::ColorSpace color_space,
                   const std::vector<MipLevel>& levels) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (image.width > largest || image.height > largest)
        throw Error(
            {image.name},
            fmt::format("{}×{} texels, the driver takes {} at most", image.width, image.height, largest),
            "scale the image down");
    const Format format = format_of(image, color_space);
    gl::Texture texture(GL_TEXTURE_2D, image.name);
    const auto level = [&](int index, int width, int height, const void* data) {
        glTexImage2D(GL_TEXTURE_2D, index, static_cast<GLint>(format.internal), width, height, 0, GL_RGBA,
                     format.type, data);
    };
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    level(0, image.width, image.height, data_of(image.texels));
    for (std::size_t i = 0; i < levels.size(); ++i)
        level(static_cast<int>(i + 1), levels[i].width, levels[i].height, data_of(levels[i].texels));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()));
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
