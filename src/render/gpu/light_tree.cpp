#include "render/gpu/light_tree.hpp"

#include "core/math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sr::render {
namespace {

/// Powers are relative to their sum. Smaller ones count as this much, so that no light is lost to rounding.
constexpr double min_power = 1e-30;
/// Powers that a float cannot hold count as this much.
constexpr double max_power = 1e36;

/// Cosines of the shader and the directions of a cone are off by less.
constexpr float cone_margin = 2e-3f;

/// Sets the cone of a mesh's normals. @return the solid angle over which it spreads its flux, roughly
double spread_normals(const scene::MeshLight& light, LightNode& node) {
    if (light.is_two_sided) {
        node.theta_o = pi;
        return 4.0 * scene::pi64;
    }
    glm::dvec3 sum(0.0);
    double total = 0.0;
    const auto normal_of = [](const scene::MeshLight::Triangle& t) {
        return glm::cross(glm::dvec3(t.corners[1] - t.corners[0]), glm::dvec3(t.corners[2] - t.corners[0]));
    };
    for (const auto& triangle : light.triangles) {
        sum += normal_of(triangle);
        total += glm::length(normal_of(triangle));
    }
    const double length = glm::length(sum);
    if (!(length > 1e-6 * total)) {
        node.theta_o = pi;
        return 4.0 * scene::pi64;
    }
    const glm::dvec3 axis = sum / length;
    double cosine = 1.0;
    for (const auto& triangle : light.triangles) {
        const glm::dvec3 n = normal_of(triangle);
        if (const double l = glm::length(n); l > 0.0) cosine = std::min(cosine, glm::dot(axis, n) / l);
    }
    node.axis = vec3(axis);
    node.theta_o = static_cast<float>(std::acos(std::clamp(cosine, -1.0, 1.0)));
    return scene::pi64 / std::max(length / total, 0.25); // flat: π; closed and convex: 4π
}

/// Sets the cone of a light that is somewhere. @return the solid angle over which it spreads its flux [sr]
template<class L>
double spread(const L& light, LightNode& node) {
    node.theta_e = 0.5f * pi;
    if constexpr (std::is_same_v<L, scene::SpotLight>) {
        node.axis = light.direction;
        node.theta_o = light.inner_angle;
        node.theta_e = light.outer_angle - light.inner_angle;
        return light.solid_angle();
    } else if constexpr (std::is_same_v<L, scene::MeshLight>) {
        return spread_normals(light, node);
    } else if constexpr (requires { light.normal(); }) {
        node.axis = light.normal();
        node.is_two_sided = light.is_two_sided;
        return light.is_two_sided ? 2.0 * scene::pi64 : scene::pi64;
    } else {
        node.theta_o = pi;
        return 4.0 * scene::pi64;
    }
}

/// Returns the irradiance on a surface that faces a light at infinity, and sets the cone of its directions.
double face(const scene::DirectionalLight& light, LightNode& node) {
    node.axis = -light.direction;
    node.theta_o = light.angular_radius;
    node.box.extend(node.axis);
    node.is_met = light.angular_radius > 0.0f;
    return luminance(glm::dvec3(light.E));
}

double face(const scene::EnvironmentLight& light, LightNode& node) {
    node.theta_o = pi;
    node.box = scene::box_around(vec3(0.0f), vec3(1.0f));
    node.is_met = true;
    const glm::dvec3 mean = light.map ? glm::dvec3(light.map->mean()) : glm::dvec3(1.0);
    return scene::pi64 * luminance(glm::dvec3(light.L) * mean);
}

/// A leaf; its power is still in candela or lux. @return that power
double describe(const scene::Light& light, const std::vector<scene::LightProfile>& profiles,
                LightNode& node) {
    return std::visit(
        [&]<class L>(const L& l) {
            node.is_far = !scene::center_of(light).has_value();
            if constexpr (requires { face(l, node); }) {
                return face(l, node);
            } else {
                node.box = scene::bounds_of(light, 0.0f);
                node.has_mesh = std::is_same_v<L, scene::MeshLight>;
                node.is_met = scene::has_extent(light) && !node.has_mesh;
                const double solid_angle = spread(l, node);
                return luminance(glm::dvec3(*scene::flux_of(light, profiles))) / std::max(solid_angle, 1e-6);
            }
        },
        light);
}

/// Leaves of all lights that send out anything.
std::vector<LightNode> leaves_of(const scene::Scene& scene, std::span<const scene::Light> lights) {
    std::vector<LightNode> leaves;
    std::vector<double> powers;
    double total = 0.0;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        LightNode leaf;
        leaf.light = static_cast<int>(k);
        const double power = describe(lights[k], scene.profiles, leaf);
        if (power == 0.0 || leaf.box.is_empty()) continue;
        leaves.push_back(leaf);
        powers.push_back(power > 0.0 && power < max_power ? power : max_power);
        total += powers.back();
    }
    for (std::size_t i = 0; i < leaves.size(); ++i)
        leaves[i].power = static_cast<float>(std::max(powers[i] / total, min_power));
    return leaves;
}

