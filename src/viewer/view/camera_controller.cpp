#include "viewer/view/camera_controller.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {
namespace {

constexpr float key_angle = pi / 36.0f; // [rad] an arrow key: 5 degrees
constexpr float key_pan = 0.05f;        // of the picture's height
constexpr float key_dolly = 0.9f;
constexpr float key_lens = 0.95f;

/// Moves by a step. @return false if the command is another
bool move_by_step(Viewpoint& view, Command command) {
    using enum Command;
    switch (command) {
    case orbit_left: orbit(view, {-key_angle, 0.0f}); return true;
    case orbit_right: orbit(view, {key_angle, 0.0f}); return true;
    case orbit_up: orbit(view, {0.0f, -key_angle}); return true;
    case orbit_down: orbit(view, {0.0f, key_angle}); return true;
    case pan_left: pan(view, {-key_pan, 0.0f}); return true;
    case pan_right: pan(view, {key_pan, 0.0f}); return true;
    case pan_up: pan(view, {0.0f, -key_pan}); return true;
    case pan_down: pan(view, {0.0f, key_pan}); return true;
    case dolly_in: dolly(view, key_dolly); return true;
    case dolly_out: dolly(view, 1.0f / key_dolly); return true;
    case roll_left: roll(view, key_angle); return true;
    case roll_right: roll(view, -key_angle); return true;
    case level: viewer::level(view); return true;
    default: return false;
    }
}

/// Looks along an axis of the world. @return false if the command is another
bool face_side(Viewpoint& view, Command command) {
    using enum Command;
    switch (command) {
    case view_front: face(view, Side::front); return true;
    case view_back: face(view, Side::back); return true;
    case view_right: face(view, Side::right); return true;
    case view_left: face(view, Side::left); return true;
    case view_top: face(view, Side::top); return true;
    case view_bottom: face(view, Side::bottom); return true;
    case view_opposite: orbit(view, {pi, 0.0f}); return true;
    default: return false;
    }
}

/// Changes the field of view. An orthographic view keeps its height.
void set_lens(Viewpoint& view, float yfov) {
    constexpr float min_yfov = 0.005f, max_yfov = 2.8f; // [rad]
    const float half_height = view.half_height();
    view.yfov = std::clamp(yfov, min_yfov, max_yfov);
    if (!view.is_orthographic) return;
    view.distance = half_height / std::tan(0.5f * view.yfov);
}

} // namespace

CameraController::CameraController(NamedCamera start, scene::Bounds bounds, float aspect_ratio,
                                   glm::dvec3 origin)
    : camera_(std::move(start)),
      bounds_(bounds),
      aspect_ratio_(aspect_ratio),
      origin_(origin),
      view_(as_viewpoint()) {}

void CameraController::set_origin(glm::dvec3 origin) {
    const vec3 shift(origin_ - origin);
    if (shift == vec3(0.0f)) return;
    origin_ = origin;
    Viewpoint view = view_;
    view.pivot += shift;
    move_to(view);
}

Viewpoint CameraController::as_viewpoint() const {
    return viewpoint_of(camera_.camera, aspect_ratio_, bounds_.is_empty() ? vec3(0.0f) : bounds_.center());
}

void CameraController::use(NamedCamera camera) {
    camera_ = std::move(camera);
    view_ = as_viewpoint();
}

void CameraController::set_aspect_ratio(float aspect_ratio) { aspect_ratio_ = aspect_ratio; }

void CameraController::set_bounds(const scene::Bounds& bounds) {
    bounds_ = bounds;
    if (scene::is_look_at(camera_.argument))
        camera_.camera =
            scene::camera_at(scene::parse_look_at(camera_.argument, origin_), bounds_, aspect_ratio_);
}

void CameraController::follow(const std::vector<scene::Camera>& cameras) {
    if (camera_.argument == "auto") return move_to(view_);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const NamedCamera named = named_camera(cameras, i);
        if (named.argument == camera_.argument || std::to_string(i) == camera_.argument)
            return use({cameras[i], camera_.argument});
    }
}

void CameraController::move_to(const Viewpoint& view) {
    view_ = view;
    scene::LookAt description = look_at(view);
    description.origin = origin_;
    camera_ = {scene::camera_at(description, bounds_, aspect_ratio_), scene::text_of(description)};
}

std::string CameraController::look_at_text() const {
    if (scene::is_look_at(camera_.argument)) return camera_.argument;
    scene::LookAt description = look_at(view_);
    description.origin = origin_;
    return scene::text_of(description);
}

void CameraController::go_to(const std::string& look_at) {
    const scene::LookAt view = scene::parse_look_at(look_at, origin_);
    use({scene::camera_at(view, bounds_, aspect_ratio_), scene::text_of(view)});
}

bool CameraController::execute(Command command, const scene::Bounds& selection) {
    Viewpoint view = view_;
    switch (command) {
    case Command::frame_all: frame(view, bounds_, aspect_ratio_); break;
    case Command::frame_selection:
        frame(view, selection.is_empty() ? bounds_ : selection, aspect_ratio_);
        break;
    case Command::toggle_orthographic: view.is_orthographic = !view.is_orthographic; break;
    case Command::narrower: set_lens(view, view.yfov * key_lens); break;
    case Command::wider: set_lens(view, view.yfov / key_lens); break;
    default:
        if (!move_by_step(view, command) && !face_side(view, command)) return false;
    }
    move_to(view);
    return true;
}

NamedCamera named_camera(const std::vector<scene::Camera>& cameras, std::size_t index) {
    const std::string& name = cameras[index].name;
    const bool is_unique = !name.empty() && name != "auto" && !scene::is_look_at(name)
                           && name.find_first_not_of("0123456789") != std::string::npos
                           && name.find('\'') == std::string::npos
                           && std::ranges::count(cameras, name, &scene::Camera::name) == 1;
    return {cameras[index], is_unique ? name : std::to_string(index)};
}

NamedCamera named_camera(const scene::RenderScene& stage, const std::string& wanted) {
    if (!wanted.empty()) return {stage.camera, wanted};
    if (stage.scene.cameras.empty()) return {stage.camera, "auto"};
    return named_camera(stage.scene.cameras, 0);
}

} // namespace sr::viewer
