#include "render/visibility/visibility_backend.hpp"

#include "core/error.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <chrono>

namespace sr::render {
namespace {

constexpr std::array<std::pair<std::string_view, Visibility>, 5> names{{{"none", Visibility::none},
                                                                        {"ray", Visibility::ray},
                                                                        {"ray-cpu", Visibility::ray_on_cpu},
                                                                        {"ray-glsl", Visibility::ray_in_glsl},
                                                                        {"map", Visibility::map}}};

bool is_for_cpu(Visibility visibility) {
    if (visibility != Visibility::ray) return visibility == Visibility::ray_on_cpu;
    return gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}

} // namespace

std::optional<Visibility> visibility_named(std::string_view name) {
    const auto found = std::ranges::find(names, name, &decltype(names)::value_type::first);
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

std::string_view name_of(Visibility visibility) {
    return std::ranges::find(names, visibility, &decltype(names)::value_type::second)->first;
}

VisibilityBackend::VisibilityBackend(const scene::Scene& scene, std::span<const scene::Light> lights,
                                     Visibility visibility, bool has_blended_receivers) {
    require(visibility != Visibility::none, "somebody asks for shadows");
    const auto begin = std::chrono::steady_clock::now();
    casters_ = shadow::collect_casters(scene, lights);
    if (visibility == Visibility::map) {
        shadow_map_scene_ = shadow::map_stage_of(scene, lights, casters_);
        gpu_casters_.emplace(casters_);
    } else if (is_for_cpu(visibility)) {
        occlusion_ = std::make_unique<shadow::Occlusion>(casters_);
    }
    if (!shadow_map_scene_ && (!occlusion_ || has_blended_receivers)) {
        const shadow::Bvh bvh = shadow::build_bvh(casters_);
        node_count_ = bvh.nodes.size();
        gpu_casters_.emplace(casters_, bvh);
    }
    build_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void VisibilityBackend::bind() const {
    if (gpu_casters_) gpu_casters_->bind();
}

} // namespace sr::render
