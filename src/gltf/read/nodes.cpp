#include "gltf/read/nodes.hpp"

#include "core/math.hpp"
#include "gltf/read/accessor.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

namespace sr::gltf {
namespace {

constexpr const char* make_tree = "make the nodes a tree";

std::vector<int> children_of(const Document& document, int node) {
    return document.entry("nodes", node).value("children", std::vector<int>{});
}

void check_forest(const Document& document) {
    std::vector<int> parent(document.count("nodes"), -1);
    for (int node = 0; node < static_cast<int>(parent.size()); ++node)
        for (const int child : children_of(document, node)) {
            int& known = parent[static_cast<std::size_t>(child)];
            if (known >= 0)
                document.fail(
                    fmt::format("/nodes/{} is a child of both /nodes/{} and /nodes/{}", child, known, node),
                    make_tree);
            known = node;
        }
    // With one parent each, the nodes that cannot be reached from a root are on circles.
    std::vector<int> pending;
    std::vector<bool> is_reached(parent.size(), false);
    for (int node = 0; node < static_cast<int>(parent.size()); ++node)
        if (parent[static_cast<std::size_t>(node)] < 0) pending.push_back(node);
    while (!pending.empty()) {
        const int node = pending.back();
        pending.pop_back();
        is_reached[static_cast<std::size_t>(node)] = true;
        const std::vector<int> children = children_of(document, node);
        pending.insert(pending.end(), children.begin(), children.end());
    }
    for (std::size_t node = 0; node < parent.size(); ++node)
        if (!is_reached[node]) document.fail(fmt::format("/nodes/{} is its own ancestor", node), make_tree);
}

glm::dmat4 parent_from_node(const Document& document, int index) {
    const json& node = document.entry("nodes", index);
    if (node.contains("matrix")) return glm::make_mat4(numbers_in(node, "matrix").data());
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(three_in(node, "translation", glm::dvec3(0.0)), 1.0);
    if (const std::vector<double> q = numbers_in(node, "rotation"); !q.empty()) {
        const glm::dquat rotation(q[3], q[0], q[1], q[2]);
        if (!(glm::length(rotation) > 1e-6))
            document.fail(fmt::format("/nodes/{}/rotation is zero", index), "give a unit quaternion");
        matrix *= glm::mat4_cast(glm::normalize(rotation));
    }
    const glm::dvec3 scale = three_in(node, "scale", glm::dvec3(1.0));
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= scale[axis];
    return matrix;
}

/// Returns the visibility that the node states for itself and for those below it.
bool says_visible(const Document& document, int node) {
    const json* visibility = extension(document.entry("nodes", node), "KHR_node_visibility");
    return !visibility || flag_in(*visibility, "visible", true);
}

void check_finite(const Document& document, const NodeTransform& placed) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(static_cast<float>(placed.world_from_node[column][row])))
                document.fail(fmt::format("/nodes/{} stands beyond the range of 32-bit floats", placed.node),
                              "scale the scene down");
}

/// The nodes that are nobody's children.
std::vector<int> all_roots(const Document& document) {
    std::vector<bool> is_child(document.count("nodes"), false);
    for (int node = 0; node < static_cast<int>(is_child.size()); ++node)
        for (const int child : children_of(document, node)) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> result;
    for (std::size_t node = 0; node < is_child.size(); ++node)
        if (!is_child[node]) result.push_back(static_cast<int>(node));
    return result;
}

std::vector<int> roots(const Document& document, std::optional<int> scene) {
    const std::size_t count = document.count("scenes");
    if (scene && (*scene < 0 || *scene >= static_cast<int>(count)))
        document.fail(fmt::format("there is no scene {}, the file has {}", *scene, count),
                      count == 0 ? "name none" : fmt::format("choose one from 0 to {}", count - 1));
    if (count == 0) return all_roots(document);
    const int index = scene.value_or(integer_in(document.root, "scene", 0));
    return document.entry("scenes", index).value("nodes", std::vector<int>{});
}

} // namespace

