// Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited" (master's thesis), chapters 3 and 4; where the
// thesis leaves a choice, the behaviour of the author's reference implementation: vertices that are equal in
// position, normal and texture coordinate are one; triangles around a vertex are one group while they are
// connected by edges and turn the same way in the texture; a group's tangent is the mean of its triangles'
// derivatives, projected onto the normal's plane and weighted by the angle at the vertex.
#include "gltf/read/mikktspace.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <unordered_map>

namespace sr::gltf {
namespace {

/// How a triangle lies in the texture. `any`: without area there, so it joins either kind; `degenerate`:
/// without area in space, so it joins none.
enum class TriangleTurn : std::uint8_t { preserving, mirroring, any, degenerate };

/// Corners (positions in the index array) of one vertex that are connected by edges and turn the same way.
struct CornerGroup {
    std::vector<std::uint32_t> corners;
    TriangleTurn turn = TriangleTurn::preserving;
};

constexpr std::uint32_t none = 0xFFFFFFFF;

using Vertex = std::array<std::uint32_t, 8>; // the bits of position, normal, texture coordinate

struct VertexHash {
    std::size_t operator()(const Vertex& vertex) const {
        std::uint64_t hash = 0xCBF29CE484222325ull; // FNV-1a, over words
        for (const std::uint32_t word : vertex) hash = (hash ^ word) * 0x100000001B3ull;
        return hash ^ (hash >> 32);
    }
};

// Adding zero turns -0 into +0, so that equal floats have equal bits.
std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); }

// An undirected edge of the welded mesh, and where it lies.
struct Edge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t corner = 0; // it leads from this corner to the next of the triangle

    auto operator<=>(const Edge&) const = default;
};

std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
std::uint32_t previous_corner(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

// For each corner's edge the corner whose edge is the same one in the opposite direction; `none` at borders.
std::vector<std::uint32_t> opposite_edges(std::span<const std::uint32_t> welded,
                                          std::span<const TriangleTurn> turns) {
    std::vector<Edge> edges;
    edges.reserve(welded.size());
    for (std::uint32_t corner = 0; corner < welded.size(); ++corner) {
        if (turns[corner / 3] == TriangleTurn::degenerate) continue;
        const auto [low, high] = std::minmax({welded[corner], welded[next_corner(corner)]});
        edges.push_back({low, high, corner});
    }
    std::sort(edges.begin(), edges.end());

    std::vector<std::uint32_t> opposite(welded.size(), none);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& edge = edges[i];
        if (opposite[edge.corner] != none) continue;
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const Edge& other = edges[j];
            if (other.low != edge.low || other.high != edge.high) break;
            if (welded[other.corner] == welded[edge.corner] || opposite[other.corner] != none) continue;
            opposite[edge.corner] = other.corner;
            opposite[other.corner] = edge.corner;
            break;
        }
    }
    return opposite;
}

class Grouping {
public:
    Grouping(std::span<const std::uint32_t> welded, std::span<const TriangleTurn> turns)
        : welded_(welded),
          turns_(turns.begin(), turns.end()),
          group_of_(welded.size(), none),
          opposite_(opposite_edges(welded, turns)) {
        for (std::uint32_t corner = 0; corner < welded.size(); ++corner) {
            const TriangleTurn turn = turns_[corner / 3];
            const bool has_own_turn =
                turns[corner / 3] == TriangleTurn::preserving || turns[corner / 3] == TriangleTurn::mirroring;
            if (has_own_turn && group_of_[corner] == none) grow(corner, turn);
        }
    }

    std::vector<CornerGroup> take() { return std::move(groups_); }

private:
    // Depth first, as the reference walks; by a stack of its own, since a fan may have any number of
    // triangles.
    void grow(std::uint32_t seed, TriangleTurn turn) {
        const auto group = static_cast<std::uint32_t>(groups_.size());
        groups_.push_back({{}, turn});
        std::vector<std::uint32_t> pending{seed};
        while (!pending.empty()) {
            const std::uint32_t corner = pending.back();
            pending.pop_back();
            if (group_of_[corner] != none || !joins(corner, turn)) continue;
            group_of_[corner] = group;
            groups_[group].corners.push_back(corner);
            push_across(previous_corner(corner), welded_[corner], pending);
            push_across(corner, welded_[corner], pending);
        }
    }

    bool joins(std::uint32_t corner, TriangleTurn turn) {
        const std::uint32_t first = corner / 3 * 3;
        const bool is_free =
            group_of_[first] == none && group_of_[first + 1] == none && group_of_[first + 2] == none;
        TriangleTurn& own = turns_[corner / 3];
        if (own == TriangleTurn::any && is_free) own = turn;
        return own == turn;
    }

    // The corner of the same vertex in the triangle across an edge.
    void push_across(std::uint32_t edge, std::uint32_t vertex, std::vector<std::uint32_t>& pending) const {
        const std::uint32_t across = opposite_[edge];
        if (across == none) return;
        const std::uint32_t corner = welded_[across] == vertex ? across : next_corner(across);
        pending.push_back(corner);
    }

