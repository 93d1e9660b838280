#include "viewer/gltf_text.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace sr::viewer {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t glb_head = 12, chunk_head = 8; // glTF 2.0, section 4.4 [bytes]

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

void append_word(std::vector<std::uint8_t>& bytes, std::size_t value) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

glm::dvec4 numbers(const ordered_json& node, const char* key, glm::dvec4 fallback) {
    const auto found = node.find(key);
    if (found == node.end()) return fallback;
    for (std::size_t i = 0; i < found->size() && i < 4; ++i)
        fallback[static_cast<int>(i)] = (*found)[i].get<double>();
    return fallback;
}

glm::dmat4 local(const ordered_json& node) {
    glm::dmat4 m(1.0);
    if (const auto matrix = node.find("matrix"); matrix != node.end()) {
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = (*matrix)[static_cast<std::size_t>(i)].get<double>();
        return m;
    }
    const glm::dvec4 t = numbers(node, "translation", {0, 0, 0, 0}),
                     r = numbers(node, "rotation", {0, 0, 0, 1}), s = numbers(node, "scale", {1, 1, 1, 0});
    return glm::translate(m, glm::dvec3(t)) * glm::mat4_cast(glm::dquat(r.w, r.x, r.y, r.z))
           * glm::scale(glm::dmat4(1.0), glm::dvec3(s));
}

} // namespace

GltfText read_gltf(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file(file, file.string());
    GltfText gltf;
    auto begin = bytes.begin(), end = bytes.end();
    if (bytes.size() > glb_head + chunk_head && std::equal(begin, begin + 4, "glTF")) {
        const std::size_t length = word(bytes, glb_head);
        if (length > bytes.size() - glb_head - chunk_head)
            throw Error({file.string()}, "it is cut short", "put it back");
        gltf.is_binary = true;
        begin += glb_head + chunk_head;
        end = begin + static_cast<std::ptrdiff_t>(length);
        gltf.chunks.assign(end, bytes.end());
    }
    gltf.json = ordered_json::parse(begin, end, nullptr, false);
    if (!gltf.json.is_object()) throw Error({file.string()}, "is not glTF any more", "put it back");
    return gltf;
}

std::vector<std::uint8_t> bytes_of(const GltfText& gltf) {
    std::string text = gltf.is_binary ? gltf.json.dump() : gltf.json.dump(2) + "\n";
    if (!gltf.is_binary) return {text.begin(), text.end()};
    while (text.size() % 4) text += ' ';
    std::vector<std::uint8_t> bytes{'g', 'l', 'T', 'F'};
    append_word(bytes, 2);
    append_word(bytes, glb_head + chunk_head + text.size() + gltf.chunks.size());
    append_word(bytes, text.size());
    append_word(bytes, 0x4E4F534A); // "JSON"
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.insert(bytes.end(), gltf.chunks.begin(), gltf.chunks.end());
    return bytes;
}

std::size_t append_node(ordered_json& gltf, ordered_json node) {
    gltf["nodes"].push_back(std::move(node));
    return gltf["nodes"].size() - 1;
}

void add_root(ordered_json& gltf, std::size_t node, std::optional<int> scene, bool is_first) {
    if (!gltf.contains("scenes") || gltf["scenes"].empty()) return; // all nodes without a parent are shown
    const int index = scene.value_or(gltf.value("scene", 0));
    ordered_json& roots = gltf["scenes"][static_cast<std::size_t>(index)]["nodes"];
    if (roots.is_null()) roots = ordered_json::array();
    if (is_first)
        roots.insert(roots.begin(), node);
    else
        roots.push_back(node);
}

glm::dmat4 world_from_node(const ordered_json& gltf, std::size_t node) {
    const ordered_json& nodes = gltf["nodes"];
    glm::dmat4 m = local(nodes[node]);
    for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
        const auto children = nodes[parent].find("children");
        if (children == nodes[parent].end()
            || std::none_of(children->begin(), children->end(),
                            [&](const ordered_json& child) { return child.get<std::size_t>() == node; }))
            continue;
        return world_from_node(gltf, parent) * m; // a node has one parent, and no cycle: the loader saw to it
    }
    return m;
}

ordered_json matrix_json(const glm::dmat4& matrix) {
    ordered_json json = ordered_json::array();
    for (int i = 0; i < 16; ++i) json.push_back(matrix[i / 4][i % 4]);
    return json;
}

} // namespace sr::viewer
