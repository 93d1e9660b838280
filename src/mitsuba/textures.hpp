#pragma once
// Textures as Mitsuba's bitmaps: linear values in EXR files, so that no colour conversion is left to anybody.
#include "mitsuba/xml.hpp"
#include "scene/lights/environment.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <map>

namespace sr::mitsuba {

/// The part of a texel that is exported.
enum class Part { color, alpha };

class Textures {
public:
    /// Files go to folder/textures/.
    Textures(const scene::Scene& scene, std::filesystem::path folder)
        : scene_(scene), folder_(std::move(folder)) {}

    /// Writes the texture's file, unless it is there, and a <texture> of that name that reads it.
    /// @param factor multiplies every texel; @param uv_transform as scene::TextureSlot has it
    /// @throws Error if the file cannot be written.
    void write(Xml& xml, std::string_view name, int texture, const mat3& uv_transform,
               Part part = Part::color, vec3 factor = vec3(1.0f));

    /// Writes an environment, every texel times `factor`, as an equirectangular picture that Mitsuba's envmap
    /// reads as the same function of the direction. @return the file's name within the folder
    /// @throws Error if the file cannot be written.
    std::string file_of(const scene::EnvironmentMap& map, vec3 factor);

    /// Features that could not be exported, one line each.
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    std::string file_of(int texture, Part part, vec3 factor);

    const scene::Scene& scene_;
    std::filesystem::path folder_;
    std::map<std::string, std::string> files_; // by what is in them
    std::vector<std::string> warnings_;
};

} // namespace sr::mitsuba
