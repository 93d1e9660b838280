#include "gltf/topology.hpp"

#include <cstddef>

namespace sr::gltf {
namespace {

constexpr int list_mode = 4;
constexpr int strip_mode = 5;

} // namespace

bool is_surface(int mode) { return mode >= list_mode; }

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

} // namespace sr::gltf
