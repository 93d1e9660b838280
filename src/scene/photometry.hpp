#pragma once
// Flux, intensity, irradiance and radiance of an emitter, each from the others. Pure functions; angles in
// radians, lengths in metres, and whatever is said in lm, cd, lx and cd/m² holds for W, W/sr, W/m² and W/(m²
// sr).
#include "scene/scene.hpp"
#include "scene/spectrum.hpp"
#include "scene/units.hpp"

#include <optional>

namespace sr::scene {

/// A stated quantity in a scene's system: a watt counts `efficacy` lumens [lm/W].
double converted(double value, UnitSystem from, UnitSystem to, double efficacy);

/// A Lambertian emitter as far as its totals matter.
struct Radiator {
    double flux_area = 0.0; // Φ / (π L) [m²]: the area; twice it where both sides emit
    /// I / L on the axis [m²]: the area as seen along the emitter's axis; absent where it has none (a mesh).
    std::optional<double> axis_area;
};

// A flat emitter of area A: Φ = ∫ L A cosθ dω over its hemisphere = π A L, I = L A on its normal. A convex
// one that emits outwards: Φ = π A L again (each element by itself), I = L times its projection. Of a sphere
// that is π r² in every direction; a tube's axis is any direction across it, and its projection a stadium, 4
// r h + π r² for the half length h.
Radiator radiator_of(const RectangleLight& light);
Radiator radiator_of(const DiskLight& light);
Radiator radiator_of(const PolygonLight& light);
Radiator radiator_of(const SphereLight& light);
Radiator radiator_of(const TubeLight& light);
Radiator radiator_of(const MeshLight& light);

/// L of the radiator for a flux (Φ / (π flux_area)), an intensity on the axis (I / axis_area) or itself.
/// Absent: this quantity does not determine it (irradiance does not, nor does an intensity without an axis).
std::optional<double> radiance_from(Quantity quantity, double value, const Radiator& radiator);

/// I of a point: Φ / 4π; with a radius also from the radiance of its sphere, L π radius².
std::optional<double> point_intensity_from(Quantity quantity, double value, double radius);

/// ∫ f dω over KHR_lights_punctual's cone, f = saturate((cosθ - cos outer) / (cos inner - cos outer))² [sr].
/// With c = cosθ, w = cos inner - cos outer: 2π ((1 - cos inner) + ∫₀^w (t/w)² dt) = 2π (1 - cos inner + w /
/// 3). The extension's guard w >= 0.001 holds here as it does in shaders/. A hard cone's is 2π (1 - cos
/// outer).
double spot_solid_angle(double inner_angle, double outer_angle);

/// I on the axis of a spot: Φ over the solid angle above; with a radius also from the radiance on the axis.
std::optional<double> spot_intensity_from(Quantity quantity, double value, const SpotLight& spot);

/// E from itself; from a radiance where the light is a disk in the sky, E = π L sin²(angular radius). A flux
/// is none: what a parallel beam carries depends on how wide a scene it lights.
std::optional<double> sun_irradiance_from(Quantity quantity, double value, double angular_radius);

/// ∫ I dω of a profile [lm], exact for its interpolation: in closed form over γ, by trapezoids over φ.
double flux_of(const LightProfile& profile);

/// The flux of a light as RGB [lm or W]; the texture, where there is one, counts as white. Absent for
/// directional lights and environments, which have none of their own.
std::optional<vec3> flux_of(const Light& light, const std::vector<LightProfile>& profiles);

} // namespace sr::scene
