#pragma once
// Light: any emitter, and the functions that all of them have.
#include "scene/lights/disk.hpp"
#include "scene/lights/environment.hpp"
#include "scene/lights/mesh.hpp"
#include "scene/lights/polygon.hpp"
#include "scene/lights/punctual.hpp"
#include "scene/lights/rectangle.hpp"
#include "scene/lights/sphere.hpp"
#include "scene/lights/tube.hpp"

#include <type_traits>
#include <variant>

namespace sr::scene {

/// The index of a kind is its number in GLSL (shaders/interface/features.glsl).
using Light = std::variant<PointLight, SpotLight, DirectionalLight, RectangleLight, DiskLight, SphereLight,
                           TubeLight, PolygonLight, MeshLight, EnvironmentLight>;
inline constexpr std::size_t light_kind_count = std::variant_size_v<Light>;

/// Calls visit(std::type_identity<L>) for each kind of light L, in the order of Light.
template<class Visit>
constexpr void for_each_light_kind(const Visit& visit) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (visit(std::type_identity<std::variant_alternative_t<I, Light>>{}), ...);
    }
    (std::make_index_sequence<light_kind_count>{});
}

/// The index of the kind L.
template<class L>
constexpr std::size_t light_kind() {
    std::size_t index = 0, at = 0;
    for_each_light_kind([&]<class Other>(std::type_identity<Other>) {
        if (std::is_same_v<L, Other>) at = index;
        ++index;
    });
    return at;
}

/// "point", "spot", …, by index.
constexpr std::array<std::string_view, light_kind_count> light_kind_names() {
    std::array<std::string_view, light_kind_count> names{};
    std::size_t index = 0;
    for_each_light_kind([&]<class L>(std::type_identity<L>) { names[index++] = L::kind; });
    return names;
}

const std::string& name_of(const Light& light);
void set_name(Light& light, const std::string& name);

/// Its kind, with what changes how it is evaluated: "round point", "profile", "round spot", "sun".
std::string variety_of(const Light& light);

/// Returns true if cameras see the light, false if it is hidden from them; absent if it has no surface.
std::optional<bool> visibility_of(const Light& light);

/// True if a single-sided face that the light meets from behind casts no shadow of it. This holds for lights
/// that replace the surroundings of a model: they shine through each face that the camera looks through.
/// Other lights are blocked by both sides of every face. A kind of light states it by a member of this name.
bool passes_back_faces(const Light& light);

/// I, E or L of a light as RGB; a profile's factor.
vec3 quantity_of(const Light& light);
void set_quantity(Light& light, vec3 quantity);

/// Returns the kind of quantity that the light keeps: I, E or L. A profile's factor has no unit.
Quantity quantity_kind_of(const Light& light);
bool has_profile(const Light& light);
/// True if the light refers to other parts of its scene, a profile, a texture or a surface, or is all around
/// it.
bool needs_its_scene(const Light& light);

/// Returns the light's own quantity (I, E or L) for a stated one. Absent: the stated one does not determine
/// it.
template<class L>
std::optional<double> quantity_from(const L& light, Quantity quantity, double value) {
    if constexpr (requires { light.radiator(); })
        return radiance_from(quantity, value, light.radiator());
    else
        return light.quantity_from(quantity, value);
}

/// The flux of a light as RGB [lm or W]; the texture, where there is one, counts as white. Absent for
/// directional lights and environments, which have none of their own.
std::optional<vec3> flux_of(const Light& light, const std::vector<LightProfile>& profiles);

/// True if the light is more than one point or direction, so that its shadows have penumbrae.
bool has_extent(const Light& light);

/// Returns the point of the emitter that the random numbers u in [0, 1)³ choose.
EmitterPoint sample_point(const Light& light, vec3 u);
/// A point in the middle of the light, or near it.
EmitterPoint middle_of(const Light& light);

/// Where a light is, for lights that are somewhere: the middle of its extent.
std::optional<vec3> center_of(const Light& light);

/// The box around the light's extent, `min_half` metres or more in every direction from its center; empty for
/// a light that is nowhere.
Bounds bounds_of(const Light& light, float min_half);

/// Moves, turns and scales a light: points by the whole matrix, directions by its rotation, radii by the cube
/// root of its volume. A directional light only turns.
Light transformed(Light light, const mat4& by);

/// A size of a light as it is.
struct LightSize {
    std::string_view key; // as extras.steradian has it: width, height, length, radius
    float size = 0.0f;    // so stated [m]
    vec3 half{0.0f};      // from the center to the edge [m]; 0: a radius in all directions
};

/// The lengths of a light; none where only the whole can be scaled (polygons, meshes) or nothing (points
/// without a radius).
std::vector<LightSize> sizes_of(const Light& light);

/// Gives size number `index` another value, above 0 [m].
void set_size(Light& light, std::size_t index, float value);

/// Gives a light the sizes of another one of its kind.
void take_sizes_of(Light& light, const Light& other);

/// True if the light can be scaled.
bool is_scalable(const Light& light);

/// Returns the surface of the light, as cameras see it. Absent where they see nothing: the sun's disk, and
/// spots and profiles with a radius, whose radiance depends on the direction. A mesh's surface is the mesh
/// that it came from.
std::optional<LightSurface> surface_of(const Light& light);

} // namespace sr::scene
