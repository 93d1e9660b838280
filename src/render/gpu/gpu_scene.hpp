#pragma once
// Scene in the memory of the GPU.
#include "render/gpu/blocks.hpp"
#include "render/gpu/features.hpp"
#include "render/gpu/gpu_mesh.hpp"
#include "render/gpu/gpu_texture.hpp"
#include "render/gpu/light_texels.hpp"
#include "render/gpu/ltc_table.hpp"
#include "render/gpu/texture_packing.hpp"
#include "render/visibility/visibility_backend.hpp"

#include <vector>

namespace sr::render {

/// One instance, ready to be drawn.
struct Draw {
    int mesh = 0;
    int instance = 0;
    int material = 0;
    Features features;
    vec3 center{0.0f};    // mean of its corners, world space; what blended instances are sorted by
    bool mirrors = false; // its front faces come out clockwise
    bool is_double_sided = false;
    bool is_surface = true; // false: lines or points, which have no back
    /// From 1 on: shaded pixel by pixel where the driver runs on the CPU (TriangleBuffer); 0: never so.
    int number = 0;
    // Of a draw with a number:
    scene::Bounds bounds{};
    mat4 world_from_object{1.0f};
};

/// Draws that have numbers, at most: a stencil buffer holds them.
inline constexpr int max_numbered_draws = 255;

/// The channels of textures that shaders can read in software GL: all, or those that the renderer's own do.
enum class TextureChannels { all, in_use };

class GpuScene {
public:
    /// Uploads `scene`, lit by `lights` (not by scene.lights). @throws Error for a texture beyond the
    /// driver's limits.
    /// `has_energy_compensation`: GGX keeps the light that scatters more than once
    /// (shaders/brdf/energy_compensation.glsl).
    GpuScene(const scene::Scene& scene, std::span<const scene::Light> lights,
             Visibility visibility = Visibility::ray, bool has_energy_compensation = false,
             TextureChannels channels = TextureChannels::all);

    /// Uploads other lights of the same scene and the surfaces that show them: the meshes from `first_mesh`
    /// on, all instances and all materials. Textures and the meshes before stay as they are. The shadow
    /// casters are rebuilt if `casters_change`, and always for depth maps. @throws Error where the driver's
    /// limits end; then it must be lit again, by others and with `casters_change`
    void relight(const scene::Scene& scene, std::span<const scene::Light> lights, std::size_t first_mesh,
                 bool casters_change);

    int light_count() const { return light_count_; }
    /// Indices of the environment lights that are visible behind all surfaces.
    const std::vector<int>& visible_environments() const { return visible_environments_; }
    int rays_per_light() const { return rays_per_light_; } // that a point of a surface sends
    /// Returns how many rays it sends at most to so many lights, one after the other.
    int most_rays(int lights) const;
    /// The shadow casters; null without shadows or without lights.
    const VisibilityBackend* visibility_backend() const { return visibility_backend_.get(); }
    const std::vector<Draw>& opaque_draws() const { return opaque_; } // opaque and masked, by program
    /// Draws of surfaces that let through light from behind: blended ones and glass, in the scene's order.
    const std::vector<Draw>& blended_draws() const { return blended_; }

    /// Returns the number of distinct sets of features of the draws. Each set needs its own programs.
    std::size_t feature_set_count() const;

    /// Binds the light table, the emitters' textures, the fitted lobes and the shadow casters to their units.
    void bind_lights() const;

    /// Binds the instance's and the material's data and draws with whatever program is in use.
    void draw(const Draw& draw) const;
    /// The same for some triangles of its mesh.
    void draw(const Draw& draw, const TriangleSelection& triangles) const;
    const GpuMesh& mesh_of(const Draw& draw) const { return meshes_[draw.mesh]; }
    /// Lets the program look up triangles of the mesh (shaders/interface/mesh.glsl).
    void show_arrays(const Draw& draw) const;

    /// Do the two steps of draw() alone; of the mesh one triangle is drawn.
    void bind(const Draw& draw) const;
    void draw_triangle(const Draw& draw, int triangle) const;

private:
    void update(const scene::Scene& scene, std::span<const scene::Light> lights); // all but the textures
    void upload_textures(const scene::Scene& scene, TextureChannels kept);
    void upload_objects(const scene::Scene& scene);
    void upload_materials(const scene::Scene& scene);
    void upload_lights(const scene::Scene& scene, std::span<const scene::Light> lights);
    void list_draws(const scene::Scene& scene, std::span<const scene::Light> lights);
    void number_draws(const scene::Scene& scene, int texture_units);
    void cast_shadows(const scene::Scene& scene, std::span<const scene::Light> lights);
    void bind_material(int material) const;

    Visibility visibility_;
    bool has_energy_compensation_;
    std::size_t max_floats_ = BufferTexture::max_texels(); // of a mesh whose triangles can be looked up
    std::vector<GpuMesh> meshes_;
    gl::Texture mesh_floats_{GL_TEXTURE_BUFFER, "the arrays of a mesh"};
    gl::Texture mesh_indices_{GL_TEXTURE_BUFFER, "the indices of a mesh"};
    TexturePacking packing_;
    std::vector<gl::Texture> images_; // one per ImageUse
    std::vector<gl::Sampler> samplers_;
    std::vector<int> image_of_texture_; // -1: none, since no material reads it
    std::vector<int> sampler_of_texture_;
    std::vector<std::array<int, slot_count>> textures_of_material_; // -1: none
    std::vector<int> measured_of_material_;                         // index into measured_; -1: none
    std::vector<gl::Texture> measured_;
    gl::Buffer objects_{"objects"};
    gl::Buffer materials_{"materials"};
    GLsizeiptr object_stride_ = 0;
    GLsizeiptr material_stride_ = 0;
    BufferTexture light_table_{"the emitters", GL_RGBA32F};
    EmissionMaps emission_maps_;
    BufferTexture emission_texels_{"the emitters' textures", GL_RGBA16F};
    EnvironmentTexels environments_;
    BufferTexture environment_texels_{"the environment", GL_RGBA32F};
    std::vector<int> visible_environments_;
    gl::Texture ltc_texture_ = upload_ltc_table();
    int light_count_ = 0;
    int rays_per_light_ = 1;
    std::vector<int> rays_to_light_;
    std::unique_ptr<VisibilityBackend> visibility_backend_;
    std::vector<Draw> opaque_;
    std::vector<Draw> blended_;
};

} // namespace sr::render