    std::span<const std::uint32_t> welded_;
    std::vector<TriangleTurn> turns_; // `any` is replaced by the turn that is taken
    std::vector<std::uint32_t> group_of_;
    std::vector<std::uint32_t> opposite_;
    std::vector<CornerGroup> groups_;
};

/// For each corner the first corner whose vertex is equal in position, normal and texture coordinate.
std::vector<std::uint32_t> weld(std::span<const vec3> positions, std::span<const vec3> normals,
                                std::span<const vec2> texcoords, std::span<const std::uint32_t> indices) {
    std::unordered_map<Vertex, std::uint32_t, VertexHash> first_of;
    first_of.reserve(positions.size());
    std::vector<std::uint32_t> first_of_vertex(positions.size(), none);
    std::vector<std::uint32_t> welded(indices.size());
    for (std::uint32_t corner = 0; corner < indices.size(); ++corner) {
        const std::uint32_t v = indices[corner];
        if (first_of_vertex[v] == none) {
            const vec3 p = positions[v];
            const vec3 n = normals[v];
            const vec2 t = texcoords[v];
            const Vertex key{bits(p.x), bits(p.y), bits(p.z), bits(n.x),
                             bits(n.y), bits(n.z), bits(t.x), bits(t.y)};
            first_of_vertex[v] = first_of.try_emplace(key, corner).first->second;
        }
        welded[corner] = first_of_vertex[v];
    }
    return welded;
}

/// The groups of all corners. A triangle that turns `any` way takes the turn of the first group that reaches
/// it.
/// @param welded one entry a corner, as weld() gives it
std::vector<CornerGroup> corner_groups(std::span<const std::uint32_t> welded,
                                       std::span<const TriangleTurn> turns) {
    return Grouping(welded, turns).take();
}

bool is_not_zero(float x) { return std::abs(x) > FLT_MIN; }
bool is_not_zero(vec3 v) { return is_not_zero(v.x) || is_not_zero(v.y) || is_not_zero(v.z); }

vec3 unit_or_zero(vec3 v) { return is_not_zero(v) ? v * (1.0f / std::sqrt(glm::dot(v, v))) : v; }

vec3 on_plane(vec3 v, vec3 normal) { return unit_or_zero(v - glm::dot(normal, v) * normal); }

struct Frame {
    vec3 s{0.0f}; // direction of increasing u, unit
    vec3 t{0.0f}; // direction of increasing v, unit
};

// The derivatives of position by texture coordinate over one triangle, Mikkelsen 2008, Eq. 18 and 19.
struct Derivative {
    Frame frame;
    TriangleTurn turn = TriangleTurn::any;
};

class Tangents {
public:
    Tangents(std::span<const vec3> positions, std::span<const vec3> normals, std::span<const vec2> texcoords,
             std::span<const std::uint32_t> indices)
        : positions_(positions), normals_(normals), texcoords_(texcoords), indices_(indices) {}

    std::vector<vec4> corners() {
        const std::vector<std::uint32_t> welded = weld(positions_, normals_, texcoords_, indices_);
        std::vector<TriangleTurn> turns(indices_.size() / 3);
        derivatives_.resize(turns.size());
        for (std::size_t triangle = 0; triangle < turns.size(); ++triangle) {
            derivatives_[triangle] = derivative(triangle);
            turns[triangle] = derivatives_[triangle].turn;
        }
        std::vector<vec4> tangents(indices_.size(), vec4(0.0f));
        for (const CornerGroup& group : corner_groups(welded, turns)) evaluate(group, tangents);
        fill_degenerate(welded, turns, tangents);
        return tangents;
    }

private:
    vec3 position(std::size_t corner) const { return positions_[indices_[corner]]; }
    vec2 texcoord(std::size_t corner) const { return texcoords_[indices_[corner]]; }

    Derivative derivative(std::size_t triangle) const {
        const std::size_t a = triangle * 3;
        Derivative result;
        if (position(a) == position(a + 1) || position(a) == position(a + 2)
            || position(a + 1) == position(a + 2)) {
            result.turn = TriangleTurn::degenerate;
            return result;
        }
        const vec3 d1 = position(a + 1) - position(a);
        const vec3 d2 = position(a + 2) - position(a);
        const vec2 t1 = texcoord(a + 1) - texcoord(a);
        const vec2 t2 = texcoord(a + 2) - texcoord(a);
        const float signed_area = t1.x * t2.y - t1.y * t2.x; // twice the texture area
        if (!is_not_zero(signed_area)) return result;

        const float sign = signed_area > 0.0f ? 1.0f : -1.0f;
        const vec3 s = t2.y * d1 - t1.y * d2;
        const vec3 t = -t2.x * d1 + t1.x * d2;
        const float s_length = glm::length(s);
        const float t_length = glm::length(t);
        if (is_not_zero(s_length)) result.frame.s = (sign / s_length) * s;
        if (is_not_zero(t_length)) result.frame.t = (sign / t_length) * t;
        if (is_not_zero(s_length / std::abs(signed_area)) && is_not_zero(t_length / std::abs(signed_area)))
            result.turn = sign > 0.0f ? TriangleTurn::preserving : TriangleTurn::mirroring;
        return result;
    }

