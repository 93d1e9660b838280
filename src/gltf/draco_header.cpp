#include "gltf/draco_header.hpp"

#include <algorithm>
#include <array>

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

constexpr int deepest = 32;

/// Names and values, and metadata within.
bool skip_metadata(Reader& reader, int depth) {
    if (depth > deepest) return false;
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

} // namespace

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

} // namespace sr::gltf