std::vector<NodeTransform> flatten_nodes(const Document& document, std::optional<int> scene) {
    check_forest(document);
    std::vector<NodeTransform> pending;
    const std::vector<int> first = roots(document, scene);
    for (auto root = first.rbegin(); root != first.rend(); ++root)
        pending.push_back({*root, parent_from_node(document, *root), says_visible(document, *root)});

    std::vector<NodeTransform> placed;
    std::vector<bool> is_placed(document.count("nodes"), false);
    while (!pending.empty()) {
        const NodeTransform here = pending.back();
        pending.pop_back();
        if (is_placed[static_cast<std::size_t>(here.node)])
            document.fail(fmt::format("/nodes/{} is in the scene twice", here.node),
                          "name each root node once");
        is_placed[static_cast<std::size_t>(here.node)] = true;
        check_finite(document, here);
        placed.push_back(here);
        const std::vector<int> children = children_of(document, here.node);
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            pending.push_back({*child, here.world_from_node * parent_from_node(document, *child),
                               here.is_visible && says_visible(document, *child)});
    }
    return placed;
}

std::vector<glm::dmat4> world_from_nodes(const Document& document) {
    std::vector<glm::dmat4> world(document.count("nodes"), glm::dmat4(1.0));
    std::vector<int> pending = all_roots(document);
    for (const int root : pending) world[static_cast<std::size_t>(root)] = parent_from_node(document, root);
    while (!pending.empty()) {
        const int node = pending.back();
        pending.pop_back();
        for (const int child : children_of(document, node)) {
            world[static_cast<std::size_t>(child)] =
                world[static_cast<std::size_t>(node)] * parent_from_node(document, child);
            pending.push_back(child);
        }
    }
    return world;
}

namespace {

class Attributes {
public:
    Attributes(const Document& document, const json& attributes, std::string pointer)
        : document_(document), attributes_(attributes), pointer_(std::move(pointer)) {
        for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"})
            if (attributes.contains(name)) count(count_of(document, attributes.at(name).get<int>()));
    }

    std::size_t count() const { return count_.value_or(0); }

    template<int N>
    std::vector<glm::vec<N, float>> read(const char* name, glm::vec<N, float> fallback) const {
        if (!attributes_.contains(name)) return std::vector<glm::vec<N, float>>(count(), fallback);
        auto all = vectors<N>(document_, attributes_.at(name).get<int>());
        for (const auto& v : all)
            for (int i = 0; i < N; ++i)
                if (!std::isfinite(v[i]))
                    document_.fail(fmt::format("{}/{} is not finite", pointer_, name),
                                   "export the file again");
        return all;
    }

private:
    void count(std::size_t elements) {
        if (count_.value_or(elements) != elements)
            document_.fail(
                fmt::format("{} are {} and {}, which differ in number", pointer_, *count_, elements),
                "give as many of each");
        count_ = elements;
    }

    const Document& document_;
    const json& attributes_;
    std::string pointer_;
    std::optional<std::size_t> count_;
};

} // namespace

std::vector<glm::dmat4> parse_instances(const Document& document, int node) {
    const json* instancing = extension(document.entry("nodes", node), "EXT_mesh_gpu_instancing");
    if (!instancing) return {glm::dmat4(1.0)};
    const std::string pointer = fmt::format("/nodes/{}/extensions/EXT_mesh_gpu_instancing/attributes", node);
    const Attributes attributes(document, instancing->at("attributes"), pointer);
    const auto translations = attributes.read<3>("TRANSLATION", vec3(0.0f));
    const auto rotations = attributes.read<4>("ROTATION", vec4(0.0f, 0.0f, 0.0f, 1.0f));
    const auto scales = attributes.read<3>("SCALE", vec3(1.0f));
    std::vector<glm::dmat4> result;
    for (std::size_t i = 0; i < attributes.count(); ++i) {
        const vec4 q = rotations[i];
        const glm::dquat rotation(q.w, q.x, q.y, q.z);
        if (!(glm::length(rotation) > 0.0))
            document.fail(pointer + "/ROTATION has a zero", "give unit quaternions");
        const glm::dmat4 turned = glm::translate(glm::dmat4(1.0), glm::dvec3(translations[i]))
                                  * glm::mat4_cast(glm::normalize(rotation));
        result.push_back(glm::scale(turned, glm::dvec3(scales[i])));
    }
    return result;
}

} // namespace sr::gltf
