// EXT_meshopt_compression and KHR_meshopt_compression, by Kapoulkine's meshoptimizer. Their bitstreams are
// the same, but for what KHR adds: version 1 of the attribute codec, and the filter COLOR.
#include "gltf/read/compression.hpp"

#include "gltf/tinygltf.hpp"

#ifdef STERADIAN_HAS_MESHOPT
#include <fmt/format.h>
#include <meshoptimizer.h>

namespace sr::gltf {
namespace {

constexpr const char* export_meshopt_again = "export the file again, or without meshopt compression";
constexpr const char* export_for_ext = "export it with EXT_meshopt_compression, or without compression";

/// The extension's object of a buffer view.
struct Packed {
    int buffer = 0;
    std::size_t offset = 0;
    std::size_t length = 0;
    std::size_t stride = 0;
    std::size_t count = 0;
    std::string mode;
    std::string filter;
};

Packed parse_packed(const json& object) {
    const auto whole = [&](const char* key) { return static_cast<std::size_t>(integer_in(object, key, 0)); };
    Packed packed{integer_in(object, "buffer", 0),
                  whole("byteOffset"),
                  whole("byteLength"),
                  whole("byteStride"),
                  whole("count"),
                  object.at("mode").get<std::string>(),
                  "NONE"};
    if (object.contains("filter")) packed.filter = object.at("filter").get<std::string>();
    return packed;
}

/// The extension's "JSON schema updates": which strides and counts each mode and filter allows. The library
/// relies on them.
bool is_allowed(const Packed& p) {
    const bool is_index = p.stride == 2 || p.stride == 4;
    if (p.mode == "TRIANGLES") return is_index && p.count % 3 == 0 && p.filter == "NONE";
    if (p.mode == "INDICES") return is_index && p.filter == "NONE";
    if (p.stride == 0 || p.stride > 256 || p.stride % 4 != 0) return false;
    if (p.filter == "OCTAHEDRAL") return p.stride == 4 || p.stride == 8;
    return p.filter != "QUATERNION" || p.stride == 8;
}

void decode(const Document& document, const Packed& p, Bytes from, std::vector<std::uint8_t>& to,
            const std::string& pointer) {
    int failure = 0;
    if (p.mode == "TRIANGLES")
        failure = meshopt_decodeIndexBuffer(to.data(), p.count, p.stride, from.data(), from.size());
    else if (p.mode == "INDICES")
        failure = meshopt_decodeIndexSequence(to.data(), p.count, p.stride, from.data(), from.size());
    else
        failure = meshopt_decodeVertexBuffer(to.data(), p.count, p.stride, from.data(), from.size());
    constexpr std::uint8_t newer_attributes = 0xa1; // KHR_meshopt_compression, "Bitstream"
    if (failure != 0 && p.mode == "ATTRIBUTES" && from[0] == newer_attributes)
        document.fail(fmt::format("{} has version 1 of the codec, which meshoptimizer {}.{} does not read",
                                  pointer, MESHOPTIMIZER_VERSION / 1000, MESHOPTIMIZER_VERSION / 10 % 100),
                      export_for_ext);
    if (failure != 0)
        document.fail(fmt::format("{} has data that is broken, or cut short", pointer), export_meshopt_again);
    if (p.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(to.data(), p.count, p.stride);
    if (p.filter == "QUATERNION") meshopt_decodeFilterQuat(to.data(), p.count, p.stride);
    if (p.filter == "EXPONENTIAL") meshopt_decodeFilterExp(to.data(), p.count, p.stride);
}

/// @return the bytes of the view
std::vector<std::uint8_t> unpack(const Document& document, const Packed& p, const std::string& pointer) {
    const auto& [buffer, fault] = document.buffers[static_cast<std::size_t>(p.buffer)];
    if (fault) throw *fault;
    if (p.filter == "COLOR")
        document.fail(pointer + " has the filter COLOR, which is not read", export_for_ext);
    if (!buffer || p.offset > buffer->size() || p.length > buffer->size() - p.offset)
        document.fail(fmt::format("{} ends at byte {} of /buffers/{}, which has {}", pointer,
                                  p.offset + p.length, p.buffer, buffer ? buffer->size() : 0),
                      export_meshopt_again);
    if (!is_allowed(p))
        document.fail(fmt::format("{} has {} elements of {} bytes, which mode {} with filter {} forbids",
                                  pointer, p.count, p.stride, p.mode, p.filter),
                      export_meshopt_again);
    // At their max_density the formats take two bits a 16-byte group of each byte of an element, and a byte a
    // triangle or an index: a sixty-fourth of what comes out, so that nothing is allocated for a lie.
    constexpr std::size_t max_density = 64;
    const std::size_t size = p.count * p.stride; // each below 2^31
    if (size > max_density * p.length)
        document.fail(fmt::format("{} claims to hold {} bytes in {}", pointer, size, p.length),
                      export_meshopt_again);
    document.values_read->add(size / sizeof(float)); // views may share their bytes
    std::vector<std::uint8_t> bytes(size);
    if (size > 0) decode(document, p, buffer->subspan(p.offset, p.length), bytes, pointer);
    return bytes;
}

/// Returns whether the view's own buffer has its bytes uncompressed, for readers without the extension.
bool has_fallback(const Document& document, const tinygltf::BufferView& view) {
    const auto& bytes = document.buffers[static_cast<std::size_t>(view.buffer)].bytes;
    return bytes && view.byteOffset <= bytes->size() && view.byteLength <= bytes->size() - view.byteOffset;
}

} // namespace

bool reads_meshopt() { return true; }

void unpack_meshopt(Document& document) {
    auto& views = document.model->bufferViews;
    for (std::size_t i = 0; i < views.size(); ++i) {
        for (const char* name : {"KHR_meshopt_compression", "EXT_meshopt_compression"}) {
            const json* object = extension(document.entry("bufferViews", static_cast<int>(i)), name);
            if (!object) continue;
            try {
                const std::string pointer = fmt::format("/bufferViews/{}/extensions/{}", i, name);
                std::vector<std::uint8_t> bytes = unpack(document, parse_packed(*object), pointer);
                views[i].byteOffset = 0;
                views[i].byteLength = bytes.size();
                views[i].buffer = document.add_buffer(std::move(bytes));
                break;
            } catch (const Error&) {
                if (!has_fallback(document, views[i])) throw;
            }
        }
    }
}

} // namespace sr::gltf
#else

namespace sr::gltf {

bool reads_meshopt() { return false; }
void unpack_meshopt(Document&) {}

} // namespace sr::gltf
#endif
