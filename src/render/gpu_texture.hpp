#pragma once
// Images of a scene as GL textures with mip levels.
#include "gl/object.hpp"
#include "scene/material.hpp"

namespace sr::render {

/// Uploads an image; sRGB-encoded images are decoded by the sampler, after filtering in linear light.
/// @throws Error naming the image if the driver's largest texture is smaller.
gl::Texture upload(const scene::TextureImage& image, scene::ColorSpace color_space);

/// The filtering and wrapping that a scene's sampler asks for.
gl::Sampler sampler_object(const scene::Sampler& sampler);

} // namespace sr::render
