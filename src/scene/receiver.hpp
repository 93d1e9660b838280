#pragma once
// A rectangle on which light is measured, in any place of a scene.
#include "scene/scene.hpp"

namespace sr::scene {

/// A rectangle that receives light from the side that `normal` points to: corner + s u + t v, with s and t
/// from 0 to 1.
struct Receiver {
    vec3 corner{0.0f};         // [m]
    vec3 u{1.0f, 0.0f, 0.0f};  // [m]
    vec3 v{0.0f, 0.0f, -1.0f}; // [m], perpendicular to u
    vec3 normal() const;       // unit: along u × v
    vec3 at(float s, float t) const { return corner + s * u + t * v; }
};

/// The horizontal rectangle `height` metres above the lowest point of `bounds`, as wide and as deep as they
/// are, which receives light from above. `u` is along +X, `v` along -Z.
Receiver horizontal_receiver(const Bounds& bounds, float height);

/// Appends the receiver to the scene as a white Lambertian surface. It casts no shadow on its own front.
/// @return a camera that sees the receiver and nothing else: `u` to the right, `v` upwards
Camera add_receiver(Scene& scene, const Receiver& receiver);

} // namespace sr::scene
