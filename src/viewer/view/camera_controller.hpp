#pragma once
// Camera controller: a camera of the file, unchanged, or a free camera that a person moves.
#include "scene/prepare.hpp"
#include "viewer/bindings.hpp"
#include "viewer/view/viewpoint.hpp"

#include <string>

namespace sr::viewer {

/// A camera and its argument for `render --camera`.
struct NamedCamera {
    scene::Camera camera;
    std::string argument;
};

class CameraController {
public:
    /// `bounds`: the scene's, for near and far planes and for framing. `origin`: Scene::origin.
    CameraController(NamedCamera start, scene::Bounds bounds, float aspect_ratio,
                     glm::dvec3 origin = glm::dvec3(0.0));

    /// Uses a camera as it is.
    void use(NamedCamera camera);
    void set_aspect_ratio(float aspect_ratio);
    float aspect_ratio() const { return aspect_ratio_; }
    const scene::Bounds& bounds() const { return bounds_; }
    glm::dvec3 origin() const { return origin_; }
    /// Changes the origin of the scene. The camera keeps its place in the file's world.
    void set_origin(glm::dvec3 origin);
    /// Changes the bounds and, of a free camera, the near and far planes.
    void set_bounds(const scene::Bounds& bounds);
    /// Follows the file's cameras to another time, if one of them is in use. A camera that framed the scene
    /// becomes a free one and stays.
    void follow(const std::vector<scene::Camera>& cameras);

    const scene::Camera& camera() const { return camera_.camera; }
    /// Argument of `render --camera` for this view.
    const std::string& argument() const { return camera_.argument; }
    const Viewpoint& view() const { return view_; }

    /// Makes the camera a free one, at `view`.
    void move_to(const Viewpoint& view);

    /// The view in words, as scene::parse_look_at() reads it, whatever camera is in use.
    std::string look_at_text() const;
    /// Goes to such a view. @throws Error that says which part of the text is wrong
    void go_to(const std::string& look_at);

    /// Executes a command that moves the camera. `selection`: the bounds that frame_selection frames.
    /// @return false if it is no such command
    bool execute(Command command, const scene::Bounds& selection);

private:
    Viewpoint as_viewpoint() const;

    NamedCamera camera_;
    scene::Bounds bounds_;
    float aspect_ratio_;
    glm::dvec3 origin_;
    Viewpoint view_;
};

/// A camera of the file, named by its name if that is unique, or else by its index.
NamedCamera named_camera(const std::vector<scene::Camera>& cameras, std::size_t index);

/// The camera that prepare_scene() chose for the argument `wanted`.
NamedCamera named_camera(const scene::RenderScene& stage, const std::string& wanted);

} // namespace sr::viewer
