// KHR_draco_mesh_compression, by Google's Draco.
#include "gltf/accessor.hpp"
#include "gltf/compression.hpp"
#include "gltf/draco_header.hpp"
#include "gltf/mesh.hpp"
#include "gltf/text.hpp"
#include "gltf/topology.hpp"

#include <algorithm>
#include <cstring>
#include <draco/compression/decode.h>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

constexpr const char* export_draco_again = "export the file again, or without KHR_draco_mesh_compression";

[[noreturn]] void fail_broken(const Document& document, const PrimitivePlace& place, std::string_view why) {
    document.fail(fmt::format("{} has Draco data that is broken, or cut short ({})", place.pointer(), why),
                  export_draco_again);
}

std::unique_ptr<draco::Mesh> decoded(const Document& document, const PrimitivePlace& place, Bytes stream) {
    // A stream is coded by entropy, so a size has no bound; a triangle in an eighth of a bit is a lie.
    constexpr std::uint64_t densest = 64;
    const std::uint64_t most = densest * std::max<std::uint64_t>(stream.size(), 1024);
    const auto faces = draco_face_count(stream);
    if (!faces) fail_broken(document, place, "it does not begin as Draco 2.2 does");
    if (*faces > most)
        document.fail(
            fmt::format("{} claims to hold {} triangles in {} bytes", place.pointer(), *faces, stream.size()),
            export_draco_again);
    document.values_read->add(3 * *faces); // primitives may share their bytes
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(stream.data()), stream.size());
    draco::Decoder decoder;
    try {
        auto result = decoder.DecodeMeshFromBuffer(&buffer);
        if (!result.ok()) fail_broken(document, place, in_quotes(result.status().error_msg_string()));
        if (result.value()->num_points() > 3 * most) fail_broken(document, place, "too many points");
        return std::move(result).value();
    } catch (const std::bad_alloc&) {
        fail_broken(document, place, "it asks for too much memory");
    } catch (const std::length_error&) {
        fail_broken(document, place, "it asks for too much memory");
    }
}

/// An accessor like `like`, over `bytes` that it alone has.
int add_accessor(Document& document, tinygltf::Accessor like, std::size_t count,
                 std::vector<std::uint8_t> bytes) {
    tinygltf::BufferView view;
    view.byteLength = bytes.size();
    view.buffer = add_buffer(document, std::move(bytes));
    document.model.bufferViews.push_back(view);
    like.bufferView = static_cast<int>(document.model.bufferViews.size()) - 1;
    like.byteOffset = 0;
    like.count = count;
    like.sparse.isSparse = false;
    document.model.accessors.push_back(std::move(like));
    return static_cast<int>(document.model.accessors.size()) - 1;
}

template<class T>
bool convert(const draco::Mesh& mesh, const draco::PointAttribute& from, int components,
             std::vector<std::uint8_t>& to) {
    const std::size_t size = sizeof(T) * static_cast<std::size_t>(components);
    to.resize(size * mesh.num_points());
    std::vector<T> values(static_cast<std::size_t>(components));
    for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
        const draco::AttributeValueIndex value = from.mapped_index(draco::PointIndex(point));
        if (value.value() >= from.size()
            || !from.ConvertValue<T>(value, static_cast<std::int8_t>(components), values.data()))
            return false;
        std::memcpy(&to[size * point], values.data(), size);
    }
    return true;
}

bool convert(const draco::Mesh& mesh, const draco::PointAttribute& from, int component_type, int components,
             std::vector<std::uint8_t>& to) {
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return convert<std::int8_t>(mesh, from, components, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return convert<std::uint8_t>(mesh, from, components, to);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return convert<std::int16_t>(mesh, from, components, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return convert<std::uint16_t>(mesh, from, components, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return convert<std::uint32_t>(mesh, from, components, to);
    default: return convert<float>(mesh, from, components, to);
    }
}

void unpack_attribute(Document& document, const PrimitivePlace& place, const draco::Mesh& mesh,
                      const std::string& name, std::uint32_t id, int& accessor) {
    const tinygltf::Accessor& like = document.model.accessors[static_cast<std::size_t>(accessor)];
    const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(id);
    const int components = components_of(document, accessor);
    if (!from || components > 4)
        document.fail(fmt::format("{} has no {} in its Draco data", place.pointer(), name),
                      export_draco_again);
    if (mesh.num_points() != like.count)
        document.fail(fmt::format("{} announces {} of {}, and its Draco data has {}", place.pointer(),
                                  like.count, name, mesh.num_points()),
                      export_draco_again);
    document.values_read->add(std::uint64_t{mesh.num_points()} * static_cast<std::uint64_t>(components));
    std::vector<std::uint8_t> bytes;
    if (!convert(mesh, *from, like.componentType, components, bytes))
        fail_broken(document, place, name + " cannot be converted");
    accessor = add_accessor(document, like, mesh.num_points(), std::move(bytes));
}

int unpack_indices(Document& document, const draco::Mesh& mesh) {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t face = 0; face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(face)))
            indices.push_back(corner.value());
    std::vector<std::uint8_t> bytes(indices.size() * sizeof(std::uint32_t));
    if (!indices.empty()) std::memcpy(bytes.data(), indices.data(), bytes.size());
    tinygltf::Accessor accessor;
    accessor.sparse = {}; // its constructor leaves some members unset
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.normalized = false;
    return add_accessor(document, std::move(accessor), indices.size(), std::move(bytes));
}

void unpack(Document& document, const PrimitivePlace& place, const tinygltf::Value& packed) {
    const auto primitive = [&]() -> tinygltf::Primitive& {
        return document.model.meshes[static_cast<std::size_t>(place.mesh)]
            .primitives[static_cast<std::size_t>(place.primitive)];
    };
    if (!is_surface(primitive().mode))
        document.fail(fmt::format("{} has Draco data and no triangles", place.pointer()), export_draco_again);
    const Bytes stream = document.view(whole_in(packed, "bufferView", 0), place.pointer());
    const std::unique_ptr<draco::Mesh> mesh = decoded(document, place, stream);
    const tinygltf::Value& ids = packed.Get("attributes");
    for (const std::string& name : ids.Keys()) {
        const auto found = primitive().attributes.find(name);
        if (found == primitive().attributes.end())
            document.fail(fmt::format("{} has {} in its Draco data alone", place.pointer(), in_quotes(name)),
                          export_draco_again);
        unpack_attribute(document, place, *mesh, name, static_cast<std::uint32_t>(whole_in(ids, name, 0)),
                         found->second);
    }
    primitive().indices = unpack_indices(document, *mesh);
    primitive().mode = TINYGLTF_MODE_TRIANGLES;
}

} // namespace

bool reads_draco() { return true; }

void unpack_draco(Document& document) {
    for (int m = 0; m < static_cast<int>(document.model.meshes.size()); ++m) {
        const std::size_t count = document.model.meshes[static_cast<std::size_t>(m)].primitives.size();
        for (int p = 0; p < static_cast<int>(count); ++p) {
            const auto& primitive =
                document.model.meshes[static_cast<std::size_t>(m)].primitives[static_cast<std::size_t>(p)];
            if (const tinygltf::Value* packed = extension(primitive.extensions, "KHR_draco_mesh_compression"))
                unpack(document, {m, p}, *packed);
        }
    }
}

} // namespace sr::gltf