    // The reference lets two triangles of a group share a tangent unless theirs are exactly opposite (its
    // default threshold of 180 degrees). Only folded meshes have such triangles.
    void evaluate(const CornerGroup& group, std::vector<vec4>& tangents) {
        const vec3 n = normals_[indices_[group.corners.front()]];
        members_.clear();
        for (const std::uint32_t corner : group.corners) members_.push_back(member(corner, n));
        const float w = group.turn == TriangleTurn::preserving ? -1.0f : 1.0f; // against glTF's v
        const vec4 whole(mean([](const Member&) { return true; }), w);
        constexpr std::size_t max_compared = 256; // pairs; beyond it a fold is not worth the square
        const bool may_fold = members_.size() <= max_compared;
        for (const Member& one : members_) {
            const auto shares = [&](const Member& other) { return can_share(one, other); };
            const bool is_folded = may_fold && !std::all_of(members_.begin(), members_.end(), shares);
            tangents[one.corner] = is_folded ? vec4(mean(shares), w) : whole;
        }
    }

    // A corner of the group that is being evaluated.
    struct Member {
        std::uint32_t corner = 0;
        bool has_frame = false;
        Frame frame; // in the plane of the group's normal
        float angle = 0.0f;
    };

    Member member(std::uint32_t corner, vec3 n) const {
        const Derivative& derivative = derivatives_[corner / 3];
        if (derivative.turn == TriangleTurn::any) return {corner, false, {}, 0.0f};
        return {corner,
                true,
                {on_plane(derivative.frame.s, n), on_plane(derivative.frame.t, n)},
                angle(corner, n)};
    }

    static bool can_share(const Member& a, const Member& b) {
        if (a.corner == b.corner || !a.has_frame || !b.has_frame) return true;
        return glm::dot(a.frame.s, b.frame.s) > -1.0f && glm::dot(a.frame.t, b.frame.t) > -1.0f;
    }

    template<typename Predicate>
    vec3 mean(const Predicate& is_included) const {
        vec3 sum(0.0f);
        for (const Member& member : members_)
            if (member.has_frame && is_included(member)) sum += member.angle * member.frame.s;
        const vec3 tangent = unit_or_zero(sum);
        return is_not_zero(tangent) ? tangent : vec3(1.0f, 0.0f, 0.0f);
    }

    // The angle of the triangle at the corner, seen along the normal [rad].
    float angle(std::uint32_t corner, vec3 n) const {
        const std::size_t first = corner / 3 * 3;
        const std::size_t k = corner - first;
        const vec3 here = position(corner);
        const vec3 to_last = on_plane(position(first + (k + 2) % 3) - here, n);
        const vec3 to_next = on_plane(position(first + (k + 1) % 3) - here, n);
        return std::acos(std::clamp(glm::dot(to_last, to_next), -1.0f, 1.0f));
    }

    // A triangle without area takes what a good triangle has at the same vertex.
    static void fill_degenerate(std::span<const std::uint32_t> welded, std::span<const TriangleTurn> turns,
                                std::vector<vec4>& tangents) {
        std::vector<std::uint32_t> good_corner(welded.size(), std::uint32_t(-1));
        for (std::uint32_t c = 0; c < welded.size(); ++c)
            if (turns[c / 3] != TriangleTurn::degenerate && good_corner[welded[c]] == std::uint32_t(-1))
                good_corner[welded[c]] = c;
        for (std::size_t c = 0; c < tangents.size(); ++c) {
            const std::uint32_t good = good_corner[welded[c]];
            if (turns[c / 3] == TriangleTurn::degenerate && good != std::uint32_t(-1))
                tangents[c] = tangents[good];
            if (tangents[c] == vec4(0.0f)) tangents[c] = vec4(1.0f, 0.0f, 0.0f, 1.0f);
        }
    }

    std::span<const vec3> positions_;
    std::span<const vec3> normals_;
    std::span<const vec2> texcoords_;
    std::span<const std::uint32_t> indices_;
    std::vector<Derivative> derivatives_;
    std::vector<Member> members_; // of the group that is being evaluated
};

} // namespace

std::vector<vec4> mikktspace(std::span<const vec3> positions, std::span<const vec3> normals,
                             std::span<const vec2> texcoords, std::span<const std::uint32_t> indices) {
    return Tangents(positions, normals, texcoords, indices).corners();
}

} // namespace sr::gltf
