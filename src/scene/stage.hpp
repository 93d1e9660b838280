#pragma once
// Everything that a picture needs besides its size: what is seen, what lights it, who looks.
#include "scene/scene.hpp"

#include <optional>

namespace sr::scene {

/// What stands in for lamps: `automatic` is the studio where the scene's own light would leave it dark.
enum class Rig { automatic, studio, softboxes, none };

struct StageOptions {
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

struct Stage {
    Scene scene;               // with a surface for every visible light, unless emitters are hidden
    std::vector<Light> lights; // the scene's emitters, then its environment, then the rig
    Camera camera;
    Rig rig = Rig::none; // that lights the scene
    /// One line each: what was decided without being asked.
    std::vector<std::string> remarks;
};

/// @throws Error naming the cameras there are, if options.camera is none of them. `name` is the file's, for
/// messages.
Stage set_stage(Scene scene, const std::string& name, const StageOptions& options);

} // namespace sr::scene
