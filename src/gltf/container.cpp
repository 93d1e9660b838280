#include "gltf/container.hpp"

#include "core/error.hpp"
#include "core/json.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

constexpr std::uint32_t glb_magic = 0x46546C67;  // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t bin_chunk = 0x004E4942;  // "BIN\0"
constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

constexpr const char* remedy = "copy or export the file again";

// GLB is little-endian whatever the machine is.
std::uint32_t word(Bytes bytes, std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8
           | static_cast<std::uint32_t>(bytes[offset + 2]) << 16
           | static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

std::string_view text(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// The specification pads with spaces; some exporters pad with zeros.
std::string_view without_zeros(std::string_view json) {
    const auto last = json.find_last_not_of('\0');
    return json.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

Bytes checked_glb(Bytes file, const std::string& name) {
    if (file.size() < header_size) throw Error({name}, "the GLB ends within its header", remedy);
    const std::uint32_t version = word(file, 4);
    if (version != 2)
        throw Error({name}, fmt::format("GLB version {} is not supported", version),
                    "convert the file to glTF 2.0");
    const std::uint32_t length = word(file, 8);
    if (length > file.size())
        throw Error(
            {name},
            fmt::format("the GLB says it is {} bytes long, and only {} are here", length, file.size()),
            remedy);
    return file.first(length);
}

struct Chunk {
    std::uint32_t type = 0;
    Bytes data;
};

Chunk chunk_at(Bytes glb, std::size_t offset, const std::string& name) {
    if (glb.size() - offset < chunk_header_size)
        throw Error({name}, fmt::format("the GLB ends within the chunk header at byte {}", offset), remedy);
    const std::size_t length = word(glb, offset);
    const Bytes rest = glb.subspan(offset + chunk_header_size);
    if (length > rest.size())
        throw Error({name},
                    fmt::format("the GLB chunk at byte {} says it is {} bytes long, and only {} are left",
                                offset, length, rest.size()),
                    remedy);
    return {word(glb, offset + 4), rest.first(length)};
}

Container split_glb(Bytes glb, const std::string& name) {
    if (glb.size() < header_size + chunk_header_size) throw Error({name}, "the GLB has no chunk", remedy);
    const Chunk first = chunk_at(glb, header_size, name);
    if (first.type != json_chunk) throw Error({name}, "the first chunk of the GLB is not JSON", remedy);

    Container container{without_zeros(text(first.data)), std::nullopt, header_size + chunk_header_size, {}};
    const std::size_t second = container.json_offset + first.data.size();
    container.chunks = glb.subspan(second);
    // Up to three bytes of padding may be left; chunks of unknown types are ignored, as the specification
    // says.
    if (glb.size() - second < 4) return container;
    const Chunk chunk = chunk_at(glb, second, name);
    if (chunk.type == bin_chunk) container.bin = chunk.data;
    return container;
}

} // namespace

Container split_container(Bytes file, const std::string& name) {
    if (file.empty()) throw Error({name}, "the file is empty", remedy);
    if (file.size() >= 4 && word(file, 0) == glb_magic) return split_glb(checked_glb(file, name), name);
    return {text(file), std::nullopt, 0, {}};
}

std::vector<std::uint8_t> build_glb(std::string json, Bytes chunks) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::vector<std::uint8_t> glb;
    const auto append = [&](std::size_t value) {
        for (int i = 0; i < 4; ++i) glb.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    append(glb_magic);
    append(2); // version
    append(header_size + chunk_header_size + json.size() + chunks.size());
    append(json.size());
    append(json_chunk);
    glb.insert(glb.end(), json.begin(), json.end());
    glb.insert(glb.end(), chunks.begin(), chunks.end());
    return glb;
}

namespace {

using nlohmann::json;

constexpr int max_depth = 128;

// nlohmann's text is "[json.exception…] parse error at line 3, column 5: <what>"; `what` may quote the file's
// bytes.
std::string description(const std::exception& error) {
    std::string text = error.what();
    const auto column = text.find("column ");
    const auto colon = column == std::string::npos ? text.find("] ") : text.find(": ", column);
    if (colon != std::string::npos) text.erase(0, colon + 2);
    constexpr std::size_t max_size = 160;
    if (text.size() > max_size) text = text.substr(0, max_size) + "…";
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
}

[[noreturn]] void fail(const JsonError& error, const Container& container, const std::string& name) {
    if (error.kind == JsonError::Kind::nesting)
        throw Error({name}, fmt::format("the JSON is nested deeper than {} levels", max_depth),
                    "flatten the extras or extensions that do so");
    const Location place = location_of(error.byte, container.json, name);
    if (container.json_offset == 0)
        throw Error(place,
                    fmt::format("{} ({})",
                                error.kind == JsonError::Kind::syntax ? "this is not valid JSON"
                                                                      : "the JSON cannot be read",
                                description(error)),
                    "correct it, or export the file again");
    throw Error(
        {name},
        fmt::format("the GLB's JSON is broken at byte {} of the file (line {}, column {} of the JSON; {})",
                    container.json_offset + error.byte, place.line, place.column, description(error)),
        "export the file again");
}

template<class Json>
Json parse_as(const Container& container, const std::string& name) {
    try {
        Json root = parse_json<Json>(container.json, max_depth, name);
        if (!root.is_object()) throw Error({name}, "the JSON is not an object", "give a glTF 2.0 file");
        return root;
    } catch (const JsonError& error) {
        fail(error, container, name);
    }
}

} // namespace

json parse(const Container& container, const std::string& name) { return parse_as<json>(container, name); }

nlohmann::ordered_json parse_ordered(const Container& container, const std::string& name) {
    return parse_as<nlohmann::ordered_json>(container, name);
}

} // namespace sr::gltf
