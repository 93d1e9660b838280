// KHR_draco_mesh_compression, by Google's Draco.
#include "gltf/read/compression.hpp"

#ifdef STERADIAN_HAS_DRACO
#include "gltf/read/accessor.hpp"
#include "gltf/read/mesh.hpp"
#include "gltf/tinygltf.hpp"
#include "gltf/warnings.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <draco/compression/decode.h>
#include <fmt/format.h>
#include <optional>

namespace sr::gltf {
namespace {

/// Reads from the front; once there is nothing left, everything is absent.
class Reader {
public:
    explicit Reader(Bytes bytes) : bytes_(bytes) {}

    std::optional<std::uint8_t> byte() {
        if (bytes_.empty()) return std::nullopt;
        const std::uint8_t first = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return first;
    }

    bool skip(std::size_t count) {
        if (count > bytes_.size()) return false;
        bytes_ = bytes_.subspan(count);
        return true;
    }

    /// Seven bits a byte, the lowest first.
    std::optional<std::uint64_t> varint() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            const auto next = byte();
            if (!next) return std::nullopt;
            value |= std::uint64_t{*next & 0x7Fu} << shift;
            if ((*next & 0x80u) == 0) return value;
        }
        return std::nullopt;
    }

private:
    Bytes bytes_;
};

constexpr int max_metadata_depth = 32;

/// Names and values, and metadata within.
bool skip_metadata(Reader& reader, int depth) {
    if (depth > max_metadata_depth) return false;
    const auto skip_name = [&] {
        const auto length = reader.byte();
        return length && reader.skip(*length);
    };
    const auto entries = reader.varint();
    for (std::uint64_t i = 0; entries && i < *entries; ++i) {
        if (!skip_name()) return false;
        const auto length = reader.varint();
        if (!length || !reader.skip(*length)) return false;
    }
    const auto inner = entries ? reader.varint() : std::nullopt;
    for (std::uint64_t i = 0; inner && i < *inner; ++i)
        if (!skip_name() || !skip_metadata(reader, depth + 1)) return false;
    return inner.has_value();
}

bool skip_all_metadata(Reader& reader) {
    const auto attributes = reader.varint();
    for (std::uint64_t i = 0; attributes && i < *attributes; ++i)
        if (!reader.varint() || !skip_metadata(reader, 0)) return false;
    return attributes && skip_metadata(reader, 0);
}

/// Reads the number of triangles from a stream of the Draco bitstream 2.2 (specification, section 3), before
/// the library allocates what it asks for. Absent if it is none, is older, or ends too soon.
std::optional<std::uint64_t> draco_face_count(Bytes stream) {
    constexpr std::array<std::uint8_t, 8> begin{'D', 'R', 'A', 'C', 'O', 2, 2, 1}; // version 2.2, a mesh
    constexpr std::uint8_t edgebreaker = 1;
    if (stream.size() < begin.size() || !std::ranges::equal(begin, stream.first(begin.size())))
        return std::nullopt;
    Reader reader(stream.subspan(begin.size()));
    const auto method = reader.byte();
    const bool is_edgebreaker = method == edgebreaker;
    reader.skip(1);
    const auto flags = reader.byte(); // the higher half
    if (!flags || ((*flags & 0x80u) != 0 && !skip_all_metadata(reader))) return std::nullopt;
    if (is_edgebreaker && (!reader.skip(1) || !reader.varint()))
        return std::nullopt; // how traversed, vertices
    return reader.varint();
}

constexpr const char* export_draco_again = "export the file again, or without KHR_draco_mesh_compression";

[[noreturn]] void fail_broken(const Document& document, const PrimitivePlace& place, std::string_view why) {
    document.fail(fmt::format("{} has Draco data that is broken, or cut short ({})", place.pointer(), why),
                  export_draco_again);
}

std::unique_ptr<draco::Mesh> decoded(const Document& document, const PrimitivePlace& place, Bytes stream) {
    // A stream is coded by entropy, so a size has no bound; a triangle in an eighth of a bit is a lie.
    constexpr std::uint64_t max_density = 64;
    const std::uint64_t max_faces = max_density * std::max<std::uint64_t>(stream.size(), 1024);
    const auto faces = draco_face_count(stream);
    if (!faces) fail_broken(document, place, "it does not begin as Draco 2.2 does");
    if (*faces > max_faces)
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
        if (result.value()->num_points() > 3 * max_faces) fail_broken(document, place, "too many points");
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
    view.buffer = document.add_buffer(std::move(bytes));
    document.model->bufferViews.push_back(view);
    like.bufferView = static_cast<int>(document.model->bufferViews.size()) - 1;
    like.byteOffset = 0;
    like.count = count;
    like.sparse.isSparse = false;
    document.model->accessors.push_back(std::move(like));
    return static_cast<int>(document.model->accessors.size()) - 1;
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
    const tinygltf::Accessor& like = document.model->accessors[static_cast<std::size_t>(accessor)];
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

void unpack(Document& document, const PrimitivePlace& place, const json& packed) {
    const auto primitive = [&]() -> tinygltf::Primitive& {
        return document.model->meshes[static_cast<std::size_t>(place.mesh)]
            .primitives[static_cast<std::size_t>(place.primitive)];
    };
    if (!is_surface(primitive().mode))
        document.fail(fmt::format("{} has Draco data and no triangles", place.pointer()), export_draco_again);
    const Bytes stream = document.view(integer_in(packed, "bufferView", 0), place.pointer());
    const std::unique_ptr<draco::Mesh> mesh = decoded(document, place, stream);
    const json& ids = packed.at("attributes");
    for (const auto& [name, id] : ids.items()) {
        const auto found = primitive().attributes.find(name);
        if (found == primitive().attributes.end())
            document.fail(fmt::format("{} has {} in its Draco data alone", place.pointer(), in_quotes(name)),
                          export_draco_again);
        unpack_attribute(document, place, *mesh, name, id.get<std::uint32_t>(), found->second);
    }
    primitive().indices = unpack_indices(document, *mesh);
    primitive().mode = TINYGLTF_MODE_TRIANGLES;
}

} // namespace

bool reads_draco() { return true; }

void unpack_draco(Document& document) {
    for (int m = 0; m < static_cast<int>(document.model->meshes.size()); ++m) {
        const std::size_t count = document.model->meshes[static_cast<std::size_t>(m)].primitives.size();
        for (int p = 0; p < static_cast<int>(count); ++p) {
            const json& primitive =
                document.entry("meshes", m).at("primitives").at(static_cast<std::size_t>(p));
            if (const json* packed = extension(primitive, "KHR_draco_mesh_compression"))
                unpack(document, {m, p}, *packed);
        }
    }
}

} // namespace sr::gltf
#else

namespace sr::gltf {

bool reads_draco() { return false; }
void unpack_draco(Document&) {}

} // namespace sr::gltf
#endif
