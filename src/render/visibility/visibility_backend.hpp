#pragma once
// How V(x, y) of the equation is found.
#include "render/visibility/gpu_casters.hpp"
#include "shadow/occlusion.hpp"
#include "shadow/shadow_maps.hpp"

#include <memory>
#include <optional>

namespace sr::render {

enum class Visibility {
    none,        // V = 1: no shadows
    ray,         // a ray to each sample: on the CPU where GL is software, in the shader elsewhere
    ray_on_cpu,  // by Embree
    ray_in_glsl, // by the shader's walk
    map          // depth maps from points on the emitters, new ones each frame
};

/// "ray", "ray-cpu", "ray-glsl", "map", "none"; absent for any other name.
std::optional<Visibility> visibility_named(std::string_view name);
std::string_view name_of(Visibility visibility);

/// A scene's shadow casters, ready for queries.
class VisibilityBackend {
public:
    /// `visibility` is not none. With `has_blended_receivers` the shader's tree is made in any case: several
    /// layers of a pixel cannot be written out for the CPU. @throws Error
    VisibilityBackend(const scene::Scene& scene, std::span<const scene::Light> lights, Visibility visibility,
                      bool has_blended_receivers);

    /// The CPU's answers; null where the shader finds them itself.
    const shadow::Occlusion* occlusion() const { return occlusion_.get(); }

    /// The contents of the depth maps; null where V is found by rays.
    const shadow::ShadowMapScene* shadow_map_scene() const {
        return shadow_map_scene_ ? &*shadow_map_scene_ : nullptr;
    }
    const shadow::Casters& casters() const { return casters_; }

    /// Binds what visibility/ray.glsl and visibility/map.glsl read, if there is anything.
    void bind() const;

    std::size_t triangle_count() const { return casters_.triangle_count(); }
    std::size_t node_count() const { return node_count_; } // of the shader's tree, 0 if there is none
    double build_seconds() const { return build_seconds_; }

private:
    shadow::Casters casters_;
    std::unique_ptr<shadow::Occlusion> occlusion_;
    std::optional<GpuCasters> gpu_casters_;
    std::optional<shadow::ShadowMapScene> shadow_map_scene_;
    std::size_t node_count_ = 0;
    double build_seconds_ = 0.0;
};

} // namespace sr::render
