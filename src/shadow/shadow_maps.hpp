#pragma once
// The views of the scene from a point on an emitter that depth maps are drawn in.
#include "scene/lights/light.hpp"
#include "shadow/casters.hpp"

#include <span>

namespace sr::shadow {

/// All points within `radius` of `center`; nothing if the radius is negative.
struct Ball {
    vec3 center{0.0f};
    float radius = -1.0f; // [m]
};

/// The ball around finite points; points that are no numbers or beyond 1.8e18 m do not count.
Ball ball_around(std::span<const vec3> points);

/// The ball around balls.
Ball ball_around(std::span<const Ball> balls);

/// One perspective view where what is to be seen lies in a cone of less than 60° around an axis; else up to
/// six, the faces of a cube, of which a flat emitter needs five; of parallel light one orthographic view.
enum class MapKind { perspective, cube, orthographic };

/// The twin of MapPoint's maps in shaders/interface/maps.glsl. A face looks along one of the three axes, with
/// its sign, and is as wide as it is high: face 2 * axis + (1 if negative).
struct MapView {
    MapKind kind = MapKind::cube;
    vec3 origin{0.0f};    // the point; of an orthographic view the middle of the scene [m]
    mat3 axes{1.0f};      // orthonormal, right-handed; the last is the way of the light
    float scale = 1.0f;   // from axes to [-1, 1]
    float far = 1.0f;     // where depths end [m]
    bool is_half = false; // of a cube: nothing behind the plane of the first two axes

    static constexpr int forward_face = 4;
    bool has_face(int face) const;
};

/// How the scene is seen from `point` of `light`, in maps of size² texels. `receivers` is what has to be in
/// the picture, `casters` all that stands in the light's way; `roll` turns the maps' texels [rad].
MapView view_from(const scene::EmitterPoint& point, const scene::Light& light, const Ball& receivers,
                  const Ball& casters, float roll, int size);

/// To clip coordinates of that face; w of a perspective one is the distance along it over `far`.
mat4 clip_from_world(const MapView& view, int face);

/// Returns whether any of the ball may be in the face's picture.
bool may_see(const MapView& view, int face, const Ball& ball);

// Contents of the depth maps: the lights, and for each light the surfaces that it reaches.

struct ShadowMapScene {
    std::vector<scene::Light> lights;
    std::vector<Ball> casters;   // around each caster
    Ball all;                    // around all of them
    std::vector<Ball> receivers; // around what each light shines on: surfaces that reflect, but its own
};

/// `casters` are those of the scene under these lights.
ShadowMapScene map_stage_of(const scene::Scene& scene, std::span<const scene::Light> lights,
                            const Casters& casters);

/// Returns whether the caster can stand in the way of that light; the only surface of a flat or convex
/// emitter cannot stand in its own.
bool stands_in_light(const Caster& caster, int light);

/// Returns whether it is drawn into the maps of that light. Glass is not: it has a colour, which rays tell.
bool is_in_maps(const Caster& caster, int light);

} // namespace sr::shadow
