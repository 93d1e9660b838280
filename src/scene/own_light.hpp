#pragma once
// The share of a scene that its own light reaches.
#include "scene/scene.hpp"

#include <optional>
#include <span>

namespace sr::scene {

/// Estimates the share of the visible points that the lights reach: those that receive, as a white surface
/// would reflect it, at least a 200th of the bright parts of the picture. That is the 95th percentile of
/// points and of what shines itself there: automatic exposure lets a tenth of the picture be brighter than
/// white. What is unlit needs no light and is no such point. An estimate by a picture of 64×36 points: lights
/// are seen without shadows and from their middles, and textured emission, which is mostly painted glow, is
/// no light.
/// @return absent if the camera sees nothing that needs light
std::optional<float> lit_share(const Scene& scene, std::span<const Light> lights, const Camera& camera,
                               float aspect_ratio);

/// Below this share almost nothing is lit. A file that places lamps may mean a pool of light in the dark;
/// what only glows, such as headlights and signs, is no lighting.
inline float min_lit_share(const Scene& scene) { return scene.lights.empty() ? 0.15f : 0.02f; }

} // namespace sr::scene
