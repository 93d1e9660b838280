#include "gltf/corner_groups.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

namespace sr::gltf {
namespace {

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

} // namespace

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

std::vector<CornerGroup> corner_groups(std::span<const std::uint32_t> welded,
                                       std::span<const TriangleTurn> turns) {
    return Grouping(welded, turns).take();
}

} // namespace sr::gltf
