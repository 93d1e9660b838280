#include "gltf/topology.hpp"

#include <cstddef>

namespace sr::gltf {
namespace {

constexpr int points_mode = 0;
constexpr int line_list_mode = 1;
constexpr int line_loop_mode = 2;
constexpr int list_mode = 4;
constexpr int strip_mode = 5;

} // namespace

bool is_surface(int mode) { return mode >= list_mode; }

bool is_points(int mode) { return mode == points_mode; }

std::vector<std::uint32_t> triangles(std::vector<std::uint32_t> indices, int mode) {
    if (mode == list_mode) {
        indices.resize(indices.size() / 3 * 3);
        return indices;
    }
    std::vector<std::uint32_t> result;
    if (indices.size() < 3) return result;
    result.reserve((indices.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        // Specification: strip p_i = {v_i, v_(i+1+i%2), v_(i+2-i%2)}, fan p_i = {v_(i+1), v_(i+2), v_0}.
        const std::size_t odd = i % 2;
        if (mode == strip_mode)
            result.insert(result.end(), {indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
        else
            result.insert(result.end(), {indices[i + 1], indices[i + 2], indices[0]});
    }
    return result;
}

std::vector<std::uint32_t> lines(std::vector<std::uint32_t> indices, int mode) {
    if (mode == line_list_mode) {
        indices.resize(indices.size() / 2 * 2);
        return indices;
    }
    std::vector<std::uint32_t> result;
    if (indices.size() < 2) return result;
    result.reserve(2 * indices.size());
    for (std::size_t i = 0; i + 1 < indices.size(); ++i)
        result.insert(result.end(), {indices[i], indices[i + 1]});
    if (mode == line_loop_mode) result.insert(result.end(), {indices.back(), indices.front()});
    return result;
}

} // namespace sr::gltf