/// Widens the cone of `a` to hold that of `b`.
void hold_cone(LightNode& a, const LightNode& b) {
    if (a.axis == b.axis) {
        a.theta_o = std::max(a.theta_o, b.theta_o);
        return;
    }
    const float between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0f, 1.0f));
    if (std::min(between + b.theta_o, pi) <= a.theta_o) return;
    if (std::min(between + a.theta_o, pi) <= b.theta_o) {
        a.axis = b.axis;
        a.theta_o = b.theta_o;
        return;
    }
    const float theta = 0.5f * (a.theta_o + between + b.theta_o);
    const float turn = theta - a.theta_o;
    const float sine = std::sin(between);
    a.theta_o = std::min(theta, pi);
    if (theta >= pi || sine < 1e-4f) {
        a.theta_o = pi;
        return;
    }
    a.axis = glm::normalize((std::sin(between - turn) * a.axis + std::sin(turn) * b.axis) / sine);
}

/// Extends the bounds of `a` by those of `b`; an empty `a` becomes those of `b`.
void hold(LightNode& a, const LightNode& b) {
    if (a.power == 0.0f) {
        a.axis = b.axis;
        a.theta_o = b.theta_o;
        a.is_far = b.is_far;
    } else {
        hold_cone(a, b);
    }
    a.box.extend(b.box.min);
    a.box.extend(b.box.max);
    a.power += b.power;
    a.theta_e = std::max(a.theta_e, b.theta_e);
    a.is_two_sided |= b.is_two_sided;
    a.is_met |= b.is_met;
    a.has_mesh |= b.has_mesh;
}

/// The solid angle measure of a cone of normals whose emitters reach θ_e further: M_Ω of Conty Estevez &
/// Kulla 2018, Eq. 1.
float orientation_measure(const LightNode& node) {
    const float o = node.theta_o, w = std::min(o + node.theta_e, pi);
    return 2.0f * pi * (1.0f - std::cos(o))
           + 0.5f * pi
                 * (2.0f * w * std::sin(o) - std::cos(o - 2.0f * w) - 2.0f * o * std::sin(o) + std::cos(o));
}

/// The surface area orientation heuristic, Eq. 2 there, but with the square of the diagonal in place of the
/// area: points on a line have no area.
float cost_of(const LightNode& node) {
    if (node.power == 0.0f) return 0.0f;
    const vec3 size = node.box.max - node.box.min;
    return node.power * orientation_measure(node) * glm::dot(size, size);
}

/// True if all emitters of the node face the same way and send nothing behind their plane.
bool faces_one_way(const LightNode& node) {
    return !node.is_far && !node.is_two_sided && node.theta_o == 0.0f && node.theta_e <= 0.5f * pi;
}

constexpr int bucket_count = 12;

struct Split {
    scene::Bounds centers; // of the leaves
    int axis = -1;         // negative: none
    int bucket = 0;        // the last of the first child
};

int bucket_of(const LightNode& leaf, const scene::Bounds& centers, int axis) {
    const float place =
        (leaf.box.center()[axis] - centers.min[axis]) / (centers.max[axis] - centers.min[axis]);
    return std::clamp(static_cast<int>(place * bucket_count), 0, bucket_count - 1);
}

/// Returns the cheapest split between buckets along any axis.
Split cheapest_split(std::span<const LightNode> leaves) {
    Split best;
    scene::Bounds& centers = best.centers;
    scene::Bounds box;
    for (const LightNode& leaf : leaves) {
        centers.extend(leaf.box.center());
        box.extend(leaf.box.min);
        box.extend(leaf.box.max);
    }
    const vec3 size = box.max - box.min;
    const float largest = std::max(size.x, std::max(size.y, size.z));
    float least = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(centers.max[axis] > centers.min[axis])) continue;
        std::array<LightNode, bucket_count> buckets;
        for (const LightNode& leaf : leaves)
            hold(buckets[static_cast<std::size_t>(bucket_of(leaf, centers, axis))], leaf);
        std::array<float, bucket_count> cost{}; // of a split after this bucket
        LightNode before, after;
        for (std::size_t i = 0; i + 1 < bucket_count; ++i) {
            if (buckets[i].power > 0.0f) hold(before, buckets[i]);
            cost[i] += cost_of(before);
            const std::size_t j = bucket_count - 1 - i;
            if (buckets[j].power > 0.0f) hold(after, buckets[j]);
            cost[j - 1] += cost_of(after);
        }
        for (std::size_t i = 0; i + 1 < bucket_count; ++i) {
            const float regularised = cost[i] * largest / size[axis]; // K_r: thin boxes are cut across
            if (regularised < least) {
                least = regularised;
                best.axis = axis;
                best.bucket = static_cast<int>(i);
            }
        }
    }
    return best;
}

