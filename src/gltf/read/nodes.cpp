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

glm::dmat4 parent_from_node(const Document& document, const json& node, int index) {
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
bool says_visible(const json& node) {
    const json* visibility = extension(node, "KHR_node_visibility");
    return !visibility || flag_in(*visibility, "visible", true);
}

void check_finite(const Document& document, const NodeTransform& placed) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(static_cast<float>(placed.world_from_node[column][row])))
                document.fail(fmt::format("/nodes/{} stands beyond the range of 32-bit floats", placed.node),
                              "scale the scene down");
}

} // namespace

NodeTree::NodeTree(const Document& document) : document_(document), nodes_(document.count("nodes")) {
    link();
    for (int node = 0; node < static_cast<int>(nodes_.size()); ++node)
        if (at(node).parent < 0) orphans_.push_back(node);
    require_no_circle();
}

void NodeTree::link() {
    for (int node = 0; node < static_cast<int>(nodes_.size()); ++node) {
        const json& source = document_.entry("nodes", node);
        Node& here = nodes_[static_cast<std::size_t>(node)];
        here.source = &source;
        here.children = source.value("children", std::vector<int>{});
        for (const int child : here.children) {
            int& known = nodes_[static_cast<std::size_t>(child)].parent;
            if (known >= 0)
                document_.fail(
                    fmt::format("/nodes/{} is a child of both /nodes/{} and /nodes/{}", child, known, node),
                    make_tree);
            known = node;
        }
    }
}

/// With one parent each, the nodes that cannot be reached from a root are on circles.
void NodeTree::require_no_circle() const {
    std::vector<int> pending = orphans_;
    std::vector<bool> is_reached(nodes_.size(), false);
    while (!pending.empty()) {
        const int node = pending.back();
        pending.pop_back();
        is_reached[static_cast<std::size_t>(node)] = true;
        pending.insert(pending.end(), at(node).children.begin(), at(node).children.end());
    }
    const auto lost = std::ranges::find(is_reached, false);
    if (lost != is_reached.end())
        document_.fail(fmt::format("/nodes/{} is its own ancestor", lost - is_reached.begin()), make_tree);
}

std::vector<int> NodeTree::roots(std::optional<int> scene) const {
    const std::size_t count = document_.count("scenes");
    if (scene && (*scene < 0 || *scene >= static_cast<int>(count)))
        document_.fail(fmt::format("there is no scene {}, the file has {}", *scene, count),
                       count == 0 ? "name none" : fmt::format("choose one from 0 to {}", count - 1));
    if (count == 0) return orphans_;
    const int index = scene.value_or(integer_in(document_.root, "scene", 0));
    return document_.entry("scenes", index).value("nodes", std::vector<int>{});
}

NodeTransform NodeTree::below(const NodeTransform& parent, int node) const {
    const json& source = *at(node).source;
    return {node, &source, parent.world_from_node * parent_from_node(document_, source, node),
            parent.is_visible && says_visible(source)};
}

std::vector<NodeTransform> NodeTree::flatten(std::optional<int> scene) const {
    std::vector<NodeTransform> pending, placed;
    const std::vector<int> first = roots(scene);
    for (auto root = first.rbegin(); root != first.rend(); ++root) pending.push_back(below({}, *root));
    std::vector<bool> is_placed(nodes_.size(), false);
    while (!pending.empty()) {
        const NodeTransform here = pending.back();
        pending.pop_back();
        if (is_placed[static_cast<std::size_t>(here.node)])
            document_.fail(fmt::format("/nodes/{} is in the scene twice", here.node),
                           "name each root node once");
        is_placed[static_cast<std::size_t>(here.node)] = true;
        check_finite(document_, here);
        placed.push_back(here);
        const std::vector<int>& children = at(here.node).children;
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            pending.push_back(below(here, *child));
    }
    return placed;
}

std::vector<glm::dmat4> NodeTree::world_from_nodes() const {
    std::vector<glm::dmat4> world(nodes_.size(), glm::dmat4(1.0));
    std::vector<NodeTransform> pending;
    for (const int root : orphans_) pending.push_back(below({}, root));
    while (!pending.empty()) {
        const NodeTransform here = pending.back();
        pending.pop_back();
        world[static_cast<std::size_t>(here.node)] = here.world_from_node;
        for (const int child : at(here.node).children) pending.push_back(below(here, child));
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
