#pragma once
// The Scene: plain data in SI units, world space, right-handed, +Y up. No GL and no glTF in sight.
#include "scene/camera.hpp"
#include "scene/ies.hpp"
#include "scene/lights/light.hpp"
#include "scene/material.hpp"
#include "scene/measured_brdf.hpp"
#include "scene/mesh.hpp"
#include "scene/units.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sr::scene {

/// Some of the lights that go with a scene: those from `first` up to the one before `end`.
struct LightRange {
    int first = 0;
    int end = 0;

    bool is_empty() const { return first >= end; }
    bool contains(int light) const { return first <= light && light < end; }
};

/// A mesh placed in the world. The transform may mirror (negative determinant).
struct Instance {
    int mesh = 0;
    mat4 world_from_object{1.0f};
    std::string name;
    LightRange emits_as{};  // which lights of the RenderScene this surface is; empty: none
    int node = -1;          // of the file, whose mesh it is; negative: none
    bool is_hidden = false; // not drawn, casts no shadow, emits nothing
};

struct Scene {
    /// The point of the file's world where the coordinates of this scene are zero [m]. Instances, lights and
    /// cameras are relative to it, so that distant ones keep their digits. What people read and write adds
    /// it.
    glm::dvec3 origin{0.0};
    std::vector<TextureImage> images;
    std::vector<Texture> textures;
    std::vector<Material> materials; // never empty if there are meshes
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Light> lights; // what the file calls lights; emissive surfaces: see emitters.hpp
    std::optional<EnvironmentLight> environment; // what the file says of light from outside
    std::vector<LightProfile> profiles;
    std::vector<MeasuredBrdf> measured; // what materials of Model::merl read
    /// The units of the lights and the film: cd/m² or W/(m² sr).
    UnitSystem units = UnitSystem::photometric;
    std::vector<Camera> cameras;
};

/// The box around all vertices of all instances.
Bounds bounds_of(const Scene& scene);

/// An origin near the middle of most instances; zero for a scene that stands near its own. A float's rounding
/// is then small against the scene. Each coordinate is a multiple of a power of two that floats hold exactly.
glm::dvec3 fitting_origin(const Scene& scene);

std::size_t triangle_count(const Scene& scene);

/// True if no light touches the mesh: its material is unlit, or it is lines or points without normals (glTF
/// 2.0, section 3.9.7).
bool is_unlit(const Mesh& mesh, const Material& material);

/// True if the mesh encloses a volume: every edge of a triangle is also an edge of another triangle, in the
/// opposite direction. Corners at the same place count as one.
bool is_closed(const Mesh& mesh);

/// True if KHR_materials_volume fills the mesh, so that a ray that enters it leaves it elsewhere.
bool is_body_of_glass(const Mesh& mesh, const Material& material);

} // namespace sr::scene