/// Orders the leaves so that those of the first child come first. @return how many these are
std::size_t divide(std::span<LightNode> leaves, int depth) {
    const auto first_far =
        std::partition(leaves.begin(), leaves.end(), [](const LightNode& leaf) { return !leaf.is_far; });
    if (first_far != leaves.begin() && first_far != leaves.end())
        return static_cast<std::size_t>(first_far - leaves.begin());
    constexpr int halved_depth = max_light_tree_depth / 2; // from there on halves end the tree in time
    const Split split = depth < halved_depth ? cheapest_split(leaves) : Split();
    if (split.axis >= 0) {
        const auto middle = std::stable_partition(leaves.begin(), leaves.end(), [&](const LightNode& leaf) {
            return bucket_of(leaf, split.centers, split.axis) <= split.bucket;
        });
        if (middle != leaves.begin() && middle != leaves.end())
            return static_cast<std::size_t>(middle - leaves.begin());
    }
    return leaves.size() / 2;
}

/// Appends the subtree of the leaves. @return its root
int append(std::span<LightNode> leaves, int parent, int depth, std::vector<LightNode>& nodes) {
    const auto place = nodes.size();
    nodes.push_back(leaves.size() == 1 ? leaves.front() : LightNode());
    nodes[place].parent = parent;
    if (leaves.size() > 1) {
        const std::size_t count = divide(leaves, depth);
        const int first = append(leaves.first(count), static_cast<int>(place), depth + 1, nodes);
        const int second = append(leaves.subspan(count), static_cast<int>(place), depth + 1, nodes);
        for (const int child : {first, second}) hold(nodes[place], nodes[static_cast<std::size_t>(child)]);
        nodes[place].is_far = nodes[static_cast<std::size_t>(second)].is_far; // which any at infinity are
        nodes[place].second_child = second;
    }
    nodes[place].end = static_cast<int>(nodes.size());
    return static_cast<int>(place);
}

} // namespace

std::vector<LightNode> build_light_tree(const scene::Scene& scene, std::span<const scene::Light> lights) {
    std::vector<LightNode> leaves = leaves_of(scene, lights);
    std::vector<LightNode> nodes;
    if (leaves.empty()) return nodes;
    nodes.reserve(2 * leaves.size());
    append(leaves, -1, 0, nodes);
    return nodes;
}

std::vector<vec4> pack_light_tree(std::span<const LightNode> nodes) {
    std::vector<vec4> texels;
    texels.reserve(nodes.size() * texels_per_light_node);
    for (const LightNode& node : nodes) {
        scene::Bounds box = node.box;
        if (!node.is_far && box.radius() > 0.0f) { // what rounding may take from a ray that meets an edge
            const vec3 far = glm::max(glm::abs(box.min), glm::abs(box.max));
            const vec3 margin(2e-4f * box.radius() + 4e-6f * std::max(far.x, std::max(far.y, far.z)));
            box = {box.min - margin, box.max + margin};
        }
        const int form = (node.is_two_sided ? 1 : 0) + (node.is_far ? 2 : 0) + (node.is_met ? 4 : 0)
                         + (node.has_mesh ? 8 : 0) + (faces_one_way(node) ? 16 : 0);
        const int link = node.is_leaf() ? -1 - node.light : node.second_child;
        const vec3 half_size = 0.5f * (box.max - box.min);
        texels.emplace_back(box.center(), node.power);
        texels.emplace_back(half_size, static_cast<float>(link));
        texels.emplace_back(node.axis, static_cast<float>(form));
        texels.emplace_back(std::cos(node.theta_o), std::sin(node.theta_o),
                            std::cos(std::min(node.theta_e, pi)) - cone_margin, glm::length(half_size));
        texels.emplace_back(static_cast<float>(node.end), static_cast<float>(node.parent), 0.0f, 0.0f);
    }
    return texels;
}

} // namespace sr::render
