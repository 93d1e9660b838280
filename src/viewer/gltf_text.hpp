#pragma once
// The JSON of a glTF file as text that can be changed in places, its other bytes as they are.
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace sr::viewer {

struct GltfText {
    nlohmann::ordered_json json;
    bool is_binary = false;
    std::vector<std::uint8_t> chunks; // of a .glb, behind its JSON
};

/// @throws Error if it cannot be read
GltfText read_gltf(const std::filesystem::path& file);

/// The file's bytes, in the form that it had.
std::vector<std::uint8_t> bytes_of(const GltfText& gltf);

/// The index of a new node, appended to the nodes.
std::size_t append_node(nlohmann::ordered_json& gltf, nlohmann::ordered_json node);

/// Puts a node among the roots of the scene: the given one, or the file's default; `is_first`: before all
/// others.
void add_root(nlohmann::ordered_json& gltf, std::size_t node, std::optional<int> scene, bool is_first);

/// Where a node stands at rest, by the transforms of its ancestors.
glm::dmat4 world_from_node(const nlohmann::ordered_json& gltf, std::size_t node);

nlohmann::ordered_json matrix_json(const glm::dmat4& matrix);

} // namespace sr::viewer
