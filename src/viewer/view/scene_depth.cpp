#include "viewer/view/scene_depth.hpp"

#include "glsl/root.hpp"
#include "viewer/view/viewpoint.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace sr::viewer {

void SceneDepth::update(const render::GpuScene& scene, const scene::Camera& camera, int width, int height) {
    if (depth_ && depth_->width == width && depth_->height == height) return;
    render::RenderOptions options;
    options.shader = "views/ids_depth.frag";
    options.shader_path = {glsl::embedded()};
    options.estimates_error = false;
    options.samples = 1;
    options.width = width;
    options.height = height;
    if (!shaders_) shaders_ = render::Renderer::programs(options);
    render::Renderer renderer(scene, camera, options, shaders_);
    renderer.add_sample();
    depth_ = renderer.read_film();
    camera_ = camera;
}

bool SceneDepth::hides(vec3 point) const {
    if (!depth_ || !std::holds_alternative<scene::Perspective>(camera_.projection)) return false;
    const vec2 size(depth_->width, depth_->height);
    const auto place = projected(camera_, size.x / size.y, point);
    if (!place) return false;
    const glm::ivec2 pixel(glm::floor(*place * size));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= depth_->width || pixel.y >= depth_->height) return false;
    // The farthest surface around the pixel: a line on a surface that is seen at a slant is not hidden by it.
    float farthest = 0.0f;
    for (int y = std::max(0, pixel.y - 1); y <= std::min(depth_->height - 1, pixel.y + 1); ++y)
        for (int x = std::max(0, pixel.x - 1); x <= std::min(depth_->width - 1, pixel.x + 1); ++x) {
            const float depth = depth_->at(x, y)[2];
            if (depth <= 0.0f) return false; // the sky
            farthest = std::max(farthest, depth);
        }
    const mat4& camera = camera_.world_from_camera;
    constexpr float slack = 1.005f; // of lines that lie in a surface
    return glm::dot(point - vec3(camera[3]), -vec3(camera[2])) > slack * farthest;
}

} // namespace sr::viewer
