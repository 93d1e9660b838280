#pragma once
// What else of each pixel an EXR can hold: distances, directions, terms of the equation, numbers ("arbitrary
// output variables").
#include "cli/layers.hpp"

#include <optional>

namespace sr::cli {

enum class Aov { depth, normal, albedo, visibility, cosine, irradiance, object, material, samples, error };

const char* name_of(Aov aov);
std::vector<std::string> aov_names(); // all of them
std::string aov_help();               // what --aov says of itself

/// "depth,normal"; absent if one is unknown or named twice.
std::optional<std::vector<Aov>> parsed_aovs(const std::string& text);

/// What the pictures are made of.
struct AovSource {
    const render::GpuScene& scene;
    const scene::Camera& camera;
    render::RenderOptions options; // the picture's own
    std::vector<int> samples;      // of each pixel
    std::optional<render::ErrorEstimate> error;
};

/// The planes of these, in the order of `aovs`. `goes_on` is asked after every sample.
/// @return nothing if it said no
std::vector<Plane> aov_planes(const std::vector<Aov>& aovs, const AovSource& source,
                              const std::function<bool()>& goes_on);

/// The names that object and material numbers stand for, as JSON arrays: steradian:objects,
/// steradian:materials.
std::vector<image::Attribute> name_tables(const std::vector<Aov>& aovs, const scene::Scene& scene);

} // namespace sr::cli
