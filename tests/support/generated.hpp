#pragma once
// Pictures of many generated scenes by one OpenGL context and few programs.
#include "render/renderer.hpp"
#include "scene/stage.hpp"
#include "support/random_scene.hpp"

#include <functional>
#include <memory>

namespace sr::testing {

/// How pictures of generated scenes are made.
struct Look {
    int size = 32; // pixels an edge
    int samples = 1;
    std::uint32_t seed = 0;
    render::Visibility visibility = render::Visibility::ray;
    render::Estimator estimator = render::Estimator::sampled;
    bool knows_error = false;
};

/// Makes pictures of scenes, one after the other. Programs that one scene needed are there for the next.
class Pictures {
public:
    explicit Pictures(const Look& look);

    image::Image of(const scene::Stage& stage);
    /// The same with other samples, and seed.
    image::Image of(const scene::Stage& stage, int samples, std::uint32_t seed);
    std::size_t program_count() const { return shaders_->program_count(); }

private:
    Look look_;
    std::shared_ptr<render::ShaderLibrary> shaders_;
};

/// The scene of a file made in memory, from which nothing may be missing if `is_strict`. @throws Error
scene::Scene loaded(const MadeGltf& made, bool is_strict = true);

/// Its stage, by its own camera, without a rig. @throws Error
scene::Stage staged(scene::Scene scene);

/// Returns the number of scenes of each recipe: $STERADIAN_SCENES, or `usual`.
int scenes_of_a_recipe(int usual);

/// Returns the first seed of the scenes: $STERADIAN_SEED or 0.
std::uint64_t first_seed();

} // namespace sr::testing
