#pragma once
// A glTF file that Python renders again and again: its scene, and what of it is on the GPU.
#include "gl/context.hpp"
#include "gltf/asset.hpp"
#include "picture/draw.hpp"
#include "python/gl_thread.hpp"
#include "python/lights.hpp"
#include "render/gpu/gpu_scene.hpp"
#include "render/probe.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace sr::python {

/// A picture with what it was made by.
struct RenderedPicture {
    picture::Picture picture;
    settings::RenderSettings settings;
    std::string summary; // JSON, as `render --json` prints it
};

/// The probe of a pixel, with the lights that its terms belong to.
struct ProbedPicture {
    render::PixelTerms terms;
    std::vector<scene::Light> lights;
    glm::dvec3 origin{0.0};
    settings::Size size;
    std::string camera;
};

class SceneFile {
public:
    /// Reads the file. Of the settings it takes scene_index, variant and is_strict. @throws Error
    SceneFile(const std::string& file, const settings::RenderSettings& settings);
    ~SceneFile();
    SceneFile(const SceneFile&) = delete;
    SceneFile& operator=(const SceneFile&) = delete;

    const std::string& file() const { return file_; }
    /// A number that no other SceneFile of the process has, above 0.
    int number() const { return number_; }
    /// The contents of the file; the same at all times.
    const gltf::Contents& contents() const { return contents_; }
    /// Scene::origin, which stays.
    glm::dvec3 origin() const { return origin_; }
    /// The file's warnings so far. On the GL thread, or before the first rendering.
    std::vector<std::string> warnings() const { return asset_.warnings(); }
    /// The scene at rest. Only before the first rendering, which changes it on the GL thread.
    const scene::Scene& scene() const { return scene_; }

    /// Renders it as `steradian render` does. On the GL thread. @throws Error, BadSetting
    RenderedPicture render(settings::RenderSettings settings, const SceneEdits& edits, Call& call);
    /// Probes a pixel. On the GL thread. @return absent if it was stopped. @throws Error, BadSetting
    std::optional<ProbedPicture> probe(settings::RenderSettings settings, const SceneEdits& edits, int column,
                                       int row, Call& call);

    /// The camera that `camera` names, as PrepareOptions::camera does. On the GL thread. @throws Error
    scene::Camera camera(const std::string& camera, const SceneEdits& edits);
    /// Writes a copy of the file, as it was read, with the edits, and with `camera`, unless it is empty, as
    /// its first one. On the GL thread. @throws Error as gltf::write_edited_copy() does, and where the target
    /// is the file itself
    void save(const std::string& target, const SceneEdits& edits, const std::string& camera);

private:
    /// The parts that live on the GPU.
    struct OnGpu;
    /// A scene that is ready to be drawn; gives the scene back at its end.
    struct Staged;

    /// For each light of the scene as it is now its number among those at rest; negative where it is none.
    std::vector<int> light_numbers() const;
    OnGpu& upload(const settings::RenderSettings& settings, const scene::RenderScene& stage);

    std::string file_;
    int number_;
    std::optional<int> scene_index_;
    gltf::Asset asset_;
    scene::Scene scene_; // as it was rendered last
    gltf::Contents contents_;
    glm::dvec3 origin_;
    std::unique_ptr<OnGpu> gpu_;
};

} // namespace sr::python
