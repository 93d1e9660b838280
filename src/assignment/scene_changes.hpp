#pragma once
// Changes of one number of a scene, or of one of a student's parameters.
#include "assignment/parameters.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sr::assignment {

struct SceneChange {
    std::string what;            // "twice the intensity of 'lamp'"
    std::string pointer;         // JSON pointer into the glTF file; empty: a parameter
    std::string parameter;       // its name; empty: a number of the file
    nlohmann::ordered_json from; // null if the file does not have it
    nlohmann::ordered_json to;
    bool is_linear = false; // doubles all light of one kind, in which L_o is linear
};

/// Lists the changes that a glTF file allows: quantities, places and sizes of lights, roughness and base
/// colours of materials, places of objects.
std::vector<SceneChange> scene_changes(const nlohmann::ordered_json& gltf);

/// Lists a change for each parameter of the assignment: to the end of its range that is further away.
std::vector<SceneChange> parameter_changes(const Assignment& assignment, const Parameters& parameters);

} // namespace sr::assignment
