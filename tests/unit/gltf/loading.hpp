#pragma once
// Loading what a test has made.
#include "core/error.hpp"
#include "gltf/asset.hpp"
#include "support/address.hpp"
#include "support/made_gltf.hpp"
#include "support/models.hpp"

#include <string>

namespace sr::testing {

inline std::filesystem::path test_folder() { return scratch_folder("made"); }

inline gltf::Loaded load_text(std::string_view text, const gltf::LoadOptions& options = {}) {
    const auto file = test_folder() / "made.gltf";
    write_text(file, text);
    return gltf::load(file, options);
}

inline gltf::Loaded load(const MadeGltf& made, const gltf::LoadOptions& options = {}) {
    return load_text(made.gltf(), options);
}

/// Its first mesh.
inline scene::Mesh mesh_of(const MadeGltf& made) { return load(made).scene.meshes.at(0); }

/// Its first instance in the file's world: the scene's coordinates begin at scene.origin.
inline mat4 world_from_object(const scene::Scene& scene) {
    mat4 world = scene.instances.at(0).world_from_object;
    world[3] += vec4(vec3(scene.origin), 0.0f);
    return world;
}

/// Its first light, which is of that kind.
template<typename T>
T light_of(const MadeGltf& made) {
    return std::get<T>(load(made).scene.lights.at(0));
}

/// The error of a file, without the folder's name; empty if it loads.
inline std::string error_at(const std::filesystem::path& file, const gltf::LoadOptions& options = {}) {
    try {
        gltf::load(file, options);
    } catch (const Error& error) {
        const std::string text = error.what();
        const std::string folder = file.parent_path().string() + "/";
        return text.starts_with(folder) ? text.substr(folder.size()) : text;
    }
    return "";
}

inline std::string error_of(std::string_view text, const gltf::LoadOptions& options = {}) {
    const auto file = test_folder() / "made.gltf";
    write_text(file, text);
    return error_at(file, options);
}

inline std::string error_of(const MadeGltf& made, const gltf::LoadOptions& options = {}) {
    return error_of(made.gltf(), options);
}

/// The error of a file under --strict, whose one broken thing costs that thing and this warning without it.
inline std::string loss_of(const MadeGltf& made, gltf::LoadOptions options = {}) {
    options.is_strict = false;
    const gltf::Loaded loaded = load(made, options);
    options.is_strict = true;
    const std::string error = error_of(made, options);
    EXPECT_EQ(loaded.warnings.size(), 1u) << ::testing::PrintToString(loaded.warnings);
    const auto end = error.find(": correct it, or leave out --strict");
    const std::string what = error.substr(0, end == std::string::npos ? error.rfind(": ") : end);
    EXPECT_TRUE(!what.empty() && !loaded.warnings.empty()
                && loaded.warnings[0].find(what) != std::string::npos)
        << error << "\n"
        << ::testing::PrintToString(loaded.warnings);
    EXPECT_FALSE(loaded.scene.meshes.empty()); // the picture is still there
    return error;
}

/// Returns whether exactly one warning contains the text.
inline bool warns_once(const gltf::Loaded& loaded, std::string_view text) {
    int count = 0;
    for (const std::string& line : loaded.warnings) count += line.find(text) != std::string::npos;
    return count == 1;
}

} // namespace sr::testing
