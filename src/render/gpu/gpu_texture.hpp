#pragma once
// Images of a scene as GL textures with mip levels.
#include "gl/object.hpp"
#include "render/gpu/mip_chain.hpp"
#include "scene/material.hpp"
#include "scene/measured_brdf.hpp"

namespace sr::render {

/// Uploads the levels of an image, level 0 first. Of TexelFormat::srgb8 the sampler decodes sRGB, so that
/// filtering is in linear light.
/// @throws Error naming the image if the driver's largest texture is smaller.
gl::Texture upload(const std::string& name, TexelFormat format, const std::vector<MipLevel>& levels);

/// A measured BRDF as a texture of 180 φ_d × 90 θ_d × 90 θ_h (shaders/brdf/merl.glsl), 17.5 MB.
gl::Texture upload(const scene::MeasuredBrdf& measured);

/// The filtering and wrapping that a scene's sampler asks for.
gl::Sampler sampler_object(const scene::Sampler& sampler);

} // namespace sr::render
