#pragma once
// Whether a scene's own light would leave it dark.
#include "scene/scene.hpp"

#include <optional>
#include <span>

namespace sr::scene {

/// How much of what the camera sees the lights would show: the share of its points that get, as white would send
/// it back, at least a 500th of what is bright in the picture. That is its 98th percentile, of points and of what
/// shines itself there, since automatic exposure looks to no more; a 500th of it is black on a screen. What is
/// unlit needs no light and is no such point. An estimate by a picture of 64×36 points, lights seen without their
/// shadows and from their middles.
/// @return absent if the camera sees nothing that needs light
std::optional<float> lit_share(const Scene& scene, std::span<const Light> lights, const Camera& camera,
                               float aspect_ratio);

/// Below this share almost nothing is lit.
inline constexpr float least_lit_share = 0.15f;

} // namespace sr::scene
