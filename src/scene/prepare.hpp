#pragma once
// Everything that a picture needs besides its size: what is seen, what lights it, who looks.
#include "scene/scene.hpp"

#include <optional>

namespace sr::scene {

/// The lamps added to a scene: `automatic` is the studio where the scene's own light would leave it dark.
enum class Rig { automatic, studio, softboxes, none };

struct PrepareOptions {
    /// A camera of the scene by name or by index, "auto" for one that frames the scene, or a view in words
    /// (look_at.hpp). Empty: the scene's first camera, or "auto" if it has none.
    std::string camera;
    Rig rig = Rig::automatic;
    /// Width / height of the picture, which "auto" fits the scene into.
    float aspect_ratio = 16.0f / 9.0f;
    /// Leaves L_e out of what the camera sees, not out of the light: lights get no surface of their own, and
    /// emissive surfaces show only what they reflect. Unlit materials are no emitters and stay.
    bool hide_emitters = false;
    /// All that a scene reaches while it moves: what "auto" and the rig fit, so that they stand still.
    /// Absent: the scene as it is.
    std::optional<Bounds> extent{};
    /// In the place of the scene's own.
    std::optional<EnvironmentLight> environment{};
};

struct RenderScene {
    Scene scene;               // with a surface for every visible light, unless emitters are hidden
    std::vector<Light> lights; // the scene's emitters, then its environment, then the rig
    Camera camera;
    Rig rig = Rig::none; // that lights the scene
    /// One line each: what was decided without being asked.
    std::vector<std::string> remarks;
};

/// Returns the camera that options.camera names. @throws Error as prepare_scene()
Camera chosen_camera(const Scene& scene, const std::string& name, const PrepareOptions& options);

/// @throws Error naming the cameras there are, if options.camera is none of them. `name` is the file's, for
/// messages.
RenderScene prepare_scene(Scene scene, const std::string& name, const PrepareOptions& options);

/// Everything that lights a scene: its lights, then its emissive surfaces in world space. An untextured
/// instance whose triangles all pair up into rectangles (tolerance: a thousandth of an edge) is that many
/// rectangles, any other is one MeshLight.
std::vector<Light> emitters_of(const Scene& scene);

/// The same, and every instance learns which of these lights its surface is.
std::vector<Light> assign_emitters(Scene& scene);

/// Gives every visible light with an extent among scene.lights a surface of its own that emits and does not
/// reflect (surface_of). To be called after assign_emitters, which would take these surfaces for more lights,
/// and whose first lights are scene.lights.
/// @return how many instances were appended to scene.instances
int add_light_surfaces(Scene& scene);

/// A photographer's studio around the scene, as `camera` sees it: a key panel to its left, a fill panel to
/// its right, two strips behind the subject, a ceiling, and a room that darkens from there to the floor. It
/// is an environment, so that what is smooth has something to reflect wherever it looks. White that faces the
/// camera and a little upwards is 1 cd/m²; cameras do not see the studio.
EnvironmentLight studio(const Camera& camera);

/// Three softboxes (key, fill, rim) around `subject` as a photographer at `camera` would place them:
/// rectangles that scale with the subject, hidden from the camera. They give about 1000, 500 and 800 lx at
/// the subject's centre.
std::vector<RectangleLight> softbox_rig(const Bounds& subject, const Camera& camera);

/// Looks at the scene from the front, a little from the right and above (glTF: the front of an asset faces
/// +Z), as close as every vertex is in a picture of the given width / height, with a little air around.
Camera framing_camera(const Scene& scene, float aspect_ratio);

} // namespace sr::scene
