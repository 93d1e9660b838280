#pragma once
// Small scenes whose radiance has a closed form.
#include "image/image.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace sr::testing {

/// A square in the plane y = 0 around the origin, facing up, of Lambertian albedo rho and nothing else.
scene::Scene lambert_plane(float half_edge, vec3 rho = vec3(1.0f));

/// Looks straight down at the origin; the picture covers [-half_extent, half_extent]². Column x of an N×N
/// picture lies at world x, row y at world z.
scene::Camera camera_from_above(float half_extent);

/// The place of a pixel's centre on the plane y = 0 under camera_from_above.
vec2 place_of(int column, int row, int size, float half_extent);

/// The mean of `samples` samples of an N×N picture.
image::Image picture(const scene::Scene& scene, std::span<const scene::Light> lights,
                     const scene::Camera& camera, int size, int samples = 1, std::uint32_t seed = 0,
                     render::Visibility visibility = render::Visibility::ray);

/// A material of Lambertian albedo rho and nothing else.
scene::Material lambert(vec3 rho = vec3(1.0f));

/// Adds the flat parallelogram center ± half_u ± half_v, whose front is cross(half_u, half_v); uv goes from
/// (0, 0) to (1, 1) along them. @return its instance, to be changed at will
scene::Instance& add_quad(scene::Scene& scene, vec3 center, vec3 half_u, vec3 half_v,
                          const scene::Material& material);

/// Adds the box center ± axis 0 ± axis 1 ± axis 2, each face of cells² squares that share their corners to
/// the last bit.
void add_box(scene::Scene& scene, vec3 center, const mat3& half_axes, int cells,
             const scene::Material& material);

/// max |a - b| / max(|b|, floor) over all pixels of the first three channels.
float max_relative_difference(const image::Image& a, const image::Image& b, float floor);

} // namespace sr::testing
