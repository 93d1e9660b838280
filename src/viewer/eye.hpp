#pragma once
// The camera in use: one of the file's, exactly as it is there, or a free one that a person moves.
#include "scene/prepare.hpp"
#include "viewer/bindings.hpp"
#include "viewer/viewpoint.hpp"

#include <string>

namespace sr::viewer {

/// A camera, and what `render --camera` calls it.
struct NamedCamera {
    scene::Camera camera;
    std::string argument;
};

class Eye {
public:
    /// `bounds` are the scene's, which near and far planes and framing go by; `origin` is Scene::origin.
    Eye(NamedCamera start, scene::Bounds bounds, float aspect_ratio, glm::dvec3 origin = glm::dvec3(0.0));

    /// Takes a camera over as it is.
    void take(NamedCamera camera);
    void set_aspect_ratio(float aspect_ratio);
    float aspect_ratio() const { return aspect_ratio_; }
    const scene::Bounds& bounds() const { return bounds_; }
    glm::dvec3 origin() const { return origin_; }
    /// The scene is told from elsewhere now: the camera stays where it is in the file's world.
    void set_origin(glm::dvec3 origin);
    /// A free camera's near and far planes follow.
    void set_bounds(const scene::Bounds& bounds);
    /// The file has its cameras elsewhere now: one of them that is in use is followed, and one that framed
    /// the scene stays where it is, as a free one.
    void follow(const std::vector<scene::Camera>& cameras);

    const scene::Camera& camera() const { return camera_.camera; }
    /// What follows --camera to get this picture.
    const std::string& argument() const { return camera_.argument; }
    const Viewpoint& view() const { return view_; }

    /// The camera follows the viewpoint from now on.
    void move_to(const Viewpoint& view);

    /// Does what a camera's key says. `selection`: what framing it means. @return whether it was such a key
    bool obey(Command command, const scene::Bounds& selection);

private:
    Viewpoint as_viewpoint() const;

    NamedCamera camera_;
    scene::Bounds bounds_;
    float aspect_ratio_;
    glm::dvec3 origin_;
    Viewpoint view_;
};

/// A camera that stands in the file, called by its name where that is unmistakable, or else by its number.
NamedCamera named_camera(const std::vector<scene::Camera>& cameras, std::size_t index);

/// The camera that set_stage() chose for `wanted`.
NamedCamera named_camera(const scene::Stage& stage, const std::string& wanted);

} // namespace sr::viewer
