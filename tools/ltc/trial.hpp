#pragma once
// Random emitters over a GGX surface, with what they reflect by brute force: what the analytic estimator is
// judged by.
#include "scene/lights/light.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sr::ltc {

enum class Shape { polygon, disk, sphere, tube };

/// White metal: F = 1, the GGX lobe alone. Plastic: glTF's dielectric, white with F0 = 0.04, both lobes.
enum class Material { metal, plastic };

/// The surface is at the origin, n = +z, wo in the plane y = 0. The emitter has radiance 1 and shines on it
/// from both sides if it is flat.
struct Trial {
    scene::Light light;
    double alpha = 1.0;
    double cos_o = 1.0;
    double reflected = 0.0; // ∫ f_r cosθ over the emitter, V = 1
};

/// A cell of the table: one roughness and a range of angles between n and wo [rad].
struct Cell {
    double roughness = 1.0;
    double min_angle = 0.0;
    double max_angle = 0.0;
};

/// `count` trials of emitters of random place and size, each with a view of its own, that reflect more than a
/// tenth of the albedo; by `points` directions of a lattice each. The same for the same seed.
std::vector<Trial> trials(Shape shape, Material material, const Cell& cell, int count, std::uint64_t seed,
                          int points);

/// Evaluates the trials by the shaders, with that many points a lobe. Needs a current context.
std::vector<double> evaluated(std::span<const Trial> trials, Material material, int analytic_points);

/// |got / expected - 1|, ascending.
std::vector<double> errors(std::span<const Trial> trials, std::span<const double> got);

} // namespace sr::ltc
