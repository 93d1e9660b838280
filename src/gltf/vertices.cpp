#include "gltf/vertices.hpp"

#include <limits>
#include <numeric>

namespace sr::gltf {
namespace {

template<typename T>
void gather(std::vector<T>& values, std::span<const std::uint32_t> sources) {
    if (values.empty()) return;
    std::vector<T> gathered;
    gathered.reserve(sources.size());
    for (const std::uint32_t source : sources) gathered.push_back(values[source]);
    values = std::move(gathered);
}

} // namespace

void gather(SourcedMesh& mesh, std::span<const std::uint32_t> sources) {
    gather(mesh.positions, sources);
    gather(mesh.normals, sources);
    gather(mesh.tangents, sources);
    for (auto& texcoords : mesh.texcoords) gather(texcoords, sources);
    gather(mesh.colors, sources);
    gather(mesh.sources, sources);
}

void unweld(SourcedMesh& mesh) {
    gather(mesh, mesh.indices);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
}

void drop_unused(SourcedMesh& mesh) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> renumbered(mesh.positions.size(), unused);
    std::vector<std::uint32_t> sources;
    for (const std::uint32_t index : mesh.indices) {
        if (renumbered[index] != unused) continue;
        renumbered[index] = static_cast<std::uint32_t>(sources.size());
        sources.push_back(index);
    }
    if (sources.size() == mesh.positions.size()) return;
    for (std::uint32_t& index : mesh.indices) index = renumbered[index];
    gather(mesh, sources);
}

} // namespace sr::gltf
